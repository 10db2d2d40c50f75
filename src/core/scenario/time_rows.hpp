// The rows of the section "time": when a monitor moves, how, and how the mesh follows it (session/run.hpp).
//
// For every real parameter of the monitor there is a row "monitor.KEY", its value as a formula in t
// (clock.hpp).
#pragma once

#include "core/base/parameter.hpp"

#include <string_view>
#include <vector>

namespace gaspard {

/// Before the keys of the monitor's parameters.
inline constexpr std::string_view moving_prefix = "monitor.";

/// Choices of time.rule.
namespace time_rule {
inline constexpr std::string_view equidistribution = "equidistribution", tolerance = "tolerance",
                                  iterations = "iterations", relaxation = "relaxation";
}

std::vector<ParameterRow> time_rows(const std::vector<ParameterRow>& monitor);
/// Whether time.end is after time.start.
bool has_time(const Values& time);
/// Whether a parameter or a point is to move.
bool has_motion(const Values& time);
/// Whether the meshes of two sections "time" are the same; the speed in the window may differ.
bool same_time(const Values& a, const Values& b);

} // namespace gaspard
