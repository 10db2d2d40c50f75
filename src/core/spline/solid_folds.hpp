// Where a spline map Psi of the cube folds: the sign of det grad Psi on whole cells instead of at samples.
//
// On a cell, J = det grad Psi is a polynomial. Two enclosures:
//
//   products of the ranges of the nine derivatives, from their B-spline coefficients: cheap
//   Bernstein coefficients, min b_ijk <= J <= max b_ijk, in halves of the cell until the sign is certain
//
// Those of a product of polynomials of degrees p and q follow from those of its factors, stably, since all
// weights are positive; in one direction
//
//   b_k = (sum over i + j = k of C(p, i) f_i C(q, j) g_j) / C(p + q, k)
//
// The second is needed only where the first leaves the sign open. (Of patches,
// core/spline/jacobian_bounds.hpp bounds J itself.)
#pragma once

#include "core/spline/tensor_space.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

/// Cells in which J <= 0 somewhere, or J is not a number, of cells x cells x cells equal cells, the first
/// direction fastest; ascending. A cell whose J touches zero counts. `map`: the three components of Psi,
/// continuous, with breaks at boundaries of cells only.
std::vector<std::uint32_t> folded_solid_cells(std::span<const SplineFunction> map, std::size_t cells);

} // namespace gaspard
