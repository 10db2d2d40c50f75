// Triangles of a convex domain in rings around a centre.
#pragma once

#include "core/mesh/mesh.hpp"
#include "core/transport/convex_curve.hpp"

#include <cstdint>
#include <vector>

namespace gaspard {

struct RingMesh {
    Mesh mesh;                                ///< triangles of order 1, space dimension 2
    std::vector<double> boundary_parameters;  ///< t of the boundary nodes
    std::vector<std::int32_t> boundary_nodes; ///< the last ring, anticlockwise
};

/// 6 n^2 triangles of 1 + 3 n (n + 1) nodes, n = `rings` >= 1. Node 0 is the centre; then ring i of n follows
/// with 6 i nodes, anticlockwise,
///
///     x_ij = c + (i / n) (gamma(j / (6 i)) - c).
///
/// Edges between rings are chosen by flip_to_delaunay(), as rings of long domains are far apart at their
/// ends. Of the unit disk it is the mesh of DOLFIN's UnitDiscMesh (degree 1), with the same numbers of nodes
/// and triangles.
RingMesh ring_mesh(const ConvexCurve& curve, int rings);

struct TriangleQuality {
    double smallest_angle = 0, largest_angle = 0; ///< degrees
    double longest_edge = 0, shortest_edge = 0;
};

/// The extremes over all triangles (order 1, at least one).
TriangleQuality triangle_quality(const Mesh& mesh);

} // namespace gaspard
