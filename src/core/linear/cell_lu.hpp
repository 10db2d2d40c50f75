// Direct solution of a finite element system whose matrix is not symmetric:
//
//   A u = b,   A = sum over cells of the cell matrices
//
// Multifrontal method as in cell_cholesky.hpp, with LU: each part of a nested dissection eliminates its own
// unknowns and exchanges rows among those only. Right-hand side and factors are used at once, so that the
// lower factor is not kept.
#pragma once

#include "core/linear/dissection.hpp"

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace gaspard {

/// Fills a cell's matrix, per_cell x per_cell, by rows.
using CellMatrixOf = std::function<void(std::size_t cell, std::span<double> matrix)>;

/// u by unknowns; not finite where the matrix of a part's own unknowns is singular. `dissection` must be that
/// of `unknowns`. Throws Interrupted when a stop is requested, between parts.
std::vector<double> solve_by_parts(const CellUnknowns& unknowns, const Dissection& dissection,
                                   const CellMatrixOf& cell_matrix, std::span<const double> b,
                                   const std::stop_token& stop = {});

} // namespace gaspard
