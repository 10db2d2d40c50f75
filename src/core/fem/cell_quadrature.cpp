#include "core/fem/cell_quadrature.hpp"

#include "core/base/check.hpp"
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
                if (shape == CellShape::triangle) { // Duffy map (s, t) -> (s (1 - t), t), Jacobian 1 - t
                    p.weight *= 1 - p.point.y;
                    p.point.x *= 1 - p.point.y;
                }
                points.push_back(p);
            }
    return points;
}

std::vector<CellPoint> quadrature_of_degree_8(CellShape shape) {
    if (shape == CellShape::quadrilateral) return cell_quadrature(shape, 5);
    GASPARD_CHECK(shape == CellShape::triangle);
    // Barycentric coordinates with all permutations; the weights sum to 1.
    struct Orbit {
        double a, b, weight;
    };
    constexpr double third = 1.0 / 3;
    constexpr Orbit orbits[] = {{third, third, 0.144315607677787},
                                {0.459292588292723, 0.459292588292723, 0.095091634267285},
                                {0.170569307751760, 0.170569307751760, 0.103217370534718},
                                {0.050547228317031, 0.050547228317031, 0.032458497623198},
                                {0.008394777409958, 0.263112829634638, 0.027230314174435}};
    std::vector<CellPoint> points;
    for (const auto& [a, b, weight] : orbits) {
        const double c = 1 - a - b;
        const auto add = [&](double s, double t) { points.push_back({{s, t, 0}, weight / 2}); };
        add(a, b);
        if (a == third) continue;
        add(b, c), add(c, a);
        if (a == b) continue;
        add(b, a), add(c, b), add(a, c);
    }
    return points;
}

} // namespace gaspard
