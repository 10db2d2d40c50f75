// The smallest eigenvalue of I + sigma, from the weak Hessian alone.
#pragma once

#include "core/fem/plane_q2.hpp"
#include "support/polynomials.hpp"

#include <algorithm>
#include <limits>

namespace gaspard {

/// Over 4 x 4 Gauss points per cell.
inline double smallest_eigenvalue(const PlaneQ2& plane, std::span<const double> phi) {
    auto workspace = plane.make_workspace();
    WeakHessian sigma;
    plane.hessian(phi, sigma, workspace);
    const slow::Rule rule = slow::gauss(4);
    double shapes[4][3];
    for (std::size_t q = 0; q < 4; ++q)
        for (int a = 0; a < 3; ++a) shapes[q][a] = slow::evaluate(slow::lagrange(2, a), rule.points[q]);
    const std::size_t n = plane.size(), cells = plane.grid().cells;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < cells; ++j)
        for (std::size_t i = 0; i < cells; ++i)
            for (const auto& t : shapes)
                for (const auto& s : shapes) {
                    double xx = 1, yy = 1, xy = 0;
                    for (std::size_t b = 0; b < 3; ++b)
                        for (std::size_t a = 0; a < 3; ++a) {
                            const std::size_t k = (2 * j + b) % n * n + (2 * i + a) % n;
                            xx += s[a] * t[b] * sigma.xx[k];
                            yy += s[a] * t[b] * sigma.yy[k];
                            xy += s[a] * t[b] * sigma.xy[k];
                        }
                    smallest = std::min(smallest, (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy));
                }
    return smallest;
}

} // namespace gaspard
