// The ring of McRae, Cotter, Budd (5.3).
#include "core/monitor/radial.hpp"

namespace gaspard {

MonitorType ring_monitor() {
    return {.name = "ring",
            .label = "Ring",
            .help = "small cells along a circle",
            .equation = "m(x) = 1 + A sech^2( B (|x - c|^2 - r^2) )",
            .rows = {{.key = "amplitude",
                      .label = "Amplitude",
                      .symbol = "A",
                      .minimum = -0.99,
                      .maximum = 1000,
                      .scale = ParameterScale::logarithmic,
                      .default_value = 10.0,
                      .help = "how much denser the mesh is on the ring; the monitor would vanish at -1"},
                     {.key = "sharpness",
                      .label = "Sharpness",
                      .symbol = "B",
                      .unit = "1/length^2",
                      .minimum = 1,
                      .maximum = 2000,
                      .scale = ParameterScale::logarithmic,
                      .default_value = 200.0,
                      .help = "larger is narrower: half the height at a distance of about 0.44 / (B r)"},
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
            .make = [](const Values& v, const Space& space) -> std::shared_ptr<const Monitor> {
                return std::make_shared<SechMonitor>(
                    SechMonitor::Parameters{v.real("amplitude"),
                                            v.real("sharpness"),
                                            v.real("radius") * v.real("radius"),
                                            {v.real("center_x"), v.real("center_y"), 0}},
                    space);
            }};
}

} // namespace gaspard
