// What every file of a patch has to keep, whatever its syntax. All throw InputError, naming the file.
#pragma once

#include "core/spline/spline_patch.hpp"

#include <string>

namespace gaspard {

[[noreturn]] void not_a_patch(const std::string& origin, const std::string& what);
/// The knots moved to [0, 1].
KnotVector checked_direction(double degree, std::vector<double> knots, const std::string& which,
                             const std::string& origin);
/// As many control points and weights as the knots want; weights positive; all of a size that can be computed with.
void check_patch(const SplinePatch& patch, const std::string& origin);

/// The map has an area wherever one looks, and in the plane the same side up.
void check_regular(const PatchMap& map, const std::string& origin);

} // namespace gaspard
