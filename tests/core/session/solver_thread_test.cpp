#include "core/base/error.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/solver_thread.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <gtest/gtest.h>
#include <memory>
#include <thread>

namespace gaspard {
namespace {

using namespace std::chrono_literals;

class SolverThreadTest : public testing::Test {
  protected:
    Scenario scenario(const std::vector<std::string>& settings = {}) {
        Scenario result = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, result, {"domain.cells=12"});
        apply_settings(*catalogue, result, settings);
        return result;
    }
    /// Waits for a condition; false if it does not hold in time.
    static bool eventually(const std::function<bool()>& condition, std::chrono::seconds limit = 10s) {
        for (const auto end = std::chrono::steady_clock::now() + limit;
             std::chrono::steady_clock::now() < end;) {
            if (condition()) return true;
            std::this_thread::sleep_for(1ms);
        }
        return false;
    }
    /// Waits until the thread has done all commands posted before.
    static void settle(SolverThread& thread) {
        std::promise<void> done;
        thread.post(InspectCommand{[&](gaspard::Run&, const Activity&) { done.set_value(); }});
        ASSERT_EQ(done.get_future().wait_for(10s), std::future_status::ready);
    }
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(SolverThreadTest, SolvesAndReportsEveryIteration) {
    std::atomic<int> notices = 0;
    SolverThread thread(catalogue, scenario(), {.notify = [&] { ++notices; }});
    ASSERT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
    const auto events = thread.drain();
    ASSERT_GT(events.size(), 10u);
    EXPECT_EQ(events.front().kind, SolverEventKind::restart);
    for (std::size_t i = 0; i < events.size(); ++i)
        EXPECT_EQ(events[i].report.iteration, static_cast<int>(i));
    EXPECT_EQ(thread.latest()->report.iteration, events.back().report.iteration);
    EXPECT_EQ(events.back().report.status, RunStatus::converged);
    EXPECT_GT(notices.load(), 0);
}

TEST_F(SolverThreadTest, ReportsEveryTimeStepAlthoughTheRunForgetsSome) {
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, scenario,
                   {"method.type=newton", "domain.cells=8", "monitor.amplitude=0.5", "time.end=10",
                    "time.step=1e-3", "method.diagnostics_every=5", "method.interpolation=false"});
    SolverThread thread(catalogue, scenario, {});
    int next = 0;
    bool final = false, in_order = true;
    const auto drained = [&] {
        for (const SolverEvent& event : thread.drain()) {
            if (event.kind == SolverEventKind::completion) continue;
            in_order = in_order && event.report.iteration == next++;
            final = is_final(event.report.status);
        }
        return final || !in_order;
    };
    EXPECT_TRUE(eventually(drained, 120s));
    EXPECT_TRUE(in_order) << "before iteration " << next;
    EXPECT_GT(next, 10000);
}

TEST_F(SolverThreadTest, APauseAResetAndAChangeEndALongTimeStep) {
    const Scenario long_steps =
        scenario({"method.type=newton", "time.end=1", "time.rule=iterations", "time.iterations=10000",
                  "domain.cells=120", "time.monitor.radius=radius + t/10"});
    SolverThread thread(catalogue, long_steps, {});
    std::uint64_t before = 0; // the snapshot that was shown before the values changed
    const auto moving = [&] {
        thread.drain();
        const auto now = thread.latest();
        return now && now->version > before && thread.status().run == RunStatus::running &&
               now->report.residual < 1e-8;
    };
    ASSERT_TRUE(eventually(moving));
    std::this_thread::sleep_for(20ms); // in the time step, which takes far longer than is waited for
    thread.post(PauseCommand{});
    ASSERT_TRUE(eventually([&] { return thread.status().paused; }));
    EXPECT_EQ(thread.latest()->report.value("time"), 0.0);
    thread.post(StartCommand{});
    std::this_thread::sleep_for(20ms);
    before = thread.latest()->version;
    Scenario changed = long_steps;
    set_value(*catalogue, changed, "monitor.amplitude", 20.0);
    thread.post(ChangeCommand{.scenario = changed, .number = 1});
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 1; }));
    EXPECT_FALSE(thread.status().refused);
    ASSERT_TRUE(eventually(moving));
    std::this_thread::sleep_for(20ms);
    thread.post(ResetCommand{});
    ASSERT_TRUE(eventually([&] {
        const auto events = thread.drain();
        return std::ranges::any_of(events, [](const SolverEvent& event) {
            return event.kind == SolverEventKind::restart && event.report.residual > 1e-2;
        });
    }));
    ASSERT_TRUE(eventually(moving)) << "and goes on";
    thread.post(StepCommand{});
    std::this_thread::sleep_for(20ms);
}

