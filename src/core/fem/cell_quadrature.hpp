// Quadrature on the reference cells: Gauss points per direction; on triangles the collapsed square (Duffy).
#pragma once

#include "core/mesh/mesh.hpp"

#include <vector>

namespace gaspard {

struct CellPoint {
    Vec3 point;
    double weight = 0; ///< the weights add up to the measure of the reference cell
};

std::vector<CellPoint> cell_quadrature(CellShape shape, int points_per_direction);

/// Exact for polynomials of degree 8, in each direction on squares: 5 x 5 Gauss points, or on triangles the
/// 16 points of Dunavant (1985).
std::vector<CellPoint> quadrature_of_degree_8(CellShape shape);

} // namespace gaspard
