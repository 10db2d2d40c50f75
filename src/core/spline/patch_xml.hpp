// Patches in the XML format of G+Smo (gsWriteXml): every <Geometry> of type TensorBSpline2 or TensorNurbs2.
// docs/splines.md says what is read and what is refused.
#pragma once

#include "core/spline/patch_choice.hpp"

#include <string>
#include <string_view>

namespace gaspard {

/// Throws InputError that names what is missing or wrong. Knots are scaled to [0, 1].
FoundPatch read_gismo(const PatchText& file);
/// Reads back to the same patch. Writes three coordinates if some z is not 0, and NURBS if weights differ.
std::string patch_xml(const SplinePatch& patch);

} // namespace gaspard
