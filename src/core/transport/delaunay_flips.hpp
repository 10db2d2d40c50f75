// Better triangles of the same nodes.
#pragma once

#include "core/mesh/mesh.hpp"

namespace gaspard {

/// Exchanges the diagonals of neighbouring triangles until, at each inner edge, the two angles opposite to it
/// add up to at most pi (Lawson, 1977), which makes the smallest angle as large as these nodes allow.
/// Diagonals of four nodes on a circle stay. `mesh` is of triangles of order 1 in the plane with positive
/// areas.
void flip_to_delaunay(Mesh& mesh);

} // namespace gaspard
