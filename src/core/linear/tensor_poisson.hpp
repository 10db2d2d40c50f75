// Poisson problem of tensor-product quadratic elements on the unit square, by fast diagonalisation in y and
// tridiagonal elimination in x:
//
//   (K (x) M + M (x) K) u = b,     mean of u = 0
//
//   b^ = S^T b along y,     (K + lambda M) u^ = b^ along x for every lambda,     u = S u^
//
// The kernel consists of the constants; the mean of b is dropped.
#pragma once

#include "core/base/team.hpp"
#include "core/linear/line_spectrum.hpp"
#include "core/linear/modal_lines.hpp"

#include <vector>

namespace gaspard {

class TensorPoisson {
  public:
    /// The same line in both directions.
    explicit TensorPoisson(LineSpectrum line);

    struct Workspace {
        struct Worker {
            LineSpectrum::Workspace line;
            ModalLines::Workspace modal;
            std::vector<double> batch; ///< eight lines
        };
        std::vector<Worker> workers;
        std::vector<double> modes; ///< b^, then u^: rows are lines along x, columns are modes
    };
    Workspace make_workspace(std::size_t workers = 1) const;

    /// b and u: size x size values, x fastest; they may be the same array. The workspace must have at least
    /// as many workers as the team. The result does not depend on the number of workers.
    void solve(const double* b, double* u, Workspace& workspace, Team& team) const;

  private:
    void solve_constant_mode(Workspace& workspace) const;

    LineSpectrum line_;
    ModalLines modal_;
};

} // namespace gaspard
