#include "core/tessellate/extremes.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace gaspard {
namespace {

TEST(Extremes, AgreeWithALinearSearchOfAnyRange) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-2, 5);
    std::vector<double> column;
    Extremes extremes;
    for (int i = 0; i < 1000; ++i) {
        column.push_back(i % 11 == 0 ? std::nan("") : i % 13 == 0 ? 1.0 / 0.0 : value(random));
        extremes.append(column.back());
    }
    EXPECT_EQ(extremes.size(), column.size());
    std::uniform_int_distribution<std::size_t> place(0, column.size());
    for (int trial = 0; trial < 2000; ++trial) {
        std::size_t begin = place(random), end = place(random);
        if (begin > end) std::swap(begin, end);
        Extent slow;
        for (std::size_t i = begin; i < end; ++i) slow.add(column[i]);
        const Extent fast = extremes.of(column, begin, end);
        ASSERT_EQ(fast.min, slow.min) << begin << " to " << end;
        ASSERT_EQ(fast.max, slow.max) << begin << " to " << end;
        ASSERT_EQ(fast.min_positive, slow.min_positive) << begin << " to " << end;
    }
    EXPECT_EQ(extremes.all().max, extremes.of(column, 0, column.size()).max);
    EXPECT_EQ(extremes.all().min_positive, extremes.of(column, 0, column.size()).min_positive);
}

TEST(Extremes, AreEmptyForNoValues) {
    Extremes extremes;
    EXPECT_TRUE(extremes.all().empty());
    EXPECT_TRUE(extremes.of({}, 0, 0).empty());
    extremes.append(std::nan(""));
    EXPECT_TRUE(extremes.all().empty()) << "what is not a number does not count";
    extremes.append(-3);
    EXPECT_EQ(extremes.all().max, -3);
    EXPECT_EQ(extremes.all().min_positive, std::numeric_limits<double>::infinity());
    extremes.clear();
    EXPECT_TRUE(extremes.all().empty());
    EXPECT_EQ(extremes.size(), 0U);
}

} // namespace
} // namespace gaspard
