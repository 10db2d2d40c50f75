#include "core/scenario/toml.hpp"
#include "gui/document.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <thread>

namespace gaspard {
namespace {

constexpr auto patience = std::chrono::seconds(60);

/// A small ring that is solved in a moment.
Scenario small_ring(const Catalogue& catalogue) {
    Scenario scenario = find_scenario(catalogue, "plane-ring");
    set_value(catalogue, scenario, "domain.cells", std::int64_t{12});
    set_value(catalogue, scenario, "method.max_iterations", std::int64_t{40});
    return scenario;
}

class DocumentTest : public testing::Test {
  protected:
    template <class Condition>
    bool wait_until(Condition condition) {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (std::chrono::steady_clock::now() < end) {
            document.collect();
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return false;
    }
    DocumentRun& run() { return document.runs().front(); }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    std::atomic<int> notified = 0;
    Document document{catalogue, [this] { ++notified; }};
};

TEST_F(DocumentTest, KeepsEveryReportInOrderAndPlotsIt) {
    document.open(small_ring(*catalogue));
    ASSERT_EQ(document.viewports().size(), 1U);
    EXPECT_EQ(document.viewports().front().run, 0U);
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto& history = run().history;
    ASSERT_EQ(history.size(), 41U);
    for (std::size_t i = 0; i < history.size(); ++i) EXPECT_EQ(history[i].iteration, static_cast<int>(i));
    const HistoryCurves& curves = run().curves;
    ASSERT_EQ(curves.residual.values.size(), history.size());
    EXPECT_EQ(curves.residual.values[7], history[7].residual);
    EXPECT_EQ(curves.residual.seconds[7], history[7].seconds);
    EXPECT_EQ(curves.equidistribution.values[40], *history[40].equidistribution);
    EXPECT_EQ(curves.max_jacobian.values[40], *history[40].max_jacobian);
    EXPECT_EQ(curves.step_size.values.size(), 40U) << "no step led to the start";
    EXPECT_GT(notified, 0);
    ASSERT_NE(run().snapshot, nullptr);
    EXPECT_EQ(run().snapshot->report.iteration, 40);
    EXPECT_GT(*iteration_rate(history), 0);
}

TEST_F(DocumentTest, AChangeGoesOnAndAResetBeginsAnew) {
    document.open(small_ring(*catalogue));
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 20.0);
    document.change(0, changed);
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().history.back().iteration == 80; }));
    document.reset(0);
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    EXPECT_EQ(run().history.front().iteration, 0);
    EXPECT_EQ(run().curves.residual.values.size(), 1U);
    EXPECT_FALSE(run().wants_to_run) << "a run that had ended rests after a reset";
    document.start(0);
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().history.back().iteration == 40; }));
}

TEST_F(DocumentTest, RunsDifferInColour) {
    document.open(small_ring(*catalogue));
    document.open(find_scenario(*catalogue, "plane-bell"));
    document.pause(1);
    ASSERT_TRUE(wait_until([&] { return run().ended() && !document.runs()[1].history.empty(); }));
    EXPECT_EQ(document.viewports()[1].run, 1U);
    EXPECT_NE(document.runs()[0].colour, document.runs()[1].colour);
}

TEST(IterationRate, LooksAtTheLastSecondOnly) {
    std::vector<StepReport> history(1);
    EXPECT_FALSE(iteration_rate(history).has_value());
    for (int i = 1; i <= 10; ++i) history.push_back({.iteration = i, .seconds = 1.0 * i}); // one per second
    for (int i = 1; i <= 100; ++i) history.push_back({.iteration = 10 + i, .seconds = 10 + 0.05 * i});
    EXPECT_NEAR(*iteration_rate(history), 20, 1);
}

} // namespace
} // namespace gaspard
