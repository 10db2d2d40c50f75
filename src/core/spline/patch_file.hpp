// Patch files. JSON:
//
//   { "degrees": [2, 2],
//     "knots": [[0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 1, 1]],
//     "control_points": [[x, y], ...] or [[x, y, z], ...],   first direction fastest
//     "weights": [w, ...] }                                  optional; default 1
#pragma once

#include "core/spline/spline_patch.hpp"

#include <filesystem>
#include <string_view>

namespace gaspard {

/// Throws InputError that names what is missing or wrong, and where. Knots are scaled to [0, 1].
SplinePatch parse_patch(std::string_view json, const std::string& origin);
/// Reads JSON, or G+Smo's XML if the name ends in .xml.
SplinePatch read_patch(const std::filesystem::path& file);
/// Reads a patch from JSON text or from the file of that name; the empty string is nurbs_disk().
SplinePatch find_patch(const std::string& json_or_file);
/// Reads back to the same patch.
std::string patch_json(const SplinePatch& patch);

/// The unit disk, represented exactly by one biquadratic NURBS patch.
SplinePatch nurbs_disk();

} // namespace gaspard
