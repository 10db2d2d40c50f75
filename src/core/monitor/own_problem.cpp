#include "core/monitor/own_problem.hpp"

#include "core/base/box.hpp"
#include "core/base/error.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

constexpr double difference = 1e-5; // truncation and rounding error are both about 1e-10
constexpr std::size_t samples = 64; // values from which the unit is chosen

// Squares and products of a few values of m are formed. From 2^-200 to 2^200 they cannot overflow, and m
// keeps its unit. Otherwise the unit is a power of two near m, at least 2^-1000: its reciprocal is finite.
constexpr int largest_exponent = 200, least_exponent = -1000;

bool is_finite(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

double wrap(double x) {
    const double rest = x - std::floor(x);
    return rest < 1 ? rest : 0; // for x just below 0, x - floor(x) rounds to 1
}

bool are_inside(const DomainExtent& extent, const Points& x) {
    bool all = true;
    for (std::size_t i = 0; i < x.size(); ++i) all = all && is_inside(extent, x[i]) && is_finite(x[i]);
    return all;
}

/// Points that are not finite, of an iteration that diverges, become another point of the domain.
Points into(const DomainExtent& extent, const Points& x) {
    Points inside(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        inside.set(i, is_finite(x[i]) ? into(extent, x[i]) : extent.somewhere);
    return inside;
}

class OwnMonitor final : public Monitor {
  public:
    OwnMonitor(std::shared_ptr<const Monitor> own, const DomainExtent& extent, double unit)
        : own_(std::move(own)), extent_(extent), scale_(1 / unit) {}

    void values(const Points& x, std::span<double> values) const override {
        if (are_inside(extent_, x)) { // most points of most meshes: no copy
            own_->values(x, values);
            check_positive(x, values);
        } else {
            const Points inside = into(extent_, x);
            own_->values(inside, values);
            check_positive(inside, values);
        }
        if (scale_ != 1)
            for (double& value : values) value *= scale_;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!is_finite(x[i])) values[i] = std::numeric_limits<double>::quiet_NaN();
    }
    void gradients(const Points& x, Points& gradients) const override {
        const Points inside = into(extent_, x);
        gradients.resize(0);
        own_->gradients(inside, gradients);
        if (gradients.size() == 0 && x.size() > 0) difference_gradients(*own_, extent_, inside, gradients);
        if (gradients.size() != x.size())
            throw InputError("the monitor has " + std::to_string(gradients.size()) + " gradients at " +
                             std::to_string(x.size()) + " points");
        for (auto* axis : {&gradients.x, &gradients.y, &gradients.z})
            for (double& value : *axis) value *= scale_;
    }
    void check() const override { own_->check(); }
    std::optional<SpaceKind> made_for() const override { return own_->made_for(); }
    std::optional<Vec3> symmetry_axis() const override { return own_->symmetry_axis(); }
    std::shared_ptr<const ScalarFunction> solution() const override { return own_->solution(); }
    std::vector<Field> fields(const Points& x) const override { return own_->fields(into(extent_, x)); }

  private:
    std::shared_ptr<const Monitor> own_;
    DomainExtent extent_;
    double scale_;
};

class StoppableMonitor final : public Monitor {
  public:
    StoppableMonitor(std::shared_ptr<const Monitor> whole, std::stop_token stop)
        : whole_(std::move(whole)), stop_(std::move(stop)) {}

    void values(const Points& x, std::span<double> values) const override {
        look();
        whole_->values(x, values);
        look();
    }
    void gradients(const Points& x, Points& gradients) const override {
        look();
        whole_->gradients(x, gradients);
    }
    void check() const override { whole_->check(); }
    std::optional<SpaceKind> made_for() const override { return whole_->made_for(); }
    std::optional<Vec3> symmetry_axis() const override { return whole_->symmetry_axis(); }
    std::shared_ptr<const ScalarFunction> solution() const override { return whole_->solution(); }
    std::vector<Field> fields(const Points& x) const override { return whole_->fields(x); }

  private:
    void look() const {
        if (stop_.stop_requested()) throw Interrupted();
    }

    std::shared_ptr<const Monitor> whole_;
    std::stop_token stop_;
};

/// The derivative along one axis at every point.
void differentiate(const Monitor& monitor, const DomainExtent& extent, const Points& x, Vec3 axis,
                   std::vector<double>& slope) {
    const double step = difference * extent.size;
    const std::size_t count = x.size();
    std::vector<double> side(count, 0.0), here, first(count),
        second(count); // side: of a one-sided difference
    Points a(count), b(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double radius = norm(x[i]);
        const bool round = extent.space.kind == SpaceKind::sphere;
        const double length = round && extent.radius == 0 ? difference * radius : step;
        if (extent.box && dot(axis, x[i] + length * axis - extent.high) > 0) side[i] = -1;
        if (extent.box && dot(axis, x[i] - length * axis - extent.low) < 0) side[i] = 1;
        const double to_a = side[i] != 0 ? side[i] : -1, to_b = side[i] != 0 ? 2 * side[i] : 1;
        const auto place = [&](Vec3 p) { return into(extent, round ? (radius / norm(p)) * p : p); };
        a.set(i, place(x[i] + to_a * length * axis));
        b.set(i, place(x[i] + to_b * length * axis));
    }
    monitor.values(a, first);
    check_positive(a, first);
    monitor.values(b, second);
    check_positive(b, second);
    if (std::any_of(side.begin(), side.end(), [](double one) { return one != 0; })) {
        here.resize(count);
        monitor.values(x, here);
        check_positive(x, here);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double length =
            extent.space.kind == SpaceKind::sphere && extent.radius == 0 ? difference * norm(x[i]) : step;
        slope[i] = side[i] != 0 ? side[i] * (-3 * here[i] + 4 * first[i] - second[i]) / (2 * length)
                                : (second[i] - first[i]) / (2 * length);
    }
}

/// A power of two near the values; 1 where their squares do not overflow.
double unit_of(const Monitor& monitor, const Points& nodes) {
    const std::size_t stride = std::max<std::size_t>(1, nodes.size() / samples);
    Points some;
    for (std::size_t i = 0; i < nodes.size(); i += stride) {
        some.resize(some.size() + 1);
        some.set(some.size() - 1, nodes[i]);
    }
    std::vector<double> values(some.size());
    monitor.values(some, values);
    const double largest = *std::max_element(values.begin(), values.end());
    const int exponent = std::max(least_exponent, std::ilogb(largest));
    return std::abs(exponent) > largest_exponent ? std::ldexp(1.0, exponent) : 1.0;
}

} // namespace

