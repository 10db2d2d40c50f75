#include "core/scenario/toml.hpp"
#include "core/session/recording.hpp"
#include "core/session/run.hpp"
#include "core/session/solver_thread.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <numeric>
#include <thread>

namespace gaspard {
namespace {

Scenario recorded_ring(std::vector<std::string> settings = {}) {
    const Catalogue catalogue = builtin_catalogue();
    Scenario scenario = find_scenario(catalogue, "plane-ring");
    settings.insert(settings.begin(), "domain.cells=20");
    apply_settings(catalogue, scenario, settings);
    return scenario;
}

Run make_run(std::vector<std::string> settings = {}) {
    return Run(std::make_shared<const Catalogue>(builtin_catalogue()), recorded_ring(std::move(settings)));
}

/// Records an iterate as `iteration`.
void add_as(Recording& recording, const Snapshot& snapshot, int iteration) {
    Snapshot copy = snapshot;
    copy.report.iteration = iteration;
    recording.add(copy);
}

TEST(Recording, KeepsPositionsAndFieldsToSinglePrecision) {
    gaspard::Run run = make_run();
    for (int i = 0; i < 5; ++i) run.step();
    const auto snapshot = run.snapshot();
    const auto restored = RecordedIterate(*snapshot).restore();
    ASSERT_EQ(restored->x.size(), snapshot->x.size());
    double worst = 0;
    for (std::size_t i = 0; i < snapshot->x.size(); ++i)
        worst = std::max(worst, norm(restored->x[i] - snapshot->x[i]));
    EXPECT_LT(worst, 1e-7);
    EXPECT_GT(worst, 0) << "double precision would take twice the memory";
    ASSERT_EQ(restored->fields.size(), snapshot->fields.size());
    for (std::size_t f = 0; f < snapshot->fields.size(); ++f) {
        const Field &field = snapshot->fields[f], &again = restored->fields[f];
        EXPECT_EQ(again.name, field.name);
        ASSERT_EQ(again.values.size(), field.values.size()) << field.name;
        for (std::size_t i = 0; i < field.values.size(); ++i)
            ASSERT_NEAR(again.values[i], field.values[i], 1e-6 * (1 + std::abs(field.values[i])));
    }
    EXPECT_EQ(restored->report.iteration, 5);
    EXPECT_EQ(restored->report.residual, snapshot->report.residual);
    EXPECT_EQ(restored->version, snapshot->version);
    EXPECT_EQ(restored->mesh, snapshot->mesh);
}

TEST(Recording, CountsTheExactMeshesOfTimeSteps) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "sphere-x4");
    apply_settings(*catalogue, scenario,
                   {"domain.cells=6", "method.type=newton", "time.end=0.02", "time.step=0.01"});
    gaspard::Run run(catalogue, scenario);
    Snapshot snapshot = *run.snapshot();
    ASSERT_TRUE(snapshot.exact);
    const std::size_t shared = RecordedIterate(snapshot).bytes();
    while (!run.moves()) run.step();
    run.step();
    snapshot = *run.snapshot();
    ASSERT_TRUE(snapshot.exact);
    EXPECT_EQ(RecordedIterate(snapshot).bytes(), shared + 24 * snapshot.x.size());
}

TEST(Recording, RestoresMeshesInSpaceAndOnIntervals) {
    const Catalogue catalogue = builtin_catalogue();
    for (const char* name : {"sphere-cross", "layer-1d"}) {
        Scenario scenario = find_scenario(catalogue, name);
        gaspard::Run run(std::make_shared<const Catalogue>(builtin_catalogue()), scenario);
        run.step();
        const auto snapshot = run.snapshot();
        const auto restored = RecordedIterate(*snapshot).restore();
        for (std::size_t i = 0; i < snapshot->x.size(); ++i)
            ASSERT_LT(norm(restored->x[i] - snapshot->x[i]), 1e-6) << name;
    }
}

TEST(Recording, DropsEveryOtherIterateWhenTheBudgetIsUsedUp) {
    const auto snapshot = make_run().snapshot();
    const std::size_t one = RecordedIterate(*snapshot).bytes();
    Recording recording(10 * one);
    for (int i = 0; i <= 9; ++i) add_as(recording, *snapshot, i);
    EXPECT_EQ(recording.iterations().size(), 10U) << "they fit";
    for (int i = 10; i <= 1000; ++i) {
        add_as(recording, *snapshot, i);
        ASSERT_LE(recording.bytes(), 10 * one);
        ASSERT_EQ(recording.iterations().front(), 0);
        ASSERT_EQ(recording.iterations().back(), i) << "the newest is always there";
    }
    const std::vector<int> kept = recording.iterations();
    EXPECT_GE(kept.size(), 5U) << "half of the budget is used";
    EXPECT_EQ(recording.stride(), 128);
    for (std::size_t i = 1; i + 1 < kept.size(); ++i) EXPECT_EQ(kept[i], static_cast<int>(i) * 128);
    EXPECT_EQ(recording.bytes(), kept.size() * one);
    recording.set_budget(3 * one);
    EXPECT_LE(recording.iterations().size(), 3U);
    recording.set_budget(0);
    EXPECT_EQ(recording.iterations(), (std::vector<int>{0, 1000})) << "two are always there";
}

