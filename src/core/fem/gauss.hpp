// Gauss-Legendre quadrature on [0, 1].
#pragma once

#include <vector>

namespace gaspard {

struct LineQuadrature {
    std::vector<double> points, weights; ///< the weights sum to 1
};

/// The rule with the given number of points; exact for polynomials of degree 2 points - 1.
LineQuadrature gauss_legendre(int points);

} // namespace gaspard
