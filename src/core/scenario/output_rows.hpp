// The rows of section "output": which files a run writes and the window exports.
#pragma once

#include "core/base/export.hpp"
#include "core/base/parameter.hpp"

#include <vector>

namespace gaspard GASPARD_API {

/// Relative to the mesh size. On a sphere, a great circle is divided into 200 to 400 segments.
inline constexpr double default_curve_tolerance = 1e-4;

std::vector<ParameterRow> output_rows();

} // namespace GASPARD_API
