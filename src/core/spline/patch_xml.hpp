// Patches in the XML format of G+Smo (gsWriteXml): the first <Geometry> of type TensorBSpline2 or
// TensorNurbs2, with two <KnotVector degree="p">, <coefs geoDim="d"> and, for NURBS, <weights>.
#pragma once

#include "core/spline/spline_patch.hpp"

#include <string>
#include <string_view>

namespace gaspard {

/// Throws InputError that names what is missing or wrong. Knots are scaled to [0, 1].
SplinePatch parse_patch_xml(std::string_view xml, const std::string& origin);
/// Reads back to the same patch. Writes three coordinates if some z is not 0, and NURBS if weights differ.
std::string patch_xml(const SplinePatch& patch);

} // namespace gaspard
