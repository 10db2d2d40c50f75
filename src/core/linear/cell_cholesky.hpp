// Sparse Cholesky factorisation of a finite element matrix, for one or many right-hand sides:
//
//   A = sum over cells of the cell matrices = L L^T,      A u = b
//
// Multifrontal method (Duff and Reid, 1983): A is never assembled. Each part of a nested dissection assembles
// a dense frontal matrix from its cell matrices, or from the Schur complements of its two children,
// eliminates its own unknowns and passes the Schur complement of the border on to its parent. L is stored
// part by part in dense rows, so that a solve reads it once forward and once backward for all right-hand
// sides together.
#pragma once

#include "core/linear/dissection.hpp"

#include <functional>
#include <memory>
#include <stop_token>

namespace gaspard {

class CellCholesky {
  public:
    /// Fills a cell's symmetric matrix, per_cell x per_cell, by rows.
    using CellMatrix = std::function<void(std::size_t cell, std::span<double> matrix)>;
    /// Progress callback; the argument is the fraction done, from 0 to 1.
    using Advance = std::function<void(double)>;

    /// `unknowns` must be those that were dissected, and the sum of the cell matrices positive definite (else
    /// InternalError). Throws Interrupted when a stop is requested.
    CellCholesky(const CellUnknowns& unknowns, std::shared_ptr<const Dissection> dissection,
                 const CellMatrix& matrix, const Advance& advance = {}, std::stop_token stop = {});

    /// Solves in place for `columns` (1, 4 or 12) right-hand sides. b has one row of `columns` numbers per
    /// unknown, rows in elimination order (Dissection::permutation). Does not allocate.
    template <int columns>
    void solve(std::span<double> b) const;

    std::size_t size() const { return size_; }
    /// Number of entries of the factor.
    std::size_t entries() const { return values_.size(); }

  private:
    struct Part {
        std::int32_t begin, own, border; ///< first unknown, number eliminated, number in the border
        std::size_t values, indices;     ///< offsets into values_ and indices_
    };

    std::size_t size_;
    std::vector<Part> parts_;
    /// For each part: the lower triangle by rows, with reciprocals on the diagonal, then one row of `own`
    /// numbers per unknown of the border.
    std::vector<double> values_;
    std::vector<std::int32_t> indices_;
};

} // namespace gaspard
