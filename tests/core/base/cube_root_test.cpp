#include "core/base/cube_root.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

TEST(CubeRoot, IsAccurateOverAllMagnitudes) {
    double error = 0;
    for (double x = 1e-299; x < 1e307; x *= 1.0123) {
        const double exact = std::cbrt(x);
        error = std::max(error, std::abs(cube_root(x) - exact) / exact);
    }
    for (double x = 0.5; x < 8.5; x += 1e-4)
        error = std::max(error, std::abs(cube_root(x) - std::cbrt(x)) / std::cbrt(x));
    EXPECT_LT(error, 3.5 * std::numeric_limits<double>::epsilon());
}

TEST(CubeRoot, OfZeroIsZeroAndOfNothingNothing) {
    EXPECT_EQ(cube_root(0), 0);
    EXPECT_EQ(cube_root(1e-310), 0);
    EXPECT_TRUE(std::isnan(cube_root(std::numeric_limits<double>::quiet_NaN())));
    EXPECT_DOUBLE_EQ(cube_root(27), 3);
}

} // namespace
} // namespace gaspard
