// Bells with random centres, heights and widths; the same seed gives the same bells on every platform.
//
//   m(x) = 1 + sum_i A_i sech^2( B_i |x - c_i|^2 )
//
//   A_i = A a_i,   1/4 <= a_i <= 1
//   B_i = B b_i,   1/2 <= b_i <= 2
//   c_i uniformly distributed over the domain
#include "core/monitor/geodesic.hpp"
#include "core/monitor/radial.hpp"
#include "core/monitor/random.hpp"
#include "core/monitor/sum.hpp"

namespace gaspard {

namespace {

std::shared_ptr<const Monitor> make_random_bells(const Values& values, const MonitorContext& context) {
    const Space& space = context.space;
    std::mt19937_64 random(static_cast<std::uint64_t>(values.integer("seed")));
    std::vector<std::shared_ptr<const Monitor>> bells;
    for (std::int64_t i = 0; i < values.integer("count"); ++i) {
        const double amplitude = values.real("amplitude") * (0.25 + 0.75 * uniform(random));
        const double sharpness = values.real("sharpness") * std::exp2(2 * uniform(random) - 1);
        const double u = uniform(random), v = uniform(random);
        if (space.kind == SpaceKind::sphere) {
            bells.push_back(std::make_shared<GeodesicMonitor<SechProfile>>(
                1.0, SechProfile{amplitude, sharpness, 0}, std::vector{direction_from(u, v)}));
        } else {
            bells.push_back(std::make_shared<SechMonitor>(
                SechMonitor::Parameters{amplitude, sharpness, 0, {u, v, 0}}, space));
        }
    }
    return std::make_shared<SumMonitor>(std::move(bells));
}

} // namespace

MonitorType random_bells_monitor() {
    return {.name = "random-bells",
            .label = "Random bells",
            .help = "small cells around random points, determined by a seed",
            .equation = "m(x) = 1 + Σᵢ Aᵢ sech²( Bᵢ |x - cᵢ|² )",
            .figure = MonitorFigure::unit_square,
            .rows =
                [](const Space& space) {
                    const bool sphere = space.kind == SpaceKind::sphere;
                    ParameterRow amplitude = amplitude_row(5000, 50, "at the centres");
                    amplitude.minimum = 0;
                    amplitude.help = "upper bound of the heights Aᵢ; each is at least A/4";
                    ParameterRow sharpness = sharpness_row(sphere ? 10.0 : 100.0, "0.94 / sqrt(B)",
                                                           sphere ? "1/radian²" : "1/length²");
                    sharpness.help = "larger is narrower; each Bᵢ is between B/2 and 2 B";
                    return std::vector<ParameterRow>{seed_row("centres, heights and widths"),
                                                     {.key = "count",
                                                      .label = "Number of bells",
                                                      .kind = ParameterKind::integer,
                                                      .minimum = 1,
                                                      .maximum = 100,
                                                      .default_value = std::int64_t{8},
                                                      .help = "number of bells"},
                                                     amplitude,
                                                     sharpness};
                },
            .make = make_random_bells};
}

} // namespace gaspard
