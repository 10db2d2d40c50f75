#include "core/scenario/toml.hpp"
#include "gui/document/document.hpp"

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
    const auto trace = [&](const char* name) { return curves.find(name)->trace; };
    ASSERT_EQ(trace("residual").values.size(), history.size());
    EXPECT_EQ(trace("residual").values[7], history[7].residual);
    EXPECT_EQ(trace("residual").seconds[7], history[7].seconds);
    EXPECT_EQ(trace("equidistribution").values[40], *history[40].value("equidistribution"));
    EXPECT_EQ(trace("max_jacobian").values[40], *history[40].value("max_jacobian"));
    EXPECT_EQ(trace("step_size").values.size(), 40U) << "no step led to the start";
    EXPECT_EQ(trace("theta").values[7], *history[7].value("theta"));
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
    EXPECT_EQ(run().curves.find("residual")->trace.values.size(), 1U);
    EXPECT_FALSE(run().wants_to_run) << "a run that had ended rests after a reset";
    document.start(0);
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().history.back().iteration == 40; }));
}

TEST_F(DocumentTest, AKeptRunStaysWhileTheLiveOneGoesOn) {
    document.open(small_ring(*catalogue));
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    ASSERT_EQ(document.keep(0), 1U);
    EXPECT_EQ(document.runs()[1].name, "Ring");
    EXPECT_FALSE(document.runs()[1].live());
    EXPECT_NE(document.runs()[1].colour, run().colour);
    const auto snapshot = run().snapshot;

    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 20.0);
    document.change(0, changed);
    EXPECT_EQ(run().name, "Ring, amplitude 20");
    document.reset(0);
    document.start(0);
    const DocumentRun& kept = document.runs()[1];
    ASSERT_TRUE(wait_until([&] {
        return run().ended() && run().history.size() == 41 &&
               run().history[40].residual != kept.history[40].residual;
    }));
    EXPECT_EQ(kept.history.size(), 41U);
    EXPECT_EQ(kept.curves.find("residual")->trace.values[40], kept.history[40].residual);
    EXPECT_LT(kept.history[40].residual, run().history[40].residual);
    EXPECT_EQ(kept.snapshot, snapshot) << "its mesh can still be looked at";
    EXPECT_EQ(kept.scenario.monitor.values.real("amplitude"), 10);
    EXPECT_TRUE(kept.ended());

    ASSERT_EQ(document.keep(0), 2U);
    EXPECT_EQ(document.runs()[2].name, "Ring, amplitude 20");
    EXPECT_EQ(document.runs()[2].scenario.monitor.values.real("amplitude"), 20);
    ASSERT_EQ(document.keep(0), 3U);
    EXPECT_EQ(document.runs()[3].name, "Ring, amplitude 20 (2)") << "no two have the same name";
}

TEST_F(DocumentTest, OfARemovedRunNothingRemains) {
    document.open(small_ring(*catalogue));
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    document.keep(0), document.keep(0);
    const std::size_t colour = document.runs()[1].colour;
    document.viewports().push_back({.run = 1, .view = run().scenario.view});
    document.viewports().push_back({.run = 2, .view = run().scenario.view});
    document.remove(1);
    ASSERT_EQ(document.runs().size(), 2U);
    EXPECT_EQ(document.runs()[1].name, "Ring (2)");
    EXPECT_EQ(document.viewports()[1].run, 0U) << "what it looked at is gone";
    EXPECT_EQ(document.viewports()[2].run, 1U) << "the same run as before";
    document.keep(0);
    EXPECT_EQ(document.runs()[2].colour, colour) << "its colour is free again";
}

TEST_F(DocumentTest, ARunThatHasDoneNothingIsNotKept) {
    Scenario refused = small_ring(*catalogue);
    refused.method.type = "magic";
    document.open(refused);
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_FALSE(document.keep(0));
    EXPECT_EQ(document.runs().size(), 1U);
}

TEST_F(DocumentTest, AChangeOfValuesMarksTheHistory) {
    document.open(small_ring(*catalogue));
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_TRUE(run().marks.empty());
    Scenario changed = run().scenario;
    for (const double amplitude : {12.0, 15.0, 20.0}) { // a slider being dragged
        set_value(*catalogue, changed, "monitor.amplitude", amplitude);
        document.change(0, changed);
        ASSERT_TRUE(wait_until([&] { return run().answered == run().asked; }));
    }
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().history.back().iteration >= 80; }));
    ASSERT_EQ(run().marks.size(), 1U);
    EXPECT_EQ(run().marks[0].iteration, 40);
    EXPECT_EQ(run().marks[0].text, "amplitude 10 to 20");
    document.keep(0);
    document.reset(0);
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    EXPECT_TRUE(run().marks.empty());
    EXPECT_EQ(document.runs()[1].marks.size(), 1U);
}

TEST_F(DocumentTest, RunsDifferInColour) {
    document.open(small_ring(*catalogue));
    document.open(find_scenario(*catalogue, "plane-bell"));
    document.pause(1);
    ASSERT_TRUE(wait_until([&] { return run().ended() && !document.runs()[1].history.empty(); }));
    EXPECT_EQ(document.viewports()[1].run, 1U);
    EXPECT_NE(document.runs()[0].colour, document.runs()[1].colour);
}

TEST_F(DocumentTest, AComparisonLeavesAloneWhatTheFirstRunHasDoneMeanwhile) {
    Scenario endless = small_ring(*catalogue);
    set_value(*catalogue, endless, "method.tolerance", 1e-14);
    set_value(*catalogue, endless, "method.max_iterations", std::int64_t{1000000});
    set_value(*catalogue, endless, "method.step_size", 1e-4);
    document.open(endless);
    ASSERT_TRUE(wait_until([&] { return run().solving(); }));
    document.compare({"relaxation"});
    ASSERT_TRUE(wait_until([&] { return run().status.paused && document.runs()[1].history.size() > 1; }));
    EXPECT_FALSE(run().solving());
    document.replace(0, small_ring(*catalogue)); // another scenario is opened, and solved
    ASSERT_TRUE(wait_until([&] { return run().openings == 1 && run().ended(); }));
    ASSERT_EQ(run().history.size(), 41U);
    const auto solved = run().snapshot;
    ASSERT_TRUE(document.comparing());
    document.cancel_comparison();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_EQ(run().snapshot, solved) << "it was thrown away";
    EXPECT_EQ(run().history.size(), 41U);
}

TEST_F(DocumentTest, AComparisonDoesNotWakeARunThatWasPausedMeanwhile) {
    Scenario endless = small_ring(*catalogue);
    set_value(*catalogue, endless, "method.tolerance", 1e-14);
    set_value(*catalogue, endless, "method.max_iterations", std::int64_t{1000000});
    set_value(*catalogue, endless, "method.step_size", 1e-4);
    document.open(endless);
    ASSERT_TRUE(wait_until([&] { return run().solving(); }));
    document.compare({"relaxation"});
    document.start(0);
    document.pause(0);
    document.cancel_comparison();
    EXPECT_FALSE(run().wants_to_run);
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