DomainExtent extent_of(const Mesh& mesh, const Space& space, bool box) {
    const Box around = bounding_box(mesh.nodes);
    DomainExtent extent{.space = space,
                        .dimension = mesh.space_dimension,
                        .box = box && space.kind == SpaceKind::euclidean,
                        .low = around.low,
                        .high = around.high,
                        .somewhere = mesh.nodes[0],
                        .size = longest_side(around)};
    if (space.kind == SpaceKind::sphere) extent.size = extent.radius = norm(mesh.nodes[0]);
    return extent;
}

Vec3 into(const DomainExtent& extent, Vec3 p) {
    if (extent.space.kind == SpaceKind::periodic_square) return {wrap(p.x), wrap(p.y), 0};
    if (extent.space.kind == SpaceKind::sphere) {
        const double length = norm(p);
        return extent.radius > 0 && length > 0 ? (extent.radius / length) * p : p;
    }
    if (extent.dimension < 3) p.z = 0;
    if (extent.dimension < 2) p.y = 0;
    if (!extent.box) return p;
    return {std::clamp(p.x, extent.low.x, extent.high.x), std::clamp(p.y, extent.low.y, extent.high.y),
            std::clamp(p.z, extent.low.z, extent.high.z)};
}

void check_positive(const Points& x, std::span<const double> values) {
    bool good = true; // a loop without branches
    for (const double value : values) good &= (value > 0) & (value <= std::numeric_limits<double>::max());
    for (std::size_t i = 0; !good && i < values.size(); ++i)
        if ((!(values[i] > 0) || !std::isfinite(values[i])) && std::isfinite(norm(x[i])))
            throw InputError("the monitor must be positive and finite, but is " + exact_number(values[i]) +
                             " at (" + exact_number(x.x[i]) + ", " + exact_number(x.y[i]) + ", " +
                             exact_number(x.z[i]) + ")");
}

void difference_gradients(const Monitor& monitor, const DomainExtent& extent, const Points& x,
                          Points& gradients) {
    gradients = Points(x.size());
    const bool flat = extent.space.kind == SpaceKind::periodic_square;
    const std::array<std::pair<Vec3, std::vector<double>*>, 3> axes{
        {{{1, 0, 0}, &gradients.x}, {{0, 1, 0}, &gradients.y}, {{0, 0, 1}, &gradients.z}}};
    const int count = flat ? 2 : extent.dimension;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(count); ++axis)
        differentiate(monitor, extent, x, axes[axis].first, *axes[axis].second);
}

ProblemData own_problem(std::shared_ptr<const Monitor> own, const DomainExtent& extent, const Points& nodes) {
    if (!own) throw InputError("the monitor is null");
    own->check();
    const double unit = unit_of(OwnMonitor(own, extent, 1), nodes);
    auto report = std::make_shared<const MonitorReport>(own->report());
    return {.monitor = std::make_shared<OwnMonitor>(std::move(own), extent, unit),
            .unit = unit,
            .report = std::move(report)};
}

ProblemData stoppable(ProblemData data, std::stop_token stop) {
    data.stop = stop;
    if (stop.stop_possible() && data.source)
        data.source = std::make_shared<StoppableMonitor>(std::move(data.source), stop);
    if (stop.stop_possible())
        data.monitor = std::make_shared<StoppableMonitor>(std::move(data.monitor), std::move(stop));
    return data;
}

} // namespace gaspard
