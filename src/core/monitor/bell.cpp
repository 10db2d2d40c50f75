// The bell of McRae, Cotter, Budd (5.4).
#include "core/monitor/radial.hpp"

namespace gaspard {

MonitorType bell_monitor() {
    return {.name = "bell",
            .label = "Bell",
            .help = "small cells around a point",
            .equation = "m(x) = 1 + A sech²( B |x - c|² )",
            .figure = MonitorFigure::unit_square,
            .rows =
                [](const Space& space) {
                    const bool sphere = space.kind == SpaceKind::sphere;
                    std::vector<ParameterRow> rows = {
                        amplitude_row(5000, sphere ? 20.0 : 50.0, "at the centre"),
                        sharpness_row(sphere ? 10.0 : 100.0, "0.94 / sqrt(B)",
                                      sphere ? "1/radian²" : "1/length²")};
                    for (auto& row : center_rows(space)) rows.push_back(std::move(row));
                    return rows;
                },
            .make = [](const Values& values,
                       const MonitorContext& context) { return make_sech_monitor(values, 0, context.space); },
            .formula =
                [](const Space& space) {
                    return "1 + amplitude*sech(sharpness*" + distance_formula(space) + "^2)^2";
                }};
}

} // namespace gaspard
