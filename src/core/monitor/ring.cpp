// The ring of McRae, Cotter, Budd (5.3).
#include "core/monitor/radial.hpp"

namespace gaspard {

MonitorType ring_monitor() {
    return {.name = "ring",
            .label = "Ring",
            .help = "small cells along a circle",
            .equation = "m(x) = 1 + A sech^2( B (|x - c|^2 - r^2) )",
            .rows = {amplitude_row(1000, 10.0, "on the ring"),
                     sharpness_row(200.0, "0.44 / (B r)"),
                     {.key = "radius",
                      .label = "Radius",
                      .symbol = "r",
                      .unit = "length",
                      .minimum = 0,
                      .maximum = 0.5,
                      .default_value = 0.25,
                      .help = "of the ring"},
                     center_row("center_x", "Centre x", "c1"),
                     center_row("center_y", "Centre y", "c2")},
            .make = [](const Values& values, const Space& space) {
                return make_sech_monitor(values, values.real("radius"), space);
            }};
}

} // namespace gaspard
