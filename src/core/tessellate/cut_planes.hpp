// Planes that cut a solid open, as view.cut says them.
//
//   x 0.5                            hides what lies at x > 0.5
//   -x 0.5                           hides what lies at x < 0.5
//   normal 1 1 0 at 0.5 0.5 0.5      hides the side of the plane through this point that the normal points to
//
// Planes joined by "and" cut out a wedge: what lies beyond all of them is hidden. After ";" the next wedge
// begins. So "x 0.5; y 0.5" leaves a quarter of a cube, and "x 0.5 and y 0.5" takes a quarter away.
#pragma once

#include "core/base/points.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

struct CutPlane {
    Vec3 normal{1, 0, 0}; ///< of unit length, to the side that is hidden
    Vec3 at;              ///< a point of the plane; of a plane across an axis, on that axis
    /// Distance from the plane; positive on the hidden side.
    double distance(Vec3 p) const { return dot(normal, p - at); }
    friend bool operator==(const CutPlane&, const CutPlane&) = default;
};

/// Hidden is what lies beyond all of its planes.
using CutWedge = std::vector<CutPlane>;

inline constexpr std::size_t most_cut_planes = 8;

/// Empty for an empty text. Throws InputError with one sentence.
std::vector<CutWedge> parse_cut(std::string_view text);
/// A text that parse_cut() reads. Planes across an axis are written short.
std::string format_cut(const std::vector<CutWedge>& cut);
/// The same planes, which hide what they have left. Of a wedge with several planes every one is turned.
std::vector<CutWedge> flipped(std::vector<CutWedge> cut);

} // namespace gaspard