TEST_F(SolverThreadTest, AChangeThatLeavesTheMeshAsItIsLetsATimeStepGoOn) {
    const Scenario long_steps =
        scenario({"method.type=newton", "time.end=1", "time.rule=iterations", "time.iterations=100",
                  "domain.cells=60", "time.monitor.radius=radius + t/10"});
    SolverThread thread(catalogue, long_steps, {});
    const auto stepped = [&] {
        thread.drain();
        const auto now = thread.latest();
        return now && now->report.value("time").value_or(0) > 0;
    };
    std::uint64_t number = 0;
    ASSERT_TRUE(eventually([&] { // far more often than there are time steps
        Scenario changed = long_steps;
        const bool even = number % 2 == 0;
        apply_settings(*catalogue, changed,
                       {even ? "view.color=area" : "view.color=monitor",
                        even ? "output.formats=obj" : "output.formats=vtu"});
        thread.post(ChangeCommand{.scenario = changed, .number = ++number});
        return stepped();
    }));
    thread.post(PauseCommand{});
    ASSERT_TRUE(eventually([&] { return thread.status().answered == number; })) << "all are answered";
    EXPECT_FALSE(thread.status().refused);
}

TEST_F(SolverThreadTest, StartsPausedStepsPausesAndGoesOn) {
    SolverThread thread(catalogue, scenario(), {.start_running = false});
    ASSERT_TRUE(eventually([&] { return thread.latest() != nullptr; }));
    settle(thread);
    EXPECT_EQ(thread.drain().size(), 1u);
    thread.post(StepCommand{});
    std::promise<int> iteration;
    thread.post(InspectCommand{
        [&](gaspard::Run& run, const Activity&) { iteration.set_value(run.history().back().iteration); }});
    EXPECT_EQ(iteration.get_future().get(), 1) << "commands take effect in their order";
    settle(thread);
    ASSERT_TRUE(eventually([&] { return thread.latest()->report.iteration == 1; }));
    thread.post(StartCommand{});
    ASSERT_TRUE(eventually([&] { return thread.latest()->report.iteration > 5; }));
    thread.post(PauseCommand{});
    settle(thread);
    EXPECT_TRUE(eventually([&] { return thread.status().paused; }));
    const int there = thread.latest()->report.iteration;
    settle(thread);
    EXPECT_EQ(thread.latest()->report.iteration, there);
    thread.post(StartCommand{});
    EXPECT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
}

TEST_F(SolverThreadTest, ResetBeginsANewHistory) {
    SolverThread thread(catalogue, scenario(), {});
    ASSERT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
    thread.drain();
    thread.post(PauseCommand{});
    thread.post(ResetCommand{});
    std::vector<SolverEvent> events; // come after the snapshot
    ASSERT_TRUE(eventually([&] { return !(events = thread.drain()).empty(); }));
    EXPECT_EQ(thread.latest()->report.iteration, 0);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, SolverEventKind::restart);
    EXPECT_EQ(thread.latest()->x, thread.latest()->mesh->nodes);
}

