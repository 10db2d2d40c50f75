// Random numbers that are the same on every platform: the distributions of the standard library differ
// between implementations, its generators do not.
#pragma once

#include "core/base/parameter.hpp"
#include "core/base/points.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace gaspard {

/// Uniform in [0, 1).
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// A unit vector, uniformly distributed on the sphere if u and v are uniform in [0, 1).
inline Vec3 direction_from(double u, double v) {
    const double z = 2 * u - 1, across = std::sqrt(1 - z * z), angle = 2 * std::numbers::pi * v;
    return {across * std::cos(angle), across * std::sin(angle), z};
}

/// The row of the seed; `what` is what the seed determines.
inline ParameterRow seed_row(const std::string& what) {
    return {.key = "seed",
            .label = "Seed",
            .kind = ParameterKind::integer,
            .minimum = 0,
            .maximum = 1e9,
            .default_value = std::int64_t{1},
            .help = "determines " + what + "; `gaspard run --seed` sets it",
            .role = ParameterRole::seed};
}

} // namespace gaspard
