#include "core/scenario/clock.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/base/number_text.hpp"
#include "core/base/short_number.hpp"
#include "core/function/expression.hpp"
#include "core/scenario/time_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

std::string at_time(double t) { return " at t = " + short_number(t, 6); }

/// Into the range of a periodic parameter.
double wrapped(const ParameterRow& row, double value) {
    if (!row.periodic) return value;
    const double period = row.maximum - row.minimum;
    const double inside = value - period * std::floor((value - row.minimum) / period);
    return std::clamp(inside, row.minimum, row.maximum); // rounding may leave it
}

const ParameterRow& row_of(const Values& values, const std::string& key) {
    const auto row = std::ranges::find(values.rows(), key, &ParameterRow::key);
    GASPARD_CHECK(row != values.rows().end());
    return *row;
}

/// Cubic Hermite interpolation with harmonic means of the secants as slopes (Fritsch, Butland, 1984), which
/// stays between the places; constant outside.
std::array<double, 3> on_path(const std::vector<PathPoint>& path,
                              const std::vector<std::array<double, 3>>& places, double t) {
    if (t <= path.front().t) return places.front();
    if (t >= path.back().t) return places.back();
    const auto after = std::ranges::upper_bound(path, t, {}, &PathPoint::t);
    const auto i = static_cast<std::size_t>(after - path.begin()) - 1;
    const double length = path[i + 1].t - path[i].t, s = (t - path[i].t) / length;
    std::array<double, 3> place{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto slope = [&](std::size_t j) {
            const auto secant = [&](std::size_t a) {
                return (places[a + 1][k] - places[a][k]) / (path[a + 1].t - path[a].t);
            };
            if (j == 0) return secant(0);
            if (j + 1 == path.size()) return secant(j - 1);
            const double to_here = secant(j - 1), from_here = secant(j);
            if (!(to_here * from_here > 0)) return 0.0;
            const double left = path[j].t - path[j - 1].t, right = path[j + 1].t - path[j].t;
            const double first = 2 * right + left, second = right + 2 * left;
            return (first + second) / (first / to_here + second / from_here);
        };
        const double a = places[i][k], b = places[i + 1][k];
        place[k] = a + s * s * (3 - 2 * s) * (b - a) +
                   length * s * (1 - s) * ((1 - s) * slope(i) - s * slope(i + 1));
    }
    return place;
}

} // namespace

/// Between two of them there must be a shortest way.
static void check_places_on_sphere(const std::vector<PathPoint>& path) {
    constexpr double farthest = 2.4; // radians; beyond, the way through the sphere is too uneven
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (std::abs(path[i].first) > 90)
            throw InputError("time.path has the latitude " + short_number(path[i].first) +
                             ", which must be −90 to 90");
        if (i > 0 && angle_between(at_latitude_longitude(path[i - 1].first, path[i - 1].second),
                                   at_latitude_longitude(path[i].first, path[i].second)) > farthest)
            throw InputError("time.path has places far apart on the sphere" + at_time(path[i].t) +
                             "; add places between them");
    }
}

/// A parameter as a function of t.
struct Clock::Motion {
    std::string key; ///< in the monitor
    Expression expression;
    std::vector<std::string> others; ///< the parameters of the formula; "t" is the time
};

std::vector<PathPoint> parse_path(const std::string& text) {
    std::vector<PathPoint> path;
    const auto refuse = [](const std::string& what) {
        throw InputError("time.path " + what +
                         "; write \"t x y; t x y; ...\", on a sphere \"t latitude "
                         "longitude; ...\"");
    };
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(';', begin), text.size());
        const std::string part = text.substr(begin, end - begin);
        begin = end + 1;
        if (part.find_first_not_of(" \t\n") == std::string::npos) continue;
        std::vector<double> numbers;
        try {
            numbers = parse_numbers(part, "time.path");
        } catch (const InputError&) {
            refuse("has '" + part + "', which is not three numbers");
        }
        if (numbers.size() != 3) refuse("has '" + part + "', which is not three numbers");
        if (!path.empty() && !(numbers[0] > path.back().t))
            refuse("must have times that increase, not " + format_number(path.back().t) + " and then " +
                   format_number(numbers[0]));
        path.push_back({numbers[0], numbers[1], numbers[2]});
    }
    if (path.size() == 1) refuse("has one place; it needs two or more");
    return path;
}

