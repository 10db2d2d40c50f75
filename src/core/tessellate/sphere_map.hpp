// Plane maps of a sphere around the origin by Hammer's equal-area projection (1892). With longitude l
// relative to the centre and latitude p on a sphere of radius R,
//
//   x = 2 sqrt(2) R cos p sin(l/2) / w,   y = sqrt(2) R sin p / w,   w = sqrt(1 + cos p cos(l/2)),
//
// which is an ellipse with semi-axes 2 sqrt(2) R and sqrt(2) R. Both directions have closed formulas, and
// shapes near the poles are less distorted than in cylindrical (Lambert) or pseudocylindrical (Mollweide)
// projections.
//
// The map is cut along the meridian opposite to its centre. Triangles and segments that cross it are divided
// and appear on both sides.
#pragma once

#include "core/tessellate/tessellation.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace gaspard {

struct MapProjection {
    double radius = 1;
    double longitude = 0; ///< of the centre, in radians
    friend bool operator==(const MapProjection&, const MapProjection&) = default;
};

/// The point of the map (z = 0) for a direction. Points on the cut are drawn on the right side.
Vec3 to_map(const MapProjection& projection, Vec3 point);
/// The point of the sphere at a point of the map; nullopt outside the map.
std::optional<Vec3> from_map(const MapProjection& projection, Vec3 place);

/// The boundary ellipse of the map as a closed line.
std::vector<Vec3> map_outline(const MapProjection& projection);

/// A point on the segment between two others, which may themselves be cut points.
struct MapCut {
    std::uint32_t a = 0, b = 0;
    double t = 0;
};
/// The differences between the triangles and segments of the map and the globe.
struct MapEdits {
    std::vector<std::uint32_t> replaced_triangles; ///< for each: a triangle and its three new points
    std::vector<std::uint32_t> triangles, triangle_cells;
    std::vector<std::uint32_t> replaced_segments; ///< for each: a segment and its new second point
    std::vector<std::uint32_t> segments, segment_sides;
    friend bool operator==(const MapEdits&, const MapEdits&) = default;
};
struct SphereMap {
    /// The globe's tessellation except for triangles and segments that are cut. The globe's points (`base`)
    /// come first, then the points on the cut.
    std::shared_ptr<const Tessellation> tessellation;
    std::vector<MapCut> cuts;
    Points points;
    MapEdits edits;
};
/// `points`: shown points of the globe, none at the origin. `last`: an earlier map of the same globe; its
/// tessellation is reused if the same triangles and segments are cut.
SphereMap map_sphere(const std::shared_ptr<const Tessellation>& globe, const Points& points,
                     const MapProjection& projection, const SphereMap* last = nullptr);
/// Values at the globe's shown points and, interpolated, at the cut points.
std::vector<double> map_values(const SphereMap& map, std::span<const double> globe);

} // namespace gaspard
