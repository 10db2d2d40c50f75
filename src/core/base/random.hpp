// Random numbers that are the same on every platform: the distributions of the standard library differ
// between implementations, its generators do not.
#pragma once

#include <random>

namespace gaspard {

/// Uniform in [0, 1).
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

} // namespace gaspard
