#include "gui/document/path_drawing.hpp"

#include "core/scenario/time_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr double rest = 0.04;     // seconds between places of a path, at least
constexpr double shortest = 0.3;  // seconds of a path
constexpr double steps = 200;     // of the time
constexpr double precision = 1e4; // places are rounded to 1 / precision of a unit

/// The image of a periodic coordinate that is nearest to the one before.
double nearest_image(const ParameterRow& row, double value, double before) {
    const double period = row.maximum - row.minimum;
    return row.periodic ? value + period * std::round((before - value) / period) : value;
}

double rounded(double value) { return std::round(value * precision) / precision; }

} // namespace

void PathDrawing::add(const Scenario& scenario, const std::string& first, double seconds) {
    const Values& monitor = scenario.monitor.values;
    const MovingPoint point_of_monitor = moving_point(monitor);
    const auto [one, other] = point_of_monitor;
    if (!armed_ || !point_of_monitor || one->key != first) return;
    if (path_.empty()) begin_ = seconds;
    PathPoint point{rounded(seconds - begin_), monitor.real(one->key), monitor.real(other->key)};
    if (!path_.empty()) {
        if (point.t < path_.back().t + rest) return;
        point.first = nearest_image(*one, point.first, path_.back().first);
        point.second = nearest_image(*other, point.second, path_.back().second);
    }
    path_.push_back({point.t, rounded(point.first), rounded(point.second)});
}

std::optional<Scenario> PathDrawing::finish(const Catalogue& catalogue, const Scenario& before) {
    armed_ = false;
    const std::vector<PathPoint> path = std::exchange(path_, {});
    if (path.size() < 2 || path.back().t < shortest) return std::nullopt;
    Scenario scenario = before;
    const auto [one, other] = moving_point(before.monitor.values);
    for (const ParameterRow* row : {one, other})
        scenario.time.set(std::string(moving_prefix) + row->key, std::string());
    scenario.time.set("path", write_path(path));
    scenario.time.set("start", 0.0);
    scenario.time.set("speed", 1.0); // the units of the path's t are seconds
    scenario.time.set("end", path.back().t);
    scenario.time.set("step", std::max(rounded(path.back().t / steps), 1 / precision));
    update_rows(catalogue, scenario);
    return scenario;
}

} // namespace gaspard
