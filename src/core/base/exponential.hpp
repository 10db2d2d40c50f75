// An exponential that compilers vectorise: no branches, tables or calls.
#pragma once

#include <bit>
#include <cstdint>

namespace gaspard {

/// exp(t) for t <= 0, to about two units in the last place. Returns 0 for t < -708 and NaN for NaN.
/// The result is undefined for t > 700.
inline double exponential(double t) {
    // t = k ln 2 + r, |r| <= ln 2 / 2; adding 1.5 * 2^52 leaves the integer k in the lowest bits.
    constexpr double round = 6755399441055744.0; // 1.5 * 2^52
    constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
    const double shifted = t * 1.44269504088896340736 + round;
    const double k = shifted - round;
    const double r = (t - k * ln2_high) - k * ln2_low;
    double sum = 1.0 / 6227020800; // Taylor polynomial of degree 13: the next term is below 1e-17
    sum = sum * r + 1.0 / 479001600;
    sum = sum * r + 1.0 / 39916800;
    sum = sum * r + 1.0 / 3628800;
    sum = sum * r + 1.0 / 362880;
    sum = sum * r + 1.0 / 40320;
    sum = sum * r + 1.0 / 5040;
    sum = sum * r + 1.0 / 720;
    sum = sum * r + 1.0 / 120;
    sum = sum * r + 1.0 / 24;
    sum = sum * r + 1.0 / 6;
    sum = sum * r + 0.5;
    sum = sum * r + 1.0;
    sum = sum * r + 1.0;
    const std::uint64_t exponent = (std::bit_cast<std::uint64_t>(shifted) + 1023) << 52;
    return t < -708 ? 0.0 : sum * std::bit_cast<double>(exponent);
}

/// The integer nearest to t, |t| < 2^51; ties go to the even integer.
inline double nearest_whole(double t) {
    constexpr double round = 6755399441055744.0;
    return (t + round) - round;
}

} // namespace gaspard
