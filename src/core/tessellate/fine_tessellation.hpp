// Tessellations that keep to a tolerance: many pieces where cells are large and curved, few elsewhere.
//
// A piece of a curve p from p(a) to p(b) bends by the greatest distance from its chord of
//   p((1 - t) a + t b), t = 1/4, 1/2, 3/4;
// edges of order 2 are parabolas, which are furthest away at t = 1/2. An edge is halved until its pieces keep
// to the tolerance; a face is cut into a grid, halved in either direction until its lines do. A triangle of a
// quadratic surface whose sides ij bend by d_ij is within 4 sum(l_i l_j |d_ij|) of it (l: barycentric), so
// that
//   |d| <= 3/4 tolerance on all sides, or 1/2 on two and 1 on the third (the diagonal of a square)
// are enough. At the border of a cell the grid takes the edge's points, which may be fewer: both cells beside
// an edge take the same, and there are no cracks.
#pragma once

#include "core/tessellate/tessellation.hpp"

namespace gaspard {

/// Points, triangles and segments as tessellate() has them (corners first), cut until they keep within
/// `tolerance` times the mesh's size (the longest side of the box around xi and x), with the nodes at xi as
/// well as at x. The segments of an edge follow one another. Throws MachineError where that takes more than
/// 4 million triangles, as tangled cells may.
Tessellation tessellate_within(const Mesh& mesh, const Points& x, double tolerance);

} // namespace gaspard
