// Checks common to all patch file formats. All throw InputError naming the file (`origin`).
#pragma once

#include "core/spline/spline_patch.hpp"

#include <string>

namespace gaspard {

[[noreturn]] void not_a_patch(const std::string& origin, const std::string& what);
/// Checks one direction; returns its knot vector, scaled to [0, 1].
KnotVector checked_direction(double degree, std::vector<double> knots, const std::string& which,
                             const std::string& origin);
/// Checks that the numbers of control points and weights fit the knots, that weights are positive and that
/// coordinates are within bounds.
void check_patch(const SplinePatch& patch, const std::string& origin);

/// Checks at sample points that the Jacobian does not vanish or, in the plane, change sign.
void check_regular(const PatchMap& map, const std::string& origin);

} // namespace gaspard
