// Eigenvalues of a symmetric matrix of size 2:
//
//   lambda_min, lambda_max = (xx + yy)/2 -+ sqrt(((xx - yy)/2)^2 + xy^2)
#pragma once

#include <cmath>

namespace gaspard {

struct Eigenvalues2 {
    double smallest, largest;
};

inline Eigenvalues2 symmetric_eigenvalues(double xx, double xy, double yy) {
    const double mean = (xx + yy) / 2, half = (xx - yy) / 2;
    const double radius = std::sqrt(half * half + xy * xy);
    return {mean - radius, mean + radius};
}

} // namespace gaspard
