#include "core/diagnostics/cell_quadrature.hpp"

#include "core/fem/gauss.hpp"

namespace gaspard {

std::vector<CellPoint> cell_quadrature(CellShape shape, int points_per_direction) {
    const LineQuadrature line = gauss_legendre(points_per_direction);
    const std::size_t n = line.points.size();
    const std::size_t ny = shape == CellShape::line ? 1 : n, nz = shape == CellShape::hexahedron ? n : 1;
    std::vector<CellPoint> points;
    for (std::size_t k = 0; k < nz; ++k)
        for (std::size_t j = 0; j < ny; ++j)
            for (std::size_t i = 0; i < n; ++i) {
                CellPoint p{{line.points[i], 0, 0}, line.weights[i]};
                if (ny > 1) p.point.y = line.points[j], p.weight *= line.weights[j];
                if (nz > 1) p.point.z = line.points[k], p.weight *= line.weights[k];
                if (shape == CellShape::triangle) { // (s, t) -> (s (1 - t), t), with Jacobian 1 - t
                    p.weight *= 1 - p.point.y;
                    p.point.x *= 1 - p.point.y;
                }
                points.push_back(p);
            }
    return points;
}

} // namespace gaspard