std::string write_path(const std::vector<PathPoint>& path) {
    std::string text;
    for (const PathPoint& point : path)
        text += (text.empty() ? "" : "; ") + format_number(point.t) + ' ' + format_number(point.first) + ' ' +
                format_number(point.second);
    return text;
}

Clock::Clock(Scenario scenario, int moments)
    : scenario_(std::move(scenario)), start_(scenario_.time.real("start")), end_(scenario_.time.real("end")),
      step_(scenario_.time.real("step")) {
    GASPARD_CHECK(end_ > start_);
    const double count = std::ceil((end_ - start_) / step_ * (1 - 1e-12));
    if (!(count <= most_steps))
        throw InputError("time.step = " + format_number(step_) + " makes more than " +
                         std::to_string(most_steps) + " steps from " + format_number(start_) + " to " +
                         format_number(end_));
    steps_ = std::max(1, static_cast<int>(count));
    const double largest = std::max(std::abs(start_), std::abs(end_));
    if (!(step_ > 1e-11 * largest))
        throw InputError("time.step = " + short_number(step_) + " is too small for times of the size of " +
                         short_number(largest));
    const Values& monitor = scenario_.monitor.values;
    for (const ParameterRow& row : monitor.rows())
        if (row.role == ParameterRole::time) times_.push_back(row.key);
    for (const ParameterRow& row : scenario_.time.rows()) {
        if (row.role != ParameterRole::motion || scenario_.time.text(row.key).empty()) continue;
        const std::string full_key = "time." + row.key;
        try {
            Expression expression(scenario_.time.text(row.key), Space{});
            if (expression.uses_plane() || expression.uses_z())
                throw ExpressionError("the value must not depend on x, y or z");
            const std::vector<std::string> names = expression.parameters();
            for (const std::string& name : names)
                if (name != "t" && !(monitor.has(name) && row_of(monitor, name).kind == ParameterKind::real))
                    throw ExpressionError("'" + name + "' is not t, nor a parameter of the monitor");
            motions_.push_back({row.key.substr(moving_prefix.size()), std::move(expression), names});
        } catch (const ExpressionError& error) {
            throw InputError(full_key + ": " + error.what());
        }
    }
    path_ = parse_path(scenario_.time.text("path"));
    if (!path_.empty()) take_path();
    Values values = scenario_.monitor.values;
    const int checked = std::min(moments, steps_ + 1);
    for (int i = 0; i < checked; ++i) {
        const double part = i == 0 ? 0 : static_cast<double>(i) / (checked - 1);
        move(values, time(static_cast<int>(std::lround(part * steps_))));
    }
}

Clock::~Clock() = default;

/// Which point goes along the path.
void Clock::take_path() {
    const MovingPoint point = moving_point(scenario_.monitor.values);
    if (!point)
        throw InputError("time.path moves a point, and monitor '" + scenario_.monitor.type + "' has none");
    on_sphere_ = point.on_sphere();
    if (on_sphere_) check_places_on_sphere(path_);
    first_key_ = point.first->key, second_key_ = point.second->key;
    for (const std::string& key : {first_key_, second_key_})
        if (const std::string motion = std::string(moving_prefix) + key; !scenario_.time.text(motion).empty())
            throw InputError("time.path and time." + motion + " both move the monitor; leave one empty");
}

MovingPoint moving_point(const Values& monitor) {
    const auto& rows = monitor.rows();
    if (const ParameterRow* latitude = find_role(rows, ParameterRole::latitude))
        return {latitude, find_role(rows, ParameterRole::longitude)};
    return {find_role(rows, ParameterRole::x), find_role(rows, ParameterRole::y)};
}

