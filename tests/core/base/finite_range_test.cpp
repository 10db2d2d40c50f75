#include "core/base/finite_range.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace gaspard {
namespace {

TEST(FiniteRange, FindsMinimumAndMaximumAtAnyIndex) {
    for (std::size_t size = 1; size < 35; ++size)
        for (std::size_t at = 0; at < size; ++at)
            for (const double value : {-2.0, 7.0}) {
                std::vector<double> values(size, 1.5);
                values[at] = value;
                const auto range = finite_range(values);
                ASSERT_TRUE(range);
                EXPECT_EQ(range->first, size == 1 ? value : std::min(value, 1.5));
                EXPECT_EQ(range->second, size == 1 ? value : std::max(value, 1.5));
            }
}

TEST(FiniteRange, IsEmptyForNoValuesAndForNonFiniteValues) {
    EXPECT_FALSE(finite_range({}));
    using limits = std::numeric_limits<double>;
    for (const double strange : {limits::quiet_NaN(), limits::infinity(), -limits::infinity()})
        for (std::size_t at = 0; at < 19; ++at) {
            std::vector<double> values(19, 3);
            values[at] = strange;
            EXPECT_FALSE(finite_range(values)) << strange << " at " << at;
        }
    EXPECT_TRUE(finite_range(std::vector<double>(19, limits::max())));
}

} // namespace
} // namespace gaspard
