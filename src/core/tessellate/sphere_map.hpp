// A sphere around the origin as a plane map: Hammer's projection (1892), which keeps areas. With longitude l
// from the middle and latitude p on a ball of radius R,
//   x = R 2 sqrt 2 cos p sin(l/2) / w,   y = R sqrt 2 sin p / w,   w = sqrt(1 + cos p cos(l/2)),
// an ellipse with half axes 2 sqrt 2 R and sqrt 2 R. It is chosen because both directions are closed formulas
// and shapes stay better at the poles than with a cylinder (Lambert) or flat parallels (Mollweide).
//
// The map is cut along the meridian opposite to its middle. Triangles and lines that cross it are cut there
// and appear at both sides.
#pragma once

#include "core/tessellate/tessellation.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace gaspard {

struct MapProjection {
    double radius = 1;
    double longitude = 0; ///< of the middle, in radians
    friend bool operator==(const MapProjection&, const MapProjection&) = default;
};

/// The place on the map (z = 0) of a point's direction. The cut itself belongs to the right side.
Vec3 to_map(const MapProjection& projection, Vec3 point);
/// The point of the sphere at a place of the map; nothing beside the map.
std::optional<Vec3> from_map(const MapProjection& projection, Vec3 place);

/// The ellipse around the map as a closed line.
std::vector<Vec3> map_outline(const MapProjection& projection);

/// A point on the way between two others, which may be such points themselves.
struct MapCut {
    std::uint32_t a = 0, b = 0;
    double t = 0;
};
/// How a map's triangles and lines differ from the globe's: what has been replaced, and what has been added.
struct MapEdits {
    std::vector<std::uint32_t> replaced_triangles; ///< a triangle and its three points now
    std::vector<std::uint32_t> triangles, triangle_cells;
    std::vector<std::uint32_t> replaced_segments; ///< a segment and its second point now
    std::vector<std::uint32_t> segments, segment_sides;
    friend bool operator==(const MapEdits&, const MapEdits&) = default;
};
struct SphereMap {
    /// Triangles, lines and cells as on the globe, but for those that are cut. The first points are the
    /// globe's (`base`), then come those on the cut.
    std::shared_ptr<const Tessellation> tessellation;
    std::vector<MapCut> cuts;
    Points points;
    MapEdits edits;
};
/// `points`: the globe's shown points, none of which lies at the origin. `last`: a map of the same globe,
/// whose tessellation is taken over where the same triangles and lines are cut.
SphereMap map_sphere(const std::shared_ptr<const Tessellation>& globe, const Points& points,
                     const MapProjection& projection, const SphereMap* last = nullptr);
/// Values of the globe's shown points and, between them, those at the cuts.
std::vector<double> map_values(const SphereMap& map, std::span<const double> globe);

} // namespace gaspard
