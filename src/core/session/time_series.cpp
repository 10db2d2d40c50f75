#include "core/session/time_series.hpp"

#include "core/scenario/time_rows.hpp"
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

bool is_given_up(const StepReport& report) {
    return is_time_step(report) && !report.value(time_names::speed);
}

bool is_wall_time(std::string_view series) { return series == time_names::monitor; }

std::optional<double> tolerance_of(const Scenario& scenario, const StepReport& newest) {
    const Values& method = scenario.method.values;
    if (!method.has("tolerance")) return std::nullopt;
    if (!is_time_step(newest)) return method.real("tolerance");
    if (scenario.time.text("rule") != time_rule::tolerance) return std::nullopt;
    return scenario.time.real_or_auto("tolerance").value_or(method.real("tolerance"));
}

} // namespace gaspard
