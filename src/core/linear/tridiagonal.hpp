// Symmetric tridiagonal systems, open or closed to a ring, factorised once and solved for many columns at
// once.
#pragma once

#include <cstddef>
#include <vector>

namespace gaspard {

/// A x = b with A symmetric positive definite, A_ii = diagonal[i], A_i,i+1 = off[i]; closed: off[n-1] couples
/// the last unknown with the first (n >= 3).
class TridiagonalSolver {
  public:
    TridiagonalSolver() = default;
    /// `off` has n - 1 entries (open) or n (closed).
    TridiagonalSolver(std::vector<double> diagonal, std::vector<double> off, bool closed);

    std::size_t size() const { return n_; }
    /// Overwrites b with x. Row i of b starts at b + i * stride; its `columns` entries are independent
    /// systems.
    void solve(double* b, std::size_t columns, std::size_t stride) const;

  private:
    std::size_t n_ = 0;    ///< unknowns
    std::size_t open_ = 0; ///< n, or n - 1 when closed: the last unknown is bordered
    std::vector<double> inverse_pivot_, lower_;
    std::vector<double> off_;
    std::vector<double> border_;       ///< closed: what the open part answers to the last unknown's column
    std::size_t front_ = 0, back_ = 0; ///< between the two there is nothing of it
    double border_pivot_ = 0, first_ = 0, last_ = 0;
};

} // namespace gaspard
