// The ring of McRae, Cotter, Budd (5.3).
#include "core/monitor/radial.hpp"

#include <numbers>

namespace gaspard {

MonitorType ring_monitor() {
    return {.name = "ring",
            .label = "Ring",
            .help = "small cells along a circle",
            .equation = "m(x) = 1 + A sech²( B (|x - c|² - r²) )",
            .figure = MonitorFigure::unit_square,
            .rows =
                [](const Space& space) {
                    const bool sphere = space.kind == SpaceKind::sphere;
                    std::vector<ParameterRow> rows = {amplitude_row(1000, 10.0, "on the ring"),
                                                      sharpness_row(sphere ? 10.0 : 200.0, "0.44 / (B r)",
                                                                    sphere ? "1/radian²" : "1/length²"),
                                                      {.key = "radius",
                                                       .label = "Radius",
                                                       .symbol = "r",
                                                       .unit = sphere ? "radians" : "length",
                                                       .minimum = 0,
                                                       .maximum = sphere ? std::numbers::pi : 0.5,
                                                       .default_value = sphere ? std::numbers::pi / 4 : 0.25,
                                                       .help = "radius of the ring"}};
                    for (auto& row : center_rows(space)) rows.push_back(std::move(row));
                    return rows;
                },
            .make =
                [](const Values& values, const MonitorContext& context) {
                    return make_sech_monitor(values, values.real("radius"), context.space);
                },
            .formula =
                [](const Space& space) {
                    return "1 + amplitude*sech(sharpness*(" + distance_formula(space) + "^2 - radius^2))^2";
                }};
}

} // namespace gaspard
