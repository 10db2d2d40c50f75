// Values of monitors, and their gradients beside differences of them.
#pragma once

#include "core/monitor/monitor.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace gaspard {

inline std::vector<double> values_of(const Monitor& monitor, const Points& x) {
    std::vector<double> values(x.size(), -7);
    monitor.values(x, values);
    return values;
}

/// Some points of the unit square or of the unit sphere.
inline Points points_of(const Space& space, std::size_t count = 60) {
    Points x(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(count);
        const Vec3 p{std::cos(7 * t), std::sin(7 * t), 2 * t - 0.9};
        x.set(i, space.kind == SpaceKind::sphere
                     ? (1 / norm(p)) * p
                     : Vec3{std::fmod(7.3 * t, 1.0), std::fmod(0.13 + 3.1 * t, 1.0), 0});
    }
    return x;
}

/// The gradients along one direction, tangential on a sphere, to `tolerance` of 1 + the slope.
inline void expect_gradients_of_values(const Monitor& monitor, const Space& space, const Points& x,
                                       double tolerance) {
    Points gradients;
    monitor.gradients(x, gradients);
    ASSERT_EQ(gradients.size(), x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        Vec3 along{0.6, -0.8, 0};
        if (space.kind == SpaceKind::sphere) along = along - dot(along, x[i]) * x[i];
        const double e = 1e-6;
        Points there(2);
        there.set(0, x[i] + e * along), there.set(1, x[i] - e * along);
        const auto m = values_of(monitor, there);
        const double slope = (m[0] - m[1]) / (2 * e);
        EXPECT_NEAR(dot(gradients[i], along), slope, tolerance * (1 + std::abs(slope))) << i;
    }
}

} // namespace gaspard
