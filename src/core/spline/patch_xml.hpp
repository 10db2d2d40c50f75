// Patches as G+Smo writes them (gsWriteXml): the first element <Geometry> of type TensorBSpline2 or
// TensorNurbs2, with two <KnotVector degree="p">, <coefs geoDim="d"> and, for NURBS, <weights>.
#pragma once

#include "core/spline/spline_patch.hpp"

#include <string>
#include <string_view>

namespace gaspard {

/// Throws InputError that says what is missing or wrong. Knots are moved to [0, 1].
SplinePatch parse_patch_xml(std::string_view xml, const std::string& origin);
/// Reads back to the same patch. Three coordinates where one z differs from 0; NURBS where weights differ.
std::string patch_xml(const SplinePatch& patch);

} // namespace gaspard
