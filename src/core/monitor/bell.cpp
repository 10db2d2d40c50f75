// The bell of McRae, Cotter, Budd (5.4).
#include "core/monitor/radial.hpp"

namespace gaspard {

MonitorType bell_monitor() {
    return {.name = "bell",
            .label = "Bell",
            .help = "small cells around a point",
            .equation = "m(x) = 1 + A sech^2( B |x - c|^2 )",
            .rows = {{.key = "amplitude",
                      .label = "Amplitude",
                      .symbol = "A",
                      .minimum = -0.99,
                      .maximum = 5000,
                      .scale = ParameterScale::logarithmic,
                      .default_value = 50.0,
                      .help = "how much denser the mesh is at the centre; the monitor would vanish at -1"},
                     {.key = "sharpness",
                      .label = "Sharpness",
                      .symbol = "B",
                      .unit = "1/length^2",
                      .minimum = 1,
                      .maximum = 2000,
                      .scale = ParameterScale::logarithmic,
                      .default_value = 100.0,
                      .help = "larger is narrower: half the height at a distance of about 0.94 / sqrt(B)"},
                     center_row("center_x", "Centre x", "c1"),
                     center_row("center_y", "Centre y", "c2")},
            .make = [](const Values& v, const Space& space) -> std::shared_ptr<const Monitor> {
                return std::make_shared<SechMonitor>(
                    SechMonitor::Parameters{v.real("amplitude"),
                                            v.real("sharpness"),
                                            0.0,
                                            {v.real("center_x"), v.real("center_y"), 0}},
                    space);
            }};
}

} // namespace gaspard
