// Many problems on one line at once: (K + lambda M) u = b with the stiffness and mass matrices of quadratic
// elements on n equal cells, a lambda > 0 for every column.
//
// The middles are eliminated; what is left for the vertices is tridiagonal with constant coefficients, the
// product of two recurrences:
//
//   g (1 - rho S) (1 - rho S^-1) u = b,   S u_c = u_(c-1),   |rho| < 1
//
// on a ring, or on a line with natural ends, which is the even half of a ring of twice the length.
#pragma once

#include <cstddef>
#include <vector>

namespace gaspard {

class ModalLines {
  public:
    /// As many columns as `lambdas`. A column with lambda = 0, which has no solution, comes out as rubbish
    /// that is finite.
    ModalLines(std::size_t cells, bool periodic, const std::vector<double>& lambdas);

    struct Workspace {
        std::vector<double> sum, power;
    };
    static Workspace make_workspace() { return {std::vector<double>(width), std::vector<double>(width)}; }

    /// Columns begin .. end of b, whose rows (2 n of a ring, 2 n + 1 of a line) are `stride` apart; replaced
    /// by the solution.
    void solve(double* b, std::size_t stride, std::size_t begin, std::size_t end, Workspace& workspace) const;

  private:
    static constexpr std::size_t width = 64; ///< columns that go through all rows together, to stay in cache
    struct Block;
    void eliminate_middles(const Block& block) const;
    void solve_ring(const Block& block) const;
    void solve_line(const Block& block) const;
    void restore_middles(const Block& block) const;

    std::size_t cells_;
    bool periodic_;
    // Of every column:
    std::vector<double> coupling_, scale_, rho_, closure_; ///< a_vm / a_mm, 1 / g, rho, 1 / (1 - rho^ring)
    std::vector<double> middle_;                           ///< 1 / a_mm
    std::vector<double> end_;                              ///< 1 / (1 - rho^2)
};

} // namespace gaspard
