// Formulas that several threads read.
#include "core/function/expression.hpp"

#include <barrier>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace gaspard {
namespace {

/// Alone in its process, so that no number was read before. ThreadSanitizer looks on.
TEST(ExpressionThreads, TheFirstFormulasMayBeReadAtOnce) {
    constexpr int count = 4;
    std::barrier start(count);
    std::vector<double> values(count);
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < count; ++i)
            threads.emplace_back([&, i] {
                start.arrive_and_wait();
                const ExpressionFunction function(Expression("1.5 + 0.25*x", {}), {});
                Points at(1);
                at.x[0] = i;
                function.values(at, {}, {&values[static_cast<std::size_t>(i)], 1});
            });
    }
    EXPECT_EQ(values, (std::vector<double>{1.5, 1.75, 2, 2.25}));
}

} // namespace
} // namespace gaspard