/// Without the rounding of the sum: 0.3, not 0.30000000000000004.
double Clock::time(int k) const {
    if (k >= steps_) return end_;
    const double sum = start_ + k * step_, size = std::max({std::abs(start_), std::abs(end_), step_});
    const double digits = std::pow(10, 13 - std::ceil(std::log10(size)));
    const double rounded = std::isfinite(digits) ? std::round(sum * digits) / digits : sum;
    return std::abs(rounded - sum) < 1e-6 * step_ ? rounded : sum;
}

int Clock::nearest(double t) const {
    const auto k =
        static_cast<int>(std::clamp(std::floor((t - start_) / step_), 0.0, static_cast<double>(steps_)));
    return k < steps_ && std::abs(time(k + 1) - t) < std::abs(time(k) - t) ? k + 1 : k;
}

std::string Clock::why_unused(std::string_view key) const {
    const auto used = [&](const Motion& motion) {
        return std::ranges::find(motion.others, key) != motion.others.end();
    };
    if (std::ranges::any_of(motions_, used)) return {};
    const std::string begin = "monitor." + std::string(key) + " has no effect while time passes: ";
    const auto moved = std::ranges::find(motions_, key, &Motion::key);
    if (moved != motions_.end())
        return begin + "time.monitor." + moved->key + " does not use '" + moved->key + "'";
    if (!path_.empty() && (key == first_key_ || key == second_key_)) return begin + "time.path sets it";
    if (std::ranges::find(times_, key) != times_.end()) return begin + "it is the time";
    return {};
}

Scenario Clock::at(double t) const {
    Scenario scenario = scenario_;
    move(scenario.monitor.values, t);
    return scenario;
}

void Clock::move(Values& values, double t) const {
    const Values& rest = scenario_.monitor.values;
    for (const std::string& key : times_) {
        try {
            values.set(key, t);
        } catch (const InputError& error) {
            throw InputError(std::string(error.what()) + at_time(t));
        }
    }
    if (!path_.empty()) move_along_path(values, t);
    Points origin(1);
    for (const Motion& motion : motions_) {
        std::vector<double> parameters;
        for (const std::string& name : motion.others) parameters.push_back(name == "t" ? t : rest.real(name));
        double value = 0;
        ExpressionFunction(motion.expression, parameters).values(origin, {}, {&value, 1});
        const ParameterRow& row = row_of(values, motion.key);
        const std::string key = "time." + std::string(moving_prefix) + motion.key;
        if (!std::isfinite(value)) throw InputError(key + " is not a finite number" + at_time(t));
        value = wrapped(row, value);
        if (!(value >= row.minimum && value <= row.maximum))
            throw InputError(key + " is " + short_number(value) + at_time(t) + "; monitor." + motion.key +
                             " must be " + describe_range(row));
        values.set(motion.key, value);
    }
}

void Clock::move_along_path(Values& values, double t) const {
    std::vector<std::array<double, 3>> places;
    for (const PathPoint& point : path_) {
        const Vec3 p = on_sphere_ ? at_latitude_longitude(point.first, point.second)
                                  : Vec3{point.first, point.second, 0};
        places.push_back({p.x, p.y, p.z});
    }
    const auto [x, y, z] = on_path(path_, places, t);
    constexpr double degrees = 180 / std::numbers::pi;
    const double first = on_sphere_ ? degrees * std::atan2(z, std::hypot(x, y)) : x,
                 second = on_sphere_ ? degrees * std::atan2(y, x) : y;
    const auto set = [&](const std::string& key, double value) {
        const ParameterRow& row = row_of(values, key);
        value = wrapped(row, value);
        if (!(value >= row.minimum && value <= row.maximum))
            throw InputError("time.path leads to monitor." + key + " = " + short_number(value) + at_time(t) +
                             ", which must be " + describe_range(row));
        values.set(key, value);
    };
    set(first_key_, first), set(second_key_, second);
}

std::shared_ptr<const Clock> make_clock(const Scenario& scenario) {
    return has_time(scenario.time) ? std::make_shared<const Clock>(scenario) : nullptr;
}

} // namespace gaspard
