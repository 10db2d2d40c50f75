// The Cholesky factor of a finite element matrix, and solutions for one or many right-hand sides at once.
//
//   A = sum over the cells of their matrices = L L^T,      A u = b
//
// A is never formed: every part of a nested dissection adds the matrices of its cells, or what its two halves
// leave, eliminates its own unknowns in a small dense matrix, and leaves the rest (the multifrontal method of
// Duff and Reid, 1983). The factor is stored part by part as dense rows, so a solution reads it twice from
// end to end, once forward and once backward, for all right-hand sides together.
#pragma once

#include "core/linear/dissection.hpp"

#include <functional>
#include <memory>
#include <stop_token>

namespace gaspard {

class CellCholesky {
  public:
    /// Fills a cell's symmetric matrix, per_cell x per_cell, row by row.
    using CellMatrix = std::function<void(std::size_t cell, std::span<double> matrix)>;
    /// Called now and then with the part of the work that is done.
    using Advance = std::function<void(double)>;

    /// `unknowns` as it was dissected. The sum must be positive definite (InternalError). Throws Interrupted
    /// when asked to stop.
    CellCholesky(const CellUnknowns& unknowns, std::shared_ptr<const Dissection> dissection,
                 const CellMatrix& matrix, const Advance& advance = {}, std::stop_token stop = {});

    /// Solves in place for `columns` (1, 4 or 12) right-hand sides: b holds a row of so many numbers for
    /// every unknown, in the order of elimination (Dissection::place). Allocates nothing.
    template <int columns>
    void solve(std::span<double> b) const;

    std::size_t size() const { return size_; }
    /// Numbers in the factor.
    std::size_t entries() const { return values_.size(); }

  private:
    struct Part {
        std::int32_t begin, own, border; ///< first unknown, how many it eliminates, how many it meets
        std::size_t values, indices;     ///< where its rows and its border's places begin
    };

    std::size_t size_;
    std::vector<Part> parts_;
    /// Of every part: the lower triangle row by row, then a row of `own` numbers for every unknown of the
    /// border. The diagonal holds reciprocals.
    std::vector<double> values_;
    std::vector<std::int32_t> indices_;
};

} // namespace gaspard
