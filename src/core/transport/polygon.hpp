// Closed polygons of the plane: are they convex, and where are they not?
#pragma once

#include "core/base/points.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

/// A vertex as a sentence calls it: "corner 3".
using VertexName = std::function<std::string(std::size_t)>;

/// "corner 3 at (1, 0.5)", counted from 1.
VertexName counted_vertex(const Points& points, const std::string& noun);

/// The corners of the convex hull, anticlockwise, without those on straight sides; equal points count once.
std::vector<std::size_t> convex_hull(const Points& points);

/// Positive if anticlockwise.
double signed_area(const Points& polygon);

/// What keeps a polygon of at least three vertices from being convex, of either orientation: it "has the same
/// point twice: corner 2 at ... and corner 3 at ...", "has no area, ...", "crosses itself: ...", "is not
/// convex at corner 3 at ...". Vertices may lie on straight sides. Distances from the hull up to `tolerance`
/// times the size count as none.
std::optional<std::string> convexity_fault(const Points& polygon, double tolerance, const VertexName& name);

/// The vertices of a convex polygon, anticlockwise, without those within `tolerance` times its size of a
/// straight line between others.
std::vector<std::size_t> true_corners(const Points& polygon, double tolerance);

/// Throws InputError with convexity_fault() also if there are fewer than three points, one is not finite, or
/// the size is out of the range of lengths. `noun`: "corner".
void check_convex(const Points& polygon, double tolerance, const std::string& noun);

} // namespace gaspard
