// Quadrature on the reference cells: tensor Gauss points; on triangles with the Duffy transformation.
#pragma once

#include "core/mesh/mesh.hpp"

#include <vector>

namespace gaspard {

struct CellPoint {
    Vec3 point;
    double weight = 0; ///< the weights sum to the measure of the reference cell
};

std::vector<CellPoint> cell_quadrature(CellShape shape, int points_per_direction);

/// Exact for polynomials of degree 8. Squares: 5 x 5 Gauss points (degree 8 in each direction); triangles:
/// the 16-point rule of Dunavant (1985).
std::vector<CellPoint> quadrature_of_degree_8(CellShape shape);

} // namespace gaspard
