#include "core/method/relax.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(Threads, DoNotChangeTheResult) {
    for (const bool periodic : {true, false}) {
        State first;
        for (const int threads : {1, 2, 3}) { // the plane is large enough for two
            Relaxing run(240, periodic, make_monitor("ring", {}, {{"center_x", 0.4}}), 0.1);
            run.method->use_threads(threads);
            run.method->evaluate(problem_of(*run.monitor), run.state, {});
            for (int i = 0; i < 3; ++i) run.step();
            if (threads == 1) first = run.state;
            EXPECT_EQ(run.state, first) << threads;
            EXPECT_EQ(run.method->other_cpu_seconds() > 0, threads > 1);
        }
    }
}

} // namespace
} // namespace gaspard
