// Random directions, and the row of the seed.
#pragma once

#include "core/base/parameter.hpp"
#include "core/base/points.hpp"
#include "core/base/random.hpp"

#include <cmath>
#include <numbers>

namespace gaspard {

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
