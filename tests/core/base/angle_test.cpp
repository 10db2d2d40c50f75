#include "core/base/angle.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(Angle, MatchesLongDouble) {
    const Vec3 centre = (1 / norm(Vec3{1, 2, 3})) * Vec3{1, 2, 3};
    const Vec3 a = cross(centre, {0, 0, 1}), across = (1 / norm(a)) * a;
    for (int i = 0; i <= 2000; ++i) {
        const double angle = std::numbers::pi * i / 2000;
        for (const double length : {1.0, 1e-3, 6371e3}) {
            const Vec3 p = length * (std::cos(angle) * centre + std::sin(angle) * across);
            EXPECT_NEAR(angle_from(centre, p.x, p.y, p.z), angle, 1e-15 * (1 + angle));
        }
    }
}

TEST(Angle, IsAccurateNearZeroAndPi) {
    for (const double small : {1e-3, 1e-8, 1e-12}) {
        EXPECT_NEAR(angle_from({0, 0, 1}, small, 0, 1) / std::atan(small), 1, 1e-14);
        EXPECT_NEAR(angle_from({0, 0, 1}, small, 0, -1), std::numbers::pi - std::atan(small), 1e-15);
    }
    EXPECT_EQ(angle_from({0, 0, 1}, 0, 0, 2), 0);
    EXPECT_EQ(angle_from({0, 0, 1}, 0, 0, -2), std::numbers::pi);
}

TEST(Angle, ArcSineIsAccurateOnItsInterval) {
    for (int i = 0; i <= 1000; ++i) {
        const double y = std::sin(std::numbers::pi / 8) * i / 1000;
        EXPECT_NEAR(small_arc_sine(y), std::asin(y), 1e-16);
    }
}

} // namespace
} // namespace gaspard
