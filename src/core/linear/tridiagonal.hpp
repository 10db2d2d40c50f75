// Symmetric tridiagonal systems, open or cyclic, factorised once and solved for many right-hand sides.
#pragma once

#include <cstddef>
#include <vector>

namespace gaspard {

/// A x = b with A symmetric positive definite, A_ii = diagonal[i], A_i,i+1 = off[i]. If closed (cyclic,
/// n >= 3), off[n-1] couples the last unknown with the first.
class TridiagonalSolver {
  public:
    TridiagonalSolver() = default;
    /// `off` has n - 1 entries (open) or n entries (closed).
    TridiagonalSolver(std::vector<double> diagonal, std::vector<double> off, bool closed);

    std::size_t size() const { return n_; }
    /// Overwrites b with x. Row i of b starts at b + i * stride; its `columns` entries belong to independent
    /// systems.
    void solve(double* b, std::size_t columns, std::size_t stride) const;

  private:
    std::size_t n_ = 0;    ///< number of unknowns
    std::size_t open_ = 0; ///< n, or n - 1 if closed: the last unknown is eliminated separately
    std::vector<double> inverse_pivot_, lower_;
    std::vector<double> off_;
    std::vector<double> border_; ///< closed: solution of the open part for the coupling to the last unknown
    std::size_t front_ = 0, back_ = 0; ///< border_ is negligible in [front_, back_)
    double border_pivot_ = 0, first_ = 0, last_ = 0;
};

} // namespace gaspard
