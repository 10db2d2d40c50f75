// Where a spline map Psi of the square folds: det grad Psi, bounded on whole cells instead of sampled.
//
// On a cell, J = det grad Psi is a polynomial of some degree d in each direction. Its Bernstein coefficients
// enclose it, and those of the corners are values of J:
//
//   J(s, t) = sum over i, j of b_ij B_i^d(s) B_j^d(t),      min b_ij <= J <= max b_ij
//
// Subdivision (de Casteljau) closes the gap quadratically in the size of the parts. It is needed only where
// the sign is uncertain, and in the cells that may contain the minimum.
#pragma once

#include "core/spline/tensor_space.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

struct JacobianBounds {
    /// The smallest value of J found, and a lower bound. They differ by at most jacobian_tolerance times the
    /// largest |J|, except where J is zero along a curve and it takes too many parts to tell. Where J is not
    /// a number somewhere, there is no bound: it is -infinity.
    double smallest = 0, bound = 0;
    /// Cells in which J <= 0 somewhere, or is not a number; ascending. A cell whose J touches zero counts.
    std::vector<std::uint32_t> folded;
};
inline constexpr double jacobian_tolerance = 1e-6;

/// J on cells x cells equal cells, cell (i, j) having the number j cells + i. `map`: the components of Psi,
/// continuous, with breaks at boundaries of cells only.
JacobianBounds bound_jacobian(const std::array<SplineFunction, 2>& map, std::size_t cells);

} // namespace gaspard