// Whoever waits for the end of a run with new values must not take the end of the one before for it.
TEST_F(SolverThreadTest, ChangedOrResetRunHasNotEndedBeforeItsReportsAreSent) {
    SolverThread* solver = nullptr;
    std::atomic<bool> watched = false;
    std::vector<RunStatus> seen;
    const auto watch = [&](const Snapshot&) {
        if (watched.exchange(false)) seen.push_back(solver->status().run);
    };
    SolverThread thread(catalogue, scenario(), {.before_publishing = watch});
    solver = &thread;
    const auto rests = [&] { return thread.status().run == RunStatus::converged; };
    ASSERT_TRUE(eventually(rests));
    settle(thread);
    watched = true;
    thread.post(ChangeCommand{scenario({"monitor.amplitude=12"}), 1});
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 1 && rests(); }));
    settle(thread);
    watched = true;
    thread.post(ResetCommand{});
    ASSERT_TRUE(eventually([&] { return !watched && rests(); }));
    settle(thread);
    EXPECT_EQ(seen, (std::vector<RunStatus>{RunStatus::running, RunStatus::running}));
}

TEST_F(SolverThreadTest, NobodyTakingReportsHoldsTheRunBackAndLosesNothing) {
    constexpr std::size_t capacity = 4;
    SolverThread thread(catalogue, scenario(), {.report_capacity = capacity});
    // A run that were not held back would do dozens of iterations between two looks at its reports.
    std::vector<SolverEvent> all;
    ASSERT_TRUE(eventually([&] {
        const auto events = thread.drain();
        EXPECT_LE(events.size(), capacity);
        all.insert(all.end(), events.begin(), events.end());
        return !all.empty() && is_final(all.back().report.status);
    }));
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].report.iteration, static_cast<int>(i));
}

/// Whether a thread is gone soon after it was told to end. If not, `let_go` is called so that the test can go
/// on.
bool ends(
    std::unique_ptr<SolverThread> thread, const std::function<void()>& let_go = [] {}) {
    auto ended = std::async(std::launch::async, [&] { thread.reset(); });
    const bool soon = ended.wait_for(10s) == std::future_status::ready;
    let_go();
    return soon;
}

TEST_F(SolverThreadTest, EndsWhileItIsHeldBackAndWhileItRuns) {
    for (const std::size_t capacity : {std::size_t{2}, std::size_t{100000}}) {
        auto thread = std::make_unique<SolverThread>(
            catalogue, scenario({"method.tolerance=1e-14", "method.step_size=0.001"}),
            SolverThread::Options{.report_capacity = capacity});
        // With room for two reports the third cannot be delivered, and the thread waits.
        ASSERT_TRUE(eventually([&] { return thread->latest() && thread->latest()->report.iteration >= 2; }));
        EXPECT_TRUE(ends(std::move(thread))) << capacity;
    }
}

TEST_F(SolverThreadTest, ChangesThatFollowEachOtherAreMergedAndTheLastWins) {
    SolverThread thread(catalogue, scenario(), {.start_running = false});
    ASSERT_TRUE(eventually([&] { return thread.latest() != nullptr; }));
    settle(thread);
    std::promise<void> held, gate;
    thread.post(InspectCommand{[&](gaspard::Run&, const Activity&) { // hold the thread while changes queue up
        held.set_value();
        gate.get_future().wait();
    }});
    held.get_future().wait();
    for (int i = 1; i <= 100; ++i)
        thread.post(ChangeCommand{scenario({"monitor.amplitude=" + std::to_string(i)})});
    gate.set_value();
    double amplitude = 0;
    std::promise<void> done;
    std::size_t rows = 0;
    int epoch = 0;
    thread.post(InspectCommand{[&](gaspard::Run& run, const Activity&) {
        epoch = run.epoch();
        amplitude = run.scenario().monitor.values.real("amplitude");
        rows = run.history().size();
        done.set_value();
    }});
    ASSERT_EQ(done.get_future().wait_for(10s), std::future_status::ready);
    EXPECT_EQ(amplitude, 100);
    EXPECT_EQ(rows, 1U);
    EXPECT_EQ(epoch, 1) << "one change, which begins a history";
}

