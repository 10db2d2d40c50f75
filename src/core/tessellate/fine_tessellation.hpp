// Tessellations within a tolerance: fine where cells are large and curved, coarse elsewhere.
//
// The bulge of a piece of a curve p between the parameters a and b is the largest distance from its chord of
// the points
//
//   p((1 - t) a + t b),   t = 1/4, 1/2, 3/4,
//
// or, for an order k > 2, of the 2 k + 1 points that divide it evenly. (Edges of order 2 are parabolas and
// bulge most at t = 1/2.) An edge is bisected until its pieces are within
// the tolerance; a face is divided into a grid, which is refined in either direction until its lines are. A
// triangle of a quadratic surface whose sides ij bulge by d_ij is within
//
//   4 sum over i < j of l_i l_j |d_ij|       (l: barycentric coordinates)
//
// of the surface, so that |d| <= 3/4 tolerance on all sides suffices, or 1/2 on two sides and 1 on the third
// (the diagonal of a square). At the boundary of a cell the grid uses the points of the edge, which may be
// fewer. Both cells of an edge use the same points, so that there are no cracks.
#pragma once

#include "core/tessellate/tessellation.hpp"

namespace gaspard {

/// About 4 s.
inline constexpr std::size_t tessellation_work = 400'000'000;

/// Points, triangles and segments as from tessellate() (corners first), subdivided until they are within
/// `tolerance` times the size of the mesh (longest side of the bounding box of xi and x), for nodes both at
/// xi and at x. The segments of an edge are consecutive. Throws MachineError if this takes more than 4
/// million triangles, as it may where cells are tangled, or sums over more than `most_work` nodes and a
/// million for each cell.
Tessellation tessellate_within(const Mesh& mesh, const Points& x, double tolerance,
                               std::size_t most_work = tessellation_work);

} // namespace gaspard
