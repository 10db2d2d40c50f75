// The angle between two directions, written so that compilers vectorise it.
#pragma once

#include "core/base/points.hpp"

#include <array>
#include <numbers>
#include <utility>

namespace gaspard {

/// Coefficients of the Taylor series of the arcsine, highest order first:
///
///     c_k = (1 3 5 ... (2k - 1)) / (2 4 6 ... (2k)) / (2k + 1),   k = 0 .. 18.
///
/// The truncation error is below 1e-17 for arguments up to sin(pi / 8).
inline constexpr std::array<double, 19> arc_sine_series = [] {
    std::array<double, 19> c{};
    double product = 1;
    for (std::size_t k = 0; k < c.size(); ++k) {
        c[c.size() - 1 - k] = product / (2.0 * static_cast<double>(k) + 1);
        product *= (2.0 * static_cast<double>(k) + 1) / (2.0 * static_cast<double>(k) + 2);
    }
    return c;
}();

/// asin(y) for 0 <= y <= sin(pi / 8), to a few units in the last place.
inline double small_arc_sine(double y) {
    const double t = y * y;
    double sum = 0;
    [&]<std::size_t... k>(std::index_sequence<k...>) { // unrolled, so that outer loops vectorise
        ((sum = sum * t + arc_sine_series[k]), ...);
    }
    (std::make_index_sequence<arc_sine_series.size()>());
    return y * sum;
}

/// The angle in [0, pi] between the unit vector `centre` and the nonzero vector (x, y, z); accurate near 0
/// and near pi. `centre` must have length 1; (x, y, z) may have any length.
inline double angle_from(Vec3 centre, double x, double y, double z) {
    const double inverse = 1 / std::sqrt(x * x + y * y + z * z);
    const double along = (x * centre.x + y * centre.y + z * centre.z) * inverse;
    const double side = along >= 0 ? 1.0 : -1.0; // measure from centre or from -centre, whichever is nearer
    const double dx = x * inverse - side * centre.x, dy = y * inverse - side * centre.y,
                 dz = z * inverse - side * centre.z;
    const double sine = 0.5 * std::sqrt(dx * dx + dy * dy + dz * dz); // sin(half angle), half angle <= pi / 4
    const double cosine = std::sqrt(1 - sine * sine);
    const double quarter = sine / std::sqrt(2 * (1 + cosine));
    const double angle = 4 * small_arc_sine(quarter);
    return along >= 0 ? angle : std::numbers::pi - angle;
}

} // namespace gaspard