TEST(Recording, FindsTheNewestIterateUpToAnIteration) {
    const auto snapshot = make_run().snapshot();
    Recording recording(1U << 30U);
    EXPECT_EQ(recording.at(3), nullptr);
    for (const int i : {4, 6, 9}) add_as(recording, *snapshot, i);
    EXPECT_EQ(recording.at(0)->iteration(), 4) << "the first there is";
    EXPECT_EQ(recording.at(5)->iteration(), 4);
    EXPECT_EQ(recording.at(6)->iteration(), 6);
    EXPECT_EQ(recording.at(100)->iteration(), 9);
    add_as(recording, *snapshot, 6); // the same iterate with more diagnostics
    EXPECT_EQ(recording.iterations(), (std::vector<int>{4, 6}));
    EXPECT_FALSE(recording.first_tangled());
    Snapshot tangled = *snapshot;
    tangled.report.iteration = 7, tangled.report.tangled_cells = 3;
    recording.add(tangled);
    EXPECT_EQ(recording.first_tangled(), 7);
    recording.begin();
    EXPECT_EQ(recording.at(6), nullptr);
    EXPECT_EQ(recording.bytes(), 0U);
}

/// What a solver thread records of a scenario, once it has ended.
std::vector<int> recorded_by_thread(const Scenario& scenario, const std::shared_ptr<Recording>& recording,
                                    const std::function<void(SolverThread&)>& then = {}) {
    SolverThread::Options options;
    options.recording = recording;
    SolverThread solver(std::make_shared<const Catalogue>(builtin_catalogue()), scenario, std::move(options));
    const auto wait_for_end = [&](std::uint64_t answered) {
        for (int i = 0; i < 60000; ++i) {
            solver.drain();
            const SolverStatus status = solver.status();
            if (status.answered == answered && is_final(status.run)) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        FAIL() << "the run did not end";
    };
    wait_for_end(0);
    if (then) {
        then(solver);
        wait_for_end(1);
    }
    return recording->iterations();
}

TEST(Recording, ASolverThreadRecordsEveryIterateOfASolve) {
    const auto recording = std::make_shared<Recording>(1U << 30U);
    const std::vector<int> all =
        recorded_by_thread(recorded_ring({"method.max_iterations=30", "method.tolerance=1e-12"}), recording);
    std::vector<int> expected(31);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(all, expected);
    gaspard::Run run = make_run({"method.max_iterations=30"});
    for (int i = 0; i < 12; ++i) run.step();
    const auto recorded = recording->at(12)->restore();
    for (std::size_t i = 0; i < run.snapshot()->x.size(); ++i)
        ASSERT_LT(norm(recorded->x[i] - run.snapshot()->x[i]), 1e-7) << "of iteration 12 itself";
}

TEST(Recording, WhatIsHiddenDuringADragIsRecordedToo) {
    const auto recording = std::make_shared<Recording>(1U << 30U);
    const std::vector<int> all = recorded_by_thread(recorded_ring(), recording, [](SolverThread& solver) {
        solver.post(ChangeCommand{
            .scenario = recorded_ring({"monitor.amplitude=10.5"}), .number = 1, .same_gesture = true});
    });
    ASSERT_GT(all.size(), 3U);
    for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], static_cast<int>(i));
}

TEST(Recording, AChangeOfValuesBeginsANewOne) {
    const auto recording = std::make_shared<Recording>(1U << 30U);
    const Scenario changed = recorded_ring({"monitor.amplitude=11"});
    const std::vector<int> all = recorded_by_thread(recorded_ring(), recording, [&](SolverThread& solver) {
        solver.post(ChangeCommand{changed, 1});
    });
    gaspard::Run run = make_run();
    run.solve();
    run.change(changed);
    ASSERT_EQ(run.history().front().iteration, 0);
    const int solved_in = run.solve().iteration;
    std::vector<int> expected(static_cast<std::size_t>(solved_in) + 1);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(all, expected) << "all of it, from the map of the old values on";
}

