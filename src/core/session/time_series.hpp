// What is reported of meshes that follow a time, by name: series of a run, fields of its nodes.
#pragma once

#include "core/scenario/scenario.hpp"
#include "core/session/snapshot.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace gaspard {

namespace time_names {
inline constexpr const char *time = "time", *iterations = "step_iterations", *speed = "mesh_speed",
                            *monitor = "monitor_seconds";
}

/// Time, iterations of the time step, speed of the fastest node, wall time for the monitor.
std::vector<SeriesInfo> time_series();
/// The velocity of the nodes: its length, and its components in so many dimensions.
std::vector<FieldInfo> velocity_fields(int dimension);

/// The time of an iterate; nullopt if its run has none.
std::optional<double> time_of(const StepReport& report);
/// Whether the iterate is the result of a time step. Others belong to the solve for the first time.
bool is_time_step(const StepReport& report);
/// Whether it repeats the iterate before it, because the next time step could not be made.
bool is_given_up(const StepReport& report);
/// Whether a series is wall time, which differs between runs of the same input: mesh files leave it out.
bool is_wall_time(std::string_view series);
/// What the iterates of a run are solved to, of the series by which it is judged: method.tolerance, or that
/// of a time step. nullopt if the method has none, or if time steps end by another rule (time.rule).
std::optional<double> tolerance_of(const Scenario& scenario, const StepReport& newest);

} // namespace gaspard
