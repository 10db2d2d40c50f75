// Gauss-Legendre quadrature on [0, 1].
#pragma once

#include <vector>

namespace gaspard {

struct LineQuadrature {
    std::vector<double> points, weights; ///< the weights add up to 1
};

/// `points` points, exact for polynomials of degree 2 points - 1.
LineQuadrature gauss_legendre(int points);

} // namespace gaspard