TEST(Recording, SomeIteratesHaveTheirState) {
    gaspard::Run run = make_run();
    const auto snapshot = run.snapshot();
    const auto state = std::make_shared<const State>(run.state());
    Recording recording(std::size_t{1} << 30);
    EXPECT_EQ(recording.with_state(5), nullptr);
    for (int i = 0; i < 40; ++i) {
        Snapshot copy = *snapshot;
        copy.report.iteration = i;
        recording.add(copy, recording.wants_state(i) ? state : nullptr);
    }
    EXPECT_EQ(recording.with_state(0)->iteration(), 0);
    EXPECT_EQ(recording.with_state(7)->iteration(), 0);
    EXPECT_EQ(recording.with_state(39)->iteration(), 32);
    EXPECT_EQ(recording.with_state(39)->state(), state);
    EXPECT_EQ(recording.with_state(-3)->iteration(), 0) << "the first, rather than none";
    std::size_t numbers = 0;
    for (const auto& array : state->arrays) numbers += array.values.size();
    EXPECT_GE(recording.at(8)->bytes(), recording.at(9)->bytes() + 8 * numbers) << "they count";
    recording.set_budget(recording.bytes() / 3);
    EXPECT_LE(recording.bytes(), recording.budget());
    EXPECT_NE(recording.with_state(39), nullptr) << "the first keeps its state";
}

TEST(Recording, OfARunHasStatesFromWhichItCanGoOn) {
    auto recording = std::make_shared<Recording>(std::size_t{1} << 30);
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Scenario scenario =
        recorded_ring({"method.type=newton", "time.end=1", "time.step=0.05", "time.monitor.center_x=t/5"});
    SolverThread::Options options;
    options.recording = recording;
    SolverThread thread(catalogue, scenario, std::move(options));
    const auto wait_for_end = [&] {
        for (int i = 0; i < 3000 && !is_final(thread.status().run); ++i) {
            thread.drain();
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        EXPECT_EQ(thread.status().run, RunStatus::converged);
    };
    wait_for_end();
    const auto last = recording->iterations().back();
    const auto from = recording->with_state(last - 4);
    ASSERT_TRUE(from && from->state());
    const double t = from->report().value("time").value();
    EXPECT_GT(t, 0.2);
    thread.post(
        ChangeCommand{.scenario = scenario, .number = 1, .anew = true, .start = from->state(), .time = t});
    for (int i = 0; i < 3000 && thread.status().answered < 1; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    wait_for_end();
    EXPECT_NEAR(recording->at(0)->report().value("time").value(), t, 1e-12);
    EXPECT_EQ(recording->at(1000000)->report().value("time"), 1.0);
}

TEST(Recording, TimePassesWithItsSpeedAndLeavesOutLateSteps) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const Scenario scenario = recorded_ring({"method.type=newton", "time.end=4", "time.step=0.00001",
                                             "time.monitor.center_x=t/5", "time.speed=4"});
    auto recording = std::make_shared<Recording>(std::size_t{1} << 30);
    SolverThread::Options options;
    options.recording = recording;
    const auto begin = std::chrono::steady_clock::now();
    SolverThread thread(catalogue, scenario, std::move(options));
    for (int i = 0; i < 6000 && !is_final(thread.status().run); ++i) {
        thread.drain();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(thread.status().run, RunStatus::converged);
    EXPECT_GT(taken.count(), 0.95) << "4 units of time at 4 a second";
    EXPECT_LT(recording->iterations().back(), 400000) << "not every step of 2.5 microseconds";
    EXPECT_EQ(recording->at(1000000)->report().value("time"), 4.0);
}

TEST(Recording, AnotherSpeedOrAPauseLetsNoTimePass) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    const auto at_speed = [](const char* speed) {
        return recorded_ring({"method.type=newton", "time.end=1000", "time.step=0.01",
                              "time.monitor.center_x=t/100", std::string("time.speed=") + speed});
    };
    SolverThread thread(catalogue, at_speed("1"), {});
    const auto time = [&] {
        const auto latest = thread.latest();
        return latest ? latest->report.value("time").value_or(0) : 0;
    };
    const auto wait = [&](double seconds) {
        for (int i = 0; i < static_cast<int>(200 * seconds); ++i) {
            thread.drain();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    };
    for (int i = 0; i < 100 && time() < 1.5; ++i) wait(0.1);
    ASSERT_GE(time(), 1.5);
    const auto changed_at = std::chrono::steady_clock::now();
    const double before = time();
    thread.post(ChangeCommand{.scenario = at_speed("0.001"), .number = 1});
    for (int i = 0; i < 600 && thread.status().answered < 1; ++i) wait(0.01);
    thread.post(ChangeCommand{.scenario = at_speed("2"), .number = 2});
    wait(0.3);
    thread.post(PauseCommand{});
    wait(0.5);
    thread.post(StartCommand{});
    wait(0.1);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - changed_at;
    EXPECT_LT(time(), before + 2 * (taken.count() - 0.5) + 0.2)
        << "the pause does not count, nor the time before";
    EXPECT_GT(time(), before);
}

} // namespace
} // namespace gaspard
