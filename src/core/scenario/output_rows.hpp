// The rows of the section "output": what a run writes, and what the window exports.
#pragma once

#include "core/base/parameter.hpp"

#include <vector>

namespace gaspard {

/// Relative to the mesh's size: of a sphere, a great circle becomes 200 to 400 pieces.
inline constexpr double default_curve_tolerance = 1e-4;

std::vector<ParameterRow> output_rows();

} // namespace gaspard