TEST_F(SolverThreadTest, AConvergedRunGoesOnAfterAChange) {
    SolverThread thread(catalogue, scenario(), {});
    ASSERT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
    thread.drain();
    thread.post(ChangeCommand{scenario({"monitor.amplitude=15"}), 1});
    ASSERT_TRUE(eventually(
        [&] { return thread.status().answered == 1 && thread.status().run == RunStatus::converged; }));
    const auto events = thread.drain();
    ASSERT_GT(events.size(), 2U);
    EXPECT_EQ(events.front().kind, SolverEventKind::change);
    EXPECT_EQ(events.front().report.iteration, 0);
    EXPECT_EQ(events[1].kind, SolverEventKind::step);
    EXPECT_EQ(events[1].report.iteration, 1);
    thread.post(
        ChangeCommand{.scenario = scenario({"monitor.amplitude=16"}), .number = 2, .same_gesture = true});
    ASSERT_TRUE(eventually(
        [&] { return thread.status().answered == 2 && thread.status().run == RunStatus::converged; }));
    EXPECT_EQ(thread.drain().front().kind, SolverEventKind::same_gesture);
}

TEST_F(SolverThreadTest, AnInputErrorIsASentenceAndTheRunGoesOn) {
    SolverThread thread(catalogue, scenario(), {.start_running = false});
    ASSERT_TRUE(eventually([&] { return thread.latest() != nullptr; }));
    Scenario broken = scenario();
    broken.method.type = "magic";
    thread.post(ChangeCommand{broken});
    ASSERT_TRUE(eventually([&] { return thread.status().messages == 1; }));
    const auto messages = thread.take_news().messages;
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_NE(messages[0].text.find("magic"), std::string::npos);
    EXPECT_TRUE(messages[0].error);
    EXPECT_TRUE(thread.take_news().messages.empty());
    thread.post(StartCommand{});
    EXPECT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
}

TEST_F(SolverThreadTest, ABrokenFirstScenarioWaitsForABetterOne) {
    Scenario broken = scenario();
    broken.monitor.type = "nothing";
    SolverThread thread(catalogue, broken, {});
    ASSERT_TRUE(eventually([&] { return thread.status().messages == 1; }));
    EXPECT_EQ(thread.status().run, RunStatus::failed);
    thread.post(StartCommand{});
    thread.post(ChangeCommand{scenario()});
    EXPECT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
}

TEST_F(SolverThreadTest, ARefusedChangeSaysSoAndNamesTheValuesThatRemain) {
    SolverThread thread(catalogue, scenario(), {.start_running = false});
    Scenario broken = scenario();
    broken.method.type = "magic";
    thread.post(ChangeCommand{broken, 7});
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 7; }));
    EXPECT_TRUE(thread.status().refused);
    ASSERT_TRUE(thread.status().scenario);
    EXPECT_EQ(thread.status().scenario->method.type, "relaxation");
    thread.post(ChangeCommand{scenario({"monitor.amplitude=15"}), 8});
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 8; }));
    EXPECT_FALSE(thread.status().refused);
    EXPECT_EQ(thread.status().scenario->monitor.values.real("amplitude"), 15);
}

TEST_F(SolverThreadTest, WhatIsSaidAboutAChangeComesWithItsAnswer) {
    SolverThread* solver = nullptr;
    std::atomic<bool> watched = false;
    std::vector<std::uint64_t> answered;
    SolverThread::Options options{.start_running = false};
    options.notify = [&] {
        if (!watched) return;
        const SolverNews news = solver->take_news();
        if (!news.messages.empty()) answered.push_back(news.status.answered);
    };
    SolverThread thread(catalogue, scenario(), options);
    solver = &thread;
    watched = true;
    Scenario broken = scenario();
    broken.method.type = "magic";
    thread.post(ChangeCommand{broken, 7});
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 7; }));
    thread.post(
        ChangeCommand{scenario(), 8}); // once this is answered, the notice of the answer before has ended
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 8; }));
    watched = false;
    EXPECT_EQ(answered, std::vector<std::uint64_t>{7});
}

/// A catalogue whose plane is not prepared before `slow` becomes false.
std::shared_ptr<const Catalogue> slow_catalogue(std::atomic<bool>& slow) {
    auto catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    auto& prepare = catalogue->capabilities.front().prepare;
    prepare = [&slow, quick = prepare](const PrepareContext& context) {
        while (slow && !context.stop.stop_requested()) {
            context.progress(0.5, "waiting");
            std::this_thread::sleep_for(1ms);
        }
        return quick(context);
    };
    return catalogue;
}

