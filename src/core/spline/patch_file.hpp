// Patches as files. JSON:
//
//   { "degrees": [2, 2],
//     "knots": [[0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 1, 1]],
//     "control_points": [[x, y], ...] or [[x, y, z], ...],   fastest in the first direction
//     "weights": [w, ...] }                                  may be left out: all 1
#pragma once

#include "core/spline/spline_patch.hpp"

#include <filesystem>
#include <string_view>

namespace gaspard {

/// Throw InputError that says what is missing or wrong, and where. Knots are moved to [0, 1].
SplinePatch parse_patch(std::string_view json, const std::string& origin);
/// JSON, or what G+Smo writes where the name ends in .xml.
SplinePatch read_patch(const std::filesystem::path& file);
/// From a text that is a patch itself, as JSON, or the name of a file with one; empty: the disk below.
SplinePatch find_patch(const std::string& json_or_file);
/// Reads back to the same patch.
std::string patch_json(const SplinePatch& patch);

/// The unit disk as one biquadratic NURBS patch, exactly.
SplinePatch nurbs_disk();

} // namespace gaspard
