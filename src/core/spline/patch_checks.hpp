// Checks common to all patch file formats. All throw InputError naming the file (`origin`).
#pragma once

#include "core/spline/spline_patch.hpp"

#include <array>
#include <string>
#include <vector>

namespace gaspard {

/// A patch as a file has it, not yet checked.
struct PatchParts {
    std::size_t directions = 2; ///< 3: of a solid
    std::array<double, 3> degrees{};
    std::array<std::vector<double>, 3> knots{};
    Points control{};              ///< first direction fastest
    std::vector<double> weights{}; ///< empty: all 1
};

[[noreturn]] void not_a_patch(const std::string& origin, const std::string& what);
/// Checks degrees, knots, and that the numbers of control points and weights fit them, that weights are
/// positive and that coordinates are within bounds. Knots are scaled to [0, 1].
SplinePatch make_patch(PatchParts parts, const std::string& origin);
/// Points from coordinates in a row, x y or x y z of each point; `dimension` is 2 or 3.
Points points_in_rows(const std::vector<double>& coordinates, std::size_t dimension);
/// Points from rows of coordinates, all x, then all y, and so on.
Points points_in_columns(const std::vector<double>& coordinates, std::size_t dimension);
/// Divides homogeneous control points (w x, w y, w z) by their weights. Throws InputError unless these are
/// positive and as many as the points.
void divide_by_weights(PatchParts& parts, const std::string& origin);

/// Checks at sample points that the Jacobian does not vanish or, in the plane and of solids, change sign.
void check_regular(const PatchMap& map, const std::string& origin);
void check_regular(const SolidMap& map, const std::string& origin);

} // namespace gaspard
