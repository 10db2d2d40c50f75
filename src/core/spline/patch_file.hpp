// Patch files. The content tells the kind, not the name: Gaspard's JSON, G+Smo's XML, MFEM's NURBS meshes,
// GeoPDEs' geometries, and the JSON of geomdl and splinepy. Our own JSON:
//
//   { "degrees": [2, 2],
//     "knots": [[0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 1, 1]],
//     "control_points": [[x, y], ...] or [[x, y, z], ...],   first direction fastest
//     "weights": [w, ...] }                                  optional; default 1
//
// A solid has three degrees and three knot vectors.
#pragma once

#include "core/base/export.hpp"
#include "core/spline/patch_choice.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace gaspard GASPARD_API {

/// The largest patch file that is read: 32 MiB.
inline constexpr std::uintmax_t largest_patch_file = std::uintmax_t{1} << 25;

/// Reads a patch from the text of a file of any kind. Throws InputError that names what is missing or wrong,
/// and where, or the kind of a file that cannot be read. Knots are scaled to [0, 1]. `directions` tells
/// whether surfaces or solids are wanted.
FoundPatch parse_patch(const PatchText& file);
/// The same, from a file. `which` is domain.patch (patch_choice.hpp).
FoundPatch read_patch(const std::filesystem::path& file, const std::string& which = {},
                      std::size_t directions = 2);
/// The patch or solid of domain.file: JSON text, or a path relative to `folder`; the empty string is
/// nurbs_disk() or nurbs_cylinder().
FoundPatch find_patch(const std::string& json_or_file, const std::filesystem::path& folder = {},
                      const std::string& which = {}, std::size_t directions = 2);
/// Reads back to the same patch.
std::string patch_json(const SplinePatch& patch);

/// The unit disk, represented exactly by one biquadratic NURBS patch.
SplinePatch nurbs_disk();
/// The disk times [0, 2]: a solid with three directions.
SplinePatch nurbs_cylinder();

} // namespace GASPARD_API
