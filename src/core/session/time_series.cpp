#include "core/session/time_series.hpp"

#include "core/scenario/view_rows.hpp"

#include <string>

namespace gaspard {

std::vector<SeriesInfo> time_series() {
    return {{.name = time_names::time, .label = "Time", .symbol = "t", .help = "of the iterate"},
            {.name = time_names::iterations,
             .label = "Iterations of the time step",
             .help = "of the method; 0 where the extrapolated map was near enough"},
            {.name = time_names::speed,
             .label = "Mesh speed",
             .symbol = "max |∂x/∂t|",
             .help = "of the fastest node, from the time before"},
            {.name = time_names::monitor,
             .label = "Time for the monitor",
             .unit = "s",
             .help = "wall time to make the monitor of the time step: files, flows"}};
}

std::vector<FieldInfo> velocity_fields(int dimension) {
    std::vector<FieldInfo> fields = {mesh_colour("mesh_speed")};
    for (int i = 0; i < dimension; ++i)
        fields.push_back(mesh_colour(std::string("mesh_velocity_") + "xyz"[i]));
    return fields;
}

std::optional<double> time_of(const StepReport& report) { return report.value(time_names::time); }

bool is_time_step(const StepReport& report) { return report.value(time_names::iterations).has_value(); }

} // namespace gaspard
