// A cube root that compilers vectorise: no branches, tables or calls.
#pragma once

#include <bit>
#include <cstdint>

namespace gaspard {

/// x^(1/3) for 0 <= x <= 1e307, to about three units in the last place. Returns 0 for x < 1e-300 and NaN for
/// NaN.
inline double cube_root(double x) {
    // A third of the bits, exponent first, gives y to 3.5 %; the product divides numbers below 2^31 by 3.
    const std::uint64_t high = std::bit_cast<std::uint64_t>(x) >> 32;
    double y = std::bit_cast<double>((((high * 0x55555556) >> 32) + 0x2a9f7893) << 32);
    // Halley's iteration; an error e becomes 2/3 e^3: 3e-5, 1e-14, rounding.
    for (int step = 0; step < 3; ++step) {
        const double cube = y * y * y;
        y *= (cube + 2 * x) / (2 * cube + x);
    }
    return x < 1e-300 ? 0.0 : y;
}

} // namespace gaspard
