// Bernstein coefficients of a polynomial on each cell of [0, 1], from its values at points of the cell.
#pragma once

#include <cstddef>
#include <vector>

namespace gaspard {

/// Points of every cell at which its polynomials of this degree are interpolated (Chebyshev's, all inside, so
/// that each belongs to one cell), and the matrix from values there to Bernstein coefficients. At degree 12
/// its rounding errors are some 1e-10 of the largest value.
struct BernsteinPoints {
    BernsteinPoints(std::size_t degree, std::size_t cells);

    std::size_t size; ///< points per cell
    std::vector<double> points;
    std::vector<double> to_bernstein; ///< by rows
};

} // namespace gaspard
