// Patches in JSON: Gaspard's own (patch_file.hpp), geomdl's (NURBS-Python, "shape") and splinepy's
// ("SplineList").
#pragma once

#include "core/spline/patch_choice.hpp"

namespace gaspard {

/// Throws InputError that names what is missing, unknown or wrong, and where.
FoundPatch read_json_patch(const PatchText& file);

} // namespace gaspard
