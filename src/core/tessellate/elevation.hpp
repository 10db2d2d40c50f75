// A plane mesh as the surface z = u over the domain. With the place s(u) of the value in the range of
// colours, from 0 to 1, linear or logarithmic,
//
//   z = factor L / 2 s(u),   L the longest side of the box around the computational mesh.
#pragma once

#include "core/tessellate/colouring.hpp"

#include <vector>

namespace gaspard {

/// z of every node; values outside the range are as high as its ends, those that are not finite as its low
/// end. Empty where the mesh stays flat: factor 0, cells that are no surface in the plane, a field of cells,
/// or a range of one value.
std::vector<double> elevations(const Mesh& mesh, const Colouring& colouring, double factor);

/// The points at these z; unchanged if `z` is empty.
Points raised(Points points, const std::vector<double>& z);

} // namespace gaspard
