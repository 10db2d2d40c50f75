// The monitor of McRae, Cotter, Budd (5.10), after Ringler et al. (2011), for meshes whose cells are N times
// larger outside a disc than inside it:
//
//   m(x) = sqrt( (1 - gamma)/2 (tanh((beta - |x - c|)/alpha) + 1) + gamma ),   gamma = 1/N^4
//
// gamma is inside the root, in agreement with the limit sqrt(gamma) stated in the text of the paper.
#include "core/monitor/geodesic.hpp"

#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

struct StepProfile {
    double gamma, alpha, beta;

    /// (tanh z + 1) / 2 for z = (beta - d) / alpha.
    double step(double d) const {
        const double t = 2 * (d - beta) / alpha, e = exponential(-std::abs(t));
        return (t > 0 ? e : 1.0) / (1 + e);
    }
    double value(double d) const { return std::sqrt((1 - gamma) * step(d) + gamma); }
    double slope(double d) const {
        const double s = step(d);
        return -(1 - gamma) * s * (1 - s) / (alpha * value(d));
    }
    void check() const {} // the ranges of the rows ensure m > 0
};

} // namespace

MonitorType x_n_monitor() {
    return {.name = "x-n",
            .label = "Xₙ",
            .help = "small cells in a disc on the sphere, N times larger outside",
            .equation =
                "m(x) = sqrt( (1 - γ)/2 (tanh((β - |x - c|)/α) + 1) + γ ), γ = 1/N⁴",
            .spaces = {SpaceKind::sphere},
            .rows =
                [](const Space&) {
                    std::vector<ParameterRow> rows = {
                        {.key = "ratio",
                         .label = "Ratio",
                         .symbol = "N",
                         .minimum = 1,
                         .maximum = 64,
                         .scale = ParameterScale::logarithmic,
                         .default_value = 2.0,
                         .help = "ratio of the edge lengths outside to those inside; 2, 4, 8, 16 in the "
                                 "paper"},
                        {.key = "alpha",
                         .label = "Width",
                         .symbol = "α",
                         .unit = "radians",
                         .minimum = 0.01,
                         .maximum = 2,
                         .scale = ParameterScale::logarithmic,
                         .default_value = std::numbers::pi / 20,
                         .help = "width of the transition between inside and outside"},
                        {.key = "beta",
                         .label = "Radius",
                         .symbol = "β",
                         .unit = "radians",
                         .minimum = 0,
                         .maximum = std::numbers::pi,
                         .default_value = std::numbers::pi / 6,
                         .help = "radius of the inner disc"}};
                    for (auto& row : place_rows("center", "Centre", 30, 0)) rows.push_back(std::move(row));
                    return rows;
                },
            .make = [](const Values& v, const MonitorContext&) -> std::shared_ptr<const Monitor> {
                const StepProfile profile{std::pow(v.real("ratio"), -4), v.real("alpha"), v.real("beta")};
                return std::make_shared<GeodesicMonitor<StepProfile>>(0.0, profile,
                                                                      std::vector{place_of(v, "center")});
            },
            .formula =
                [](const Space& space) {
                    return "sqrt((1 - ratio^-4)/2*(tanh((beta - " + distance_formula(space) +
                           ")/alpha) + 1) + ratio^-4)";
                }};
}

} // namespace gaspard
