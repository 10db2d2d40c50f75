// Monitors made of a solution u(x, t) of Burgers' equation on (0, 1) (flow/burgers.hpp), which is computed:
//
//   m(x) = sqrt( 1 + (alpha u_x)^2 )
//
// Between the nodes of its own mesh u is a cubic, with slopes at the nodes of the parabola through three
// neighbours; beside (0, 1) it is constant.
#include "core/flow/burgers_history.hpp"
#include "core/monitor/monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace gaspard {

namespace {

class BurgersSolution final : public ScalarFunction {
  public:
    /// The nodes, followed by the values.
    explicit BurgersSolution(const std::vector<double>& state)
        : x_(state.begin(), state.begin() + static_cast<std::ptrdiff_t>(state.size() / 2)),
          u_(state.begin() + static_cast<std::ptrdiff_t>(state.size() / 2), state.end()), slopes_(x_.size()) {
        const std::size_t n = x_.size() - 1;
        const auto secant = [&](std::size_t k) { return (u_[k + 1] - u_[k]) / (x_[k + 1] - x_[k]); };
        slopes_[0] = secant(0), slopes_[n] = secant(n - 1);
        for (std::size_t i = 1; i < n; ++i) {
            const double left = x_[i] - x_[i - 1], right = x_[i + 1] - x_[i];
            slopes_[i] = (right * secant(i - 1) + left * secant(i)) / (left + right);
        }
    }

    /// u and its first two derivatives; NaN where x is not finite.
    struct Jet {
        double u, slope, curvature;
    };
    Jet at(double x) const {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        if (!std::isfinite(x)) return {none, none, none};
        if (x < x_.front()) return {u_.front(), 0, 0};
        if (x > x_.back()) return {u_.back(), 0, 0};
        const auto after = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
        const auto k = static_cast<std::size_t>(after - x_.begin()) - 1;
        const double h = x_[k + 1] - x_[k], s = (x - x_[k]) / h, secant = (u_[k + 1] - u_[k]) / h;
        const double c = 3 * secant - 2 * slopes_[k] - slopes_[k + 1],
                     d = slopes_[k] + slopes_[k + 1] - 2 * secant;
        return {u_[k] + h * s * (slopes_[k] + s * (c + s * d)), slopes_[k] + s * (2 * c + 3 * s * d),
                (2 * c + 6 * s * d) / h};
    }

    void values(const Points& x, std::span<double> values) const override {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = at(x.x[i]).u;
    }
    void gradients(const Points& x, Points& gradients) const override {
        gradients = Points(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) gradients.x[i] = at(x.x[i]).slope;
    }

  private:
    std::vector<double> x_, u_, slopes_;
};

FieldInfo burgers_field() { return {.name = "u", .label = "u", .help = "the solution of Burgers' equation"}; }

class BurgersMonitor final : public Monitor {
  public:
    BurgersMonitor(std::shared_ptr<const BurgersSolution> u, double alpha)
        : u_(std::move(u)), alpha_(alpha) {}

    void values(const Points& x, std::span<double> values) const override {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = std::hypot(1, alpha_ * u_->at(x.x[i]).slope);
    }
    void gradients(const Points& x, Points& gradients) const override {
        gradients = Points(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            const BurgersSolution::Jet jet = u_->at(x.x[i]);
            gradients.x[i] = alpha_ * alpha_ * jet.slope * jet.curvature / std::hypot(1, alpha_ * jet.slope);
        }
    }
    std::shared_ptr<const ScalarFunction> solution() const override { return u_; }
    std::vector<Field> fields(const Points& x) const override {
        Field u{burgers_field(), std::vector<double>(x.size())};
        u_->values(x, u.values);
        return {std::move(u)};
    }

  private:
    std::shared_ptr<const BurgersSolution> u_;
    double alpha_;
};

std::vector<ParameterRow> burgers_rows(const Space&) {
    return {{.key = "t",
             .label = "Time",
             .symbol = "t",
             .minimum = 0,
             .maximum = 1e3,
             .slider = SliderRange{0, 2},
             .default_value = 0.0,
             .help = "of the solution; the clock sets it while time passes",
             .role = ParameterRole::time},
            {.key = "start",
             .label = "Start",
             .kind = ParameterKind::choice,
             .default_value = std::string("front"),
             .choices = {"front", "sine"},
             .help =
                 "front: an exact solution that travels with speed 1/2; sine: sin(2πx) + sin(πx)/2, which "
                 "steepens",
             .role = ParameterRole::defines_rows},
            {.key = "nu",
             .label = "Viscosity",
             .symbol = "ν",
             .minimum = 2e-4,
             .maximum = 1,
             .scale = ParameterScale::logarithmic,
             .slider = SliderRange{1e-3, 0.1},
             .default_value = 0.005,
             .help = "a front is about 8 ν wide",
             .of_all_times = true},
            {.key = "alpha",
             .label = "Intensity",
             .symbol = "α",
             .minimum = 1e-3,
             .maximum = 1e3,
             .scale = ParameterScale::logarithmic,
             .slider = SliderRange{0.1, 10},
             .default_value = 1.0,
             .help = "factor of the slope; 1: about half of the cells go to a front of height 1"},
            {.key = "cells",
             .label = "Cells of the solution",
             .symbol = "n",
             .kind = ParameterKind::integer,
             .minimum = 50,
             .maximum = 1000,
             .default_value = std::int64_t{200},
             .help = "of the adapted mesh on which u is computed",
             .detail = true}};
}

std::vector<ParameterRow> further_burgers_rows(const Values& values, const Space&) {
    if (values.text("start") != "front") return {};
    return {{.key = "x0",
             .label = "Front at t = 0",
             .symbol = "x₀",
             .minimum = -1,
             .maximum = 1,
             .default_value = 0.2,
             .help = "where u = 1/2",
             .of_all_times = true}};
}

std::shared_ptr<const Checkpoints> burgers_history_of(const Values& values, const DataContext& context) {
    const double nu = values.real("nu");
    const std::function<std::shared_ptr<const Checkpoints>()> make = [&] {
        return burgers_history({.cells = static_cast<std::size_t>(values.integer("cells")), .nu = nu},
                               values.text("start") == "front" ? burgers_front(nu, values.real("x0"))
                                                               : burgers_sine());
    };
    if (!context.files) return make();
    std::string name = "burgers";
    for (const char* key : {"start", "nu", "cells", "x0"})
        if (values.has(key)) name += ' ' + format_value(values.at(key));
    return context.files->get<Checkpoints>("", name, make,
                                           [](const Checkpoints& states) { return states.budget(); });
}

std::shared_ptr<const Monitor> make_burgers(const Values& values, const MonitorContext& context) {
    const auto report = [&](double done) {
        if (context.progress) context.progress(done, "Solving Burgers' equation");
    };
    const std::vector<double> state =
        burgers_history_of(values, context)->at(values.real("t"), report, context.stop);
    return std::make_shared<BurgersMonitor>(std::make_shared<BurgersSolution>(state), values.real("alpha"));
}

} // namespace

MonitorType burgers_monitor_type() {
    return {.name = "burgers",
            .label = "Burgers' equation",
            .help =
                "small cells in the fronts of u(x, t) on (0, 1), which is computed; it moves with the clock",
            .equation = "m(x, t) = sqrt(1 + (α u_x)²), u_t + u u_x = ν u_xx",
            .spaces = {SpaceKind::euclidean},
            .solids = false,
            .rows = burgers_rows,
            .make = make_burgers,
            .further_rows = further_burgers_rows,
            .fields = {burgers_field()}};
}

} // namespace gaspard
