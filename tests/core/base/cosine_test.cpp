#include "core/base/cosine.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace gaspard {
namespace {

TEST(Cosine, IsThatOfTheLibrary) {
    double error = 0;
    for (double t = -3; t < 3; t += 1e-4) {
        const long double exact = std::cos(2 * std::numbers::pi_v<long double> * static_cast<long double>(t));
        error = std::max(error, std::abs(static_cast<double>(cosine_of_turns(t) - exact)));
    }
    EXPECT_LT(error, 4e-16);
}

TEST(Cosine, IsPeriodicWithoutRounding) {
    EXPECT_EQ(cosine_of_turns(0.25), 0);
    EXPECT_EQ(cosine_of_turns(1e9 + 0.25), 0);
    EXPECT_EQ(cosine_of_turns(0.125), cosine_of_turns(-7.125));
    EXPECT_NEAR(cosine_of_turns(12345), 1, 4e-16);
    EXPECT_NEAR(cosine_of_turns(0.5), -1, 4e-16);
    EXPECT_TRUE(std::isnan(cosine_of_turns(std::numeric_limits<double>::infinity())));
}

} // namespace
} // namespace gaspard
