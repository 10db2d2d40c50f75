// The bell of McRae, Cotter, Budd (5.4).
#include "core/monitor/radial.hpp"

namespace gaspard {

MonitorType bell_monitor() {
    return {
        .name = "bell",
        .label = "Bell",
        .help = "small cells around a point",
        .equation = "m(x) = 1 + A sech^2( B |x - c|^2 )",
        .rows = {amplitude_row(5000, 50.0, "at the centre"), sharpness_row(100.0, "0.94 / sqrt(B)"),
                 center_row("center_x", "Centre x", "c1"), center_row("center_y", "Centre y", "c2")},
        .make = [](const Values& values, const Space& space) { return make_sech_monitor(values, 0, space); }};
}

} // namespace gaspard
