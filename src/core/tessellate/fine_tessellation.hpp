// Tessellations that keep to a tolerance: many pieces where cells are large and curved, few elsewhere.
//
// A piece of a curve p from p(a) to p(b) is halved (in its parameter) while
//   max over t = 1/4, 1/2, 3/4 of the distance from p((1 - t) a + t b) to the chord > 3/4 tolerance.
// Edges of order 2 are parabolas, which are furthest away at t = 1/2. A triangle of a quadratic surface whose
// sides keep within d of their chords is itself within 4/3 d of the surface: they differ by
//   sum over the sides ij of 4 l_i l_j d_ij,  4 (l_1 l_2 + l_2 l_3 + l_3 l_1) <= 4/3  (l: barycentric).
#pragma once

#include "core/tessellate/tessellation.hpp"

namespace gaspard {

/// Points, triangles and segments as tessellate() has them, cut until they keep within `tolerance` times the
/// mesh's size (the longest side of the box around xi and x), with the nodes at xi as well as at x. The two
/// cells beside an edge share its points: there are no cracks. The segments of an edge follow one another.
Tessellation tessellate_within(const Mesh& mesh, const Points& x, double tolerance);

} // namespace gaspard