TEST_F(SolverThreadTest, EndsWhileItPrepares) {
    std::atomic<bool> slow = true;
    auto thread = std::make_unique<SolverThread>(slow_catalogue(slow), scenario(), SolverThread::Options{});
    ASSERT_TRUE(eventually([&] { return thread->status().activity == "waiting"; }));
    EXPECT_TRUE(ends(std::move(thread), [&] { slow = false; }));
}

TEST_F(SolverThreadTest, ACancelledChangeLeavesTheRunAsItWas) {
    std::atomic<bool> slow = false;
    SolverThread thread(slow_catalogue(slow), scenario(), {.start_running = false});
    ASSERT_TRUE(eventually([&] { return thread.latest() != nullptr; }));
    slow = true;
    thread.post(ChangeCommand{scenario({"domain.cells=20"}), 1});
    ASSERT_TRUE(eventually([&] { return thread.status().activity == "waiting"; }));
    thread.cancel();
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 1; }));
    EXPECT_TRUE(thread.status().refused);
    EXPECT_EQ(thread.status().scenario->domain.values.integer("cells"), 12);
    EXPECT_TRUE(thread.status().activity.empty());
    thread.post(StartCommand{});
    EXPECT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
}

TEST_F(SolverThreadTest, ACancelledStartBeginsAgainWhenItIsToRun) {
    std::atomic<bool> slow = true;
    SolverThread thread(slow_catalogue(slow), scenario(), {});
    ASSERT_TRUE(eventually([&] { return thread.status().activity == "waiting"; }));
    thread.cancel();
    ASSERT_TRUE(eventually([&] { return thread.status().run == RunStatus::interrupted; }));
    slow = false;
    thread.post(StartCommand{});
    EXPECT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
}

TEST_F(SolverThreadTest, ATaskIsCancelledOnItsOwnAndTheRunGoesOn) {
    SolverThread thread(catalogue, scenario(), {.start_running = false});
    thread.post(InspectCommand{[](gaspard::Run&, const Activity& activity) {
        while (!activity.stop.stop_requested()) {
            activity.progress(0.25, "working");
            std::this_thread::sleep_for(1ms);
        }
        throw Interrupted();
    }});
    ASSERT_TRUE(eventually([&] { return thread.status().activity == "working"; }));
    thread.cancel();
    ASSERT_TRUE(eventually([&] { return thread.status().activity.empty(); }));
    thread.cancel(); // no task to cancel: no effect
    thread.post(StartCommand{});
    EXPECT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
}

TEST_F(SolverThreadTest, AFaultEndsTheRunButNotTheThread) {
    auto broken = std::make_shared<Catalogue>(*catalogue);
    auto& prepare = broken->capabilities.front().prepare;
    prepare = [quick = prepare](const PrepareContext& context) {
        if (context.scenario.domain.values.integer("cells") == 20) throw std::bad_alloc();
        return quick(context);
    };
    SolverThread thread(broken, scenario(), {});
    ASSERT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
    thread.post(ChangeCommand{scenario({"domain.cells=20"}), 1});
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 1; }));
    EXPECT_TRUE(thread.status().refused);
    EXPECT_EQ(thread.status().run, RunStatus::failed);
    EXPECT_TRUE(thread.take_news().messages.back().error);
    thread.drain();
    thread.post(StartCommand{}); // with the values that worked
    EXPECT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
    const auto events = thread.drain();
    ASSERT_FALSE(events.empty()) << "the new run is seen";
    EXPECT_EQ(events.front().kind, SolverEventKind::restart);
    thread.post(ChangeCommand{scenario({"domain.cells=20"}), 2});
    thread.post(ChangeCommand{scenario({"domain.cells=14"}), 3, true});
    EXPECT_TRUE(eventually([&] { return thread.status().answered == 3; }));
    EXPECT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
}

