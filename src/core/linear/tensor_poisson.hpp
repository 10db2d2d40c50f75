// The Poisson problem of tensor-product quadratic elements on the unit square, by fast diagonalisation:
//
//   (K (x) M + M (x) K) u = b  <=>  u = (S (x) S) (lambda_i + lambda_j)^-1 (S (x) S)^T b,   mean of u = 0
//
// The constant is the kernel: the mean of b (against the function 1) is left out.
#pragma once

#include "core/linear/line_spectrum.hpp"

#include <vector>

namespace gaspard {

class TensorPoisson {
  public:
    /// The same line in both directions.
    explicit TensorPoisson(LineSpectrum line);

    struct Room {
        LineSpectrum::Room line;
        std::vector<double> first, second;
    };
    Room make_room() const;

    /// b and u: size x size values, x running fastest. May be the same array.
    void solve(const double* b, double* u, Room& room) const;

  private:
    LineSpectrum line_;
};

} // namespace gaspard
