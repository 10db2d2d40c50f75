// Solves (K + lambda M) u = b on a line for many pairs (lambda, b) at once; K and M are the stiffness and
// mass matrices of quadratic elements on n equal cells, lambda > 0.
//
// The midpoints are eliminated. The Schur complement for the vertices is tridiagonal with constant
// coefficients and factorises into two recurrences:
//
//   g (1 - rho S) (1 - rho S^-1) u = b,   S u_c = u_(c-1),   |rho| < 1
//
// on a periodic line, or on a line with natural boundary conditions, which is the even half of a periodic
// line of twice the length.
#pragma once

#include <cstddef>
#include <vector>

namespace gaspard {

class ModalLines {
  public:
    /// One column per entry of `lambdas`. A column with lambda = 0 is singular; its result is finite but
    /// meaningless.
    ModalLines(std::size_t cells, bool periodic, const std::vector<double>& lambdas);

    struct Workspace {
        std::vector<double> sum, power;
    };
    static Workspace make_workspace() { return {std::vector<double>(width), std::vector<double>(width)}; }

    /// Replaces columns begin .. end of b by the solution. The rows of b (2 n if periodic, else 2 n + 1) are
    /// `stride` apart.
    void solve(double* b, std::size_t stride, std::size_t begin, std::size_t end, Workspace& workspace) const;

  private:
    static constexpr std::size_t width = 64; ///< columns processed together, to stay in cache
    struct Block;
    void eliminate_middles(const Block& block) const;
    void solve_ring(const Block& block) const;
    void solve_line(const Block& block) const;
    void restore_middles(const Block& block) const;

    std::size_t cells_;
    bool periodic_;
    // One entry per column:
    std::vector<double> coupling_, scale_, rho_, closure_; ///< a_vm / a_mm, 1 / g, rho, 1 / (1 - rho^ring)
    std::vector<double> middle_;                           ///< 1 / a_mm
    std::vector<double> end_;                              ///< 1 / (1 - rho^2)
};

} // namespace gaspard