TEST_F(SolverThreadTest, AnOpeningThatIsCancelledOrRefusedLeavesTheRunAsItWas) {
    std::atomic<bool> slow = false;
    SolverThread thread(slow_catalogue(slow), scenario(), {});
    ASSERT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
    const std::size_t rows = thread.drain().size();
    slow = true;
    thread.post(ChangeCommand{scenario({"domain.cells=20"}), 1, true});
    ASSERT_TRUE(eventually([&] { return thread.status().activity == "waiting"; }));
    thread.cancel();
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 1; }));
    EXPECT_FALSE(thread.take_news().messages.back().error) << "the user's own wish is no error";
    Scenario broken = scenario();
    broken.method.type = "magic";
    thread.post(ChangeCommand{broken, 2, true});
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 2; }));
    std::size_t history = 0;
    std::promise<void> done;
    thread.post(InspectCommand{[&](gaspard::Run& run, const Activity&) {
        history = run.history().size();
        done.set_value();
    }});
    done.get_future().wait();
    EXPECT_EQ(history, rows);
    slow = false;
    thread.post(ChangeCommand{scenario({"domain.cells=16"}), 3, true});
    // A snapshot is there before the status that belongs to it, and before its reports: each is waited for.
    ASSERT_TRUE(eventually(
        [&] { return thread.status().answered == 3 && thread.status().run == RunStatus::converged; }));
    EXPECT_EQ(thread.latest()->mesh->cell_count(), 256);
    const auto events = thread.drain();
    EXPECT_TRUE(std::any_of(events.begin(), events.end(),
                            [](const SolverEvent& e) { return e.kind == SolverEventKind::restart; }));
}

TEST_F(SolverThreadTest, AnotherScenarioIsNoMapThatCouldNotBeKept) {
    SolverThread thread(catalogue, scenario(), {});
    ASSERT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
    Scenario sphere = find_scenario(*catalogue, "sphere-x2");
    apply_settings(*catalogue, sphere, {"domain.cells=4"});
    thread.post(ChangeCommand{sphere, 1, true});
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 1; }));
    EXPECT_TRUE(thread.take_news().messages.empty());
    thread.post(ChangeCommand{scenario(), 2}); // of the same run's values
    ASSERT_TRUE(eventually([&] { return thread.status().answered == 2; }));
    const auto messages = thread.take_news().messages;
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].text.find("map"), std::string::npos) << messages[0].text;
}

TEST_F(SolverThreadTest, ASnapshotThatWasHeldBackComesWithAPauseAndAtTheEnd) {
    Scenario slow =
        scenario({"method.step_size=0.01", "monitor.amplitude=2"}); // far from caught up in one step
    SolverThread thread(catalogue, slow, {});
    ASSERT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
    for (const bool pause : {true, false}) {
        thread.drain();
        apply_settings(*catalogue, slow, {std::string("monitor.center_x=") + (pause ? "0.505" : "0.5")});
        thread.post(ChangeCommand{slow, pause ? 1U : 2U});
        if (pause) thread.post(PauseCommand{});
        settle(thread);
        if (pause) {
            ASSERT_TRUE(eventually([&] { return thread.status().paused; }));
        } else {
            thread.post(StartCommand{});
            ASSERT_TRUE(eventually([&] { return thread.status().run == RunStatus::converged; }));
        }
        const auto events = thread.drain();
        ASSERT_FALSE(events.empty());
        EXPECT_EQ(thread.latest()->report.iteration, events.back().report.iteration);
        EXPECT_EQ(thread.latest()->report.residual, events.back().report.residual);
    }
}

TEST_F(SolverThreadTest, ATaskThatWaitsWhenTheThreadEndsIsStillDone) {
    for (int i = 0; i < 20; ++i) {
        std::atomic<bool> done = false;
        {
            SolverThread thread(catalogue, scenario({"method.tolerance=1e-14", "method.step_size=0.001"}),
                                {});
            ASSERT_TRUE(eventually([&] { return thread.latest() != nullptr; }));
            thread.post(InspectCommand{[&](gaspard::Run&, const Activity&) { done = true; }});
        }
        EXPECT_TRUE(done);
    }
}

} // namespace
} // namespace gaspard
