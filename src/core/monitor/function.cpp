#include "core/monitor/function.hpp"

#include "core/base/check.hpp"

#include <cmath>
#include <utility>

namespace gaspard {

namespace {

class FunctionMonitor final : public Monitor {
  public:
    FunctionMonitor(std::function<double(Vec3)> function, Space space)
        : function_(std::move(function)), space_(space) {
        if (!function_) throw InputError("function_monitor: the function is empty");
    }

    void values(const Points& x, std::span<double> values) const override {
        GASPARD_CHECK(values.size() == x.size());
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = at(x[i]);
    }

    void gradients(const Points& x, Points& gradients) const override {
        gradients.resize(x.size());
        for (std::size_t i = 0; i < x.size(); ++i)
            gradients.set(
                i, {slope(x[i], {1, 0, 0}), slope(x[i], {0, 1, 0}), flat() ? 0 : slope(x[i], {0, 0, 1})});
    }

    void check() const override {} // values() checks each value

    std::optional<SpaceKind> made_for() const override { return space_.kind; }

  private:
    static constexpr double difference = 1e-5; // truncation and rounding error are both about 1e-10

    bool flat() const { return space_.kind == SpaceKind::periodic_square; }

    /// Central difference in the direction of an axis. On a sphere, the points are projected onto the sphere,
    /// so that this is the component of the tangential gradient.
    double slope(Vec3 p, Vec3 axis) const {
        const bool round = space_.kind == SpaceKind::sphere;
        const double radius = norm(p), step = round ? difference * radius : difference;
        const auto there = [&](Vec3 q) { return round ? (radius / norm(q)) * q : q; };
        return (at(there(p + step * axis)) - at(there(p - step * axis))) / (2 * step);
    }

    static double wrap(double x) {
        const double rest = x - std::floor(x);
        return rest < 1 ? rest : 0; // for x just below 0, x - floor(x) rounds to 1
    }

    double at(Vec3 p) const {
        if (flat()) p = {wrap(p.x), wrap(p.y), 0};
        const double value = function_(p);
        if (!(value > 0) || !std::isfinite(value))
            throw InputError("the monitor must be positive and finite, but is " + format_number(value) +
                             " at (" + format_number(p.x) + ", " + format_number(p.y) + ", " +
                             format_number(p.z) + ")");
        return value;
    }

    std::function<double(Vec3)> function_;
    Space space_;
};

} // namespace

std::shared_ptr<const Monitor> function_monitor(std::function<double(Vec3)> function, Space space) {
    return std::make_shared<FunctionMonitor>(std::move(function), space);
}

} // namespace gaspard
