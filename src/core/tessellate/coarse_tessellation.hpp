// Coarser versions of tessellations, for meshes that move on the screen.
#pragma once

#include "core/tessellate/tessellation.hpp"

#include <optional>

namespace gaspard {

/// As tessellate() makes it with fewer pieces per edge: with the largest divisor of `fine.cuts` that leaves
/// at most `most_triangles`, or with 1. Its points are those of `fine`, of which it uses some; it has no
/// weights. `face_corners`: 3 or 4 of each face of the cells. nullopt if `fine` is coarse enough, or if it
/// does not consist of the full grids that tessellate() makes, as maps and solids that are cut open.
std::optional<Tessellation> coarsened(const Tessellation& fine, int face_corners, std::size_t most_triangles);

} // namespace gaspard
