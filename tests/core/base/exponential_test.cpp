#include "core/base/exponential.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

TEST(Exponential, MatchesTheLibraryToTwoUlps) {
    for (double t = 0; t > -700; t -= 0.0137) {
        const double expected = std::exp(t);
        ASSERT_NEAR(exponential(t), expected, 2 * std::numeric_limits<double>::epsilon() * expected) << t;
    }
    EXPECT_EQ(exponential(0), 1);
    EXPECT_EQ(exponential(-0.0), 1);
}

TEST(Exponential, UnderflowsToZero) {
    for (const double t : {-708.0, -709.0, -1e4, -1e300, -std::numeric_limits<double>::infinity()}) {
        EXPECT_GE(exponential(t), 0) << t;
        EXPECT_LT(exponential(t), 1e-307) << t;
    }
    EXPECT_TRUE(std::isnan(exponential(std::nan(""))));
}

TEST(NearestWhole, RoundsToTheNearestInteger) {
    for (double t = -3.49; t < 3.5; t += 0.03) EXPECT_EQ(nearest_whole(t), std::round(t)) << t;
    EXPECT_EQ(nearest_whole(0.5), 0);
    EXPECT_EQ(nearest_whole(1.5), 2);
    EXPECT_EQ(nearest_whole(-1e9 - 0.3), -1e9);
    EXPECT_TRUE(std::isnan(nearest_whole(std::nan(""))));
}

} // namespace
} // namespace gaspard
