// The Poisson problem of tensor-product quadratic elements on the unit square, by fast diagonalisation in one
// direction and elimination in the other:
//
//   (K (x) M + M (x) K) u = b,   b^ = S^T b along y:   (K + lambda M) u^ = b^ along x, for every lambda,
//   u = S u^,   mean of u = 0
//
// The constant is the kernel: the mean of b (against the function 1) is left out.
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
            std::vector<double> batch; ///< of eight lines
        };
        std::vector<Worker> workers;
        std::vector<double> modes; ///< b^, then u^: lines along x as rows, modes as columns
    };
    Workspace make_workspace(std::size_t workers = 1) const;

    /// b and u: size x size values, x running fastest. May be the same array. The room is for as many workers
    /// as the team has, or more; the result does not depend on how many.
    void solve(const double* b, double* u, Workspace& workspace, Team& team) const;

  private:
    void solve_constant_mode(Workspace& workspace) const;

    LineSpectrum line_;
    ModalLines modal_;
};

} // namespace gaspard
