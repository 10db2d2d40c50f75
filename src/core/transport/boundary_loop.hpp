// Triangle meshes of convex domains from elsewhere, such as files, and the curves around them.
#pragma once

#include "core/mesh/mesh.hpp"
#include "core/transport/convex_curve.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace gaspard {

struct ConvexMesh {
    Mesh mesh;                                ///< triangles of order 1 with positive areas, space dimension 2
    std::vector<std::int32_t> boundary_nodes; ///< anticlockwise, from the smallest number on
};

/// How far boundary nodes may be inside their convex hull, relative to its size; files have single precision.
inline constexpr double boundary_tolerance = 1e-6;

/// Checks that a mesh is one of a convex domain: triangles of order 1 in a plane z = const, all of the same
/// orientation (all are reversed if they are clockwise), with one boundary, a convex polygon. Triangles then
/// do not overlap: a map of degree 1 without folds is one-to-one.
///
/// Throws InputError, one sentence that counts nodes and triangles from 0, if cells are not such triangles, a
/// node is in none or not finite, the surface is closed, not a manifold, not flat, in several parts, or has a
/// hole, a triangle is degenerate or reversed against another one, or the boundary crosses itself or is not
/// convex.
ConvexMesh convex_mesh(Mesh mesh);

/// The boundary polygon with corners rounded by the given radius, as for rounded_polygon(); nodes within
/// boundary_tolerance of straight sides are not corners.
std::shared_ptr<const ConvexCurve> boundary_curve(const ConvexMesh& mesh, double radius);

} // namespace gaspard
