// A cosine that compilers vectorise: no branches, tables or calls.
#pragma once

#include "core/base/exponential.hpp"

#include <cmath>
#include <numbers>

namespace gaspard {

/// cos(2 pi t) for |t| < 2^51, with an error below 4e-16. NaN for what is not finite.
inline double cosine_of_turns(double t) {
    // sin x for |x| <= pi / 2, by its Taylor polynomial of degree 21: the next term is below 2e-18.
    const double x = 2 * std::numbers::pi * (0.25 - std::abs(t - nearest_whole(t))), square = x * x;
    double sum = 1.0 / 51090942171709440000.0;
    sum = sum * square - 1.0 / 121645100408832000.0;
    sum = sum * square + 1.0 / 355687428096000.0;
    sum = sum * square - 1.0 / 1307674368000.0;
    sum = sum * square + 1.0 / 6227020800.0;
    sum = sum * square - 1.0 / 39916800.0;
    sum = sum * square + 1.0 / 362880.0;
    sum = sum * square - 1.0 / 5040.0;
    sum = sum * square + 1.0 / 120.0;
    sum = sum * square - 1.0 / 6.0;
    return x + x * (square * sum);
}

} // namespace gaspard
