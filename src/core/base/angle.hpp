// The angle between two directions in a form that compilers turn into vector instructions.
#pragma once

#include "core/base/points.hpp"

#include <array>
#include <numbers>
#include <utility>

namespace gaspard {

/// Coefficients (1 3 5 ...) / (2 4 6 ...) / (2 k + 1) of the arc sine's Taylor series, the last first. What
/// is left out is below 1e-17 for arguments up to sin(pi / 8).
inline constexpr std::array<double, 19> arc_sine_series = [] {
    std::array<double, 19> c{};
    double product = 1;
    for (std::size_t k = 0; k < c.size(); ++k) {
        c[c.size() - 1 - k] = product / (2.0 * static_cast<double>(k) + 1);
        product *= (2.0 * static_cast<double>(k) + 1) / (2.0 * static_cast<double>(k) + 2);
    }
    return c;
}();

/// Arc sine for 0 <= y <= sin(pi / 8), to a few units in the last place.
inline double small_arc_sine(double y) {
    const double t = y * y;
    double sum = 0;
    [&]<std::size_t... k>(std::index_sequence<k...>) { // no loop, or those around it stay as they are
        ((sum = sum * t + arc_sine_series[k]), ...);
    }
    (std::make_index_sequence<arc_sine_series.size()>());
    return y * sum;
}

/// From 0 to pi, right also near both ends. `centre` is of length 1; x, y, z of any but 0.
inline double angle_from(Vec3 centre, double x, double y, double z) {
    const double inverse = 1 / std::sqrt(x * x + y * y + z * z);
    const double along = (x * centre.x + y * centre.y + z * centre.z) * inverse;
    const double side = along >= 0 ? 1.0 : -1.0; // from the centre, or from the place opposite to it
    const double dx = x * inverse - side * centre.x, dy = y * inverse - side * centre.y,
                 dz = z * inverse - side * centre.z;
    const double sine = 0.5 * std::sqrt(dx * dx + dy * dy + dz * dz); // of half of the angle, up to pi / 4
    const double cosine = std::sqrt(1 - sine * sine);
    const double quarter = sine / std::sqrt(2 * (1 + cosine));
    const double angle = 4 * small_arc_sine(quarter);
    return along >= 0 ? angle : std::numbers::pi - angle;
}

} // namespace gaspard
