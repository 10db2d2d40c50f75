// Contour lines of a nodal field u on the triangles that are drawn.
//
// u is linear in each triangle of a tessellation, so that the line u = c in it is a segment between two of
// its edges. On the edge from a to b it begins or ends at
//
//   p = (1 - t) p_a + t p_b,   t = (c - u_a) / (u_b - u_a),
//
// which holds for any positions of the shown points: computational, physical, or between.
#pragma once

#include "core/tessellate/colour_map.hpp"
#include "core/tessellate/tessellation.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

struct ContourLevels {
    std::vector<double> values{}; ///< ascending, inside the range
    std::string text{};           ///< for a legend: "every 0.2", "every decade"; empty without levels
};

/// At most `most` levels inside a range: multiples of the smallest step 1, 2 or 5 times a power of ten that
/// is large enough. In a logarithmic range that spans a decade or more, 1 to 9 times each power of ten, or
/// 1, 2 and 5 times, or powers of ten, every one or every second, fifth, tenth, ...
ContourLevels contour_levels(const ColourRange& range, int most);

/// A point of an edge between two shown points, a < b.
struct ContourPoint {
    std::uint32_t a = 0, b = 0;
    double t = 0; ///< 0 at a, 1 at b
    Vec3 in(const Points& shown) const { return (1 - t) * shown[a] + t * shown[b]; }
    friend bool operator==(const ContourPoint&, const ContourPoint&) = default;
};
struct ContourSegment {
    ContourPoint from, to;
    std::uint32_t level = 0;    ///< index of the level
    std::uint32_t triangle = 0; ///< of the tessellation
};

/// The segments of all lines u = levels[k] (ascending), triangle by triangle. `values`: u at the shown
/// points. Triangles that touch along an edge give the same points there. Values that miss a level by 1e-9 of
/// the span of all values count as equal to it, so that rounding in a region where u is constant draws
/// nothing.
/// Triangles with a value that is not finite have no lines.
std::vector<ContourSegment> contour_lines(const Tessellation& tessellation, std::span<const double> values,
                                          std::span<const double> levels);

} // namespace gaspard
