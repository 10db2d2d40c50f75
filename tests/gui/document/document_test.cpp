#include "core/session/history_thinning.hpp"
#include "core/session/time_series.hpp"
#include "gui/document_fixture.hpp"

#include <cmath>

namespace gaspard {
namespace {

class DocumentTest : public DocumentFixture {};

TEST_F(DocumentTest, ARunThatBeginsAnewIsRecordedFromItsStart) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const std::uint64_t before = run().histories;
    document.reset(run().id);
    document.start(run().id);
    ASSERT_TRUE(wait_until([&] { return run().histories > before && run().ended(); }));
    EXPECT_EQ(run().recording->iterations().front(), 0);
    EXPECT_NEAR(run().recording->at(0)->restore()->x.x.at(1), run().snapshot->mesh->nodes.x.at(1), 1e-7);
}

TEST_F(DocumentTest, KeepsEveryReportInOrderAndPlotsIt) {
    document.open(small_ring());
    ASSERT_EQ(document.viewports().size(), 1U);
    EXPECT_EQ(document.viewports().front().run, run().id);
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

TEST_F(DocumentTest, GoingBackSaysWhetherItDidAndWhatItKept) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto from = run().recording->with_state(8);
    ASSERT_TRUE(from);
    const auto back = document.go_on_from(run().id, *from);
    ASSERT_TRUE(back);
    ASSERT_TRUE(back->kept);
    EXPECT_EQ(document.runs().find(*back->kept)->history.size(), 41U);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().history.size() == 1; }));
    ASSERT_TRUE(solver_is_idle());
    run().history.clear(); // as before the first report
    const auto without = document.go_on_from(run().id, *from);
    ASSERT_TRUE(without) << "it went back";
    EXPECT_FALSE(without->kept) << "there was nothing to keep";
    EXPECT_EQ(document.runs().size(), 2U);
    ASSERT_TRUE(solver_is_idle());
    document.replace(run().id, small_ring());
    EXPECT_FALSE(document.go_on_from(run().id, *from)) << "its state is of other values";
    EXPECT_EQ(document.runs().size(), 2U);
}

TEST_F(DocumentTest, AChangeContinuesAndAResetStartsOver) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 20.0);
    document.change(run().id, changed);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_LT(run().history.front().residual, 0.6) << "the map before the change is the start";
    document.reset(run().id);
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    EXPECT_EQ(run().history.front().iteration, 0);
    EXPECT_EQ(run().curves.find("residual")->trace.values.size(), 1U);
    EXPECT_GT(run().history.front().residual, 0.6);
    EXPECT_FALSE(run().wants_to_run);
    document.start(run().id);
    document.reset(run().id);
    EXPECT_FALSE(run().wants_to_run) << "a run that was running is paused, too: R, Space runs it";
    document.start(run().id);
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().history.back().iteration == 40; }));
}

TEST_F(DocumentTest, AKeptRunStaysWhileTheLiveOneGoesOn) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto id = document.keep(run().id);
    ASSERT_TRUE(id);
    const DocumentRun& kept = *document.runs().find(*id);
    EXPECT_EQ(&kept, &document.runs()[1]);
    EXPECT_EQ(kept.name, "Ring");
    EXPECT_FALSE(kept.live());
    EXPECT_NE(kept.colour, run().colour);
    const auto snapshot = run().snapshot;

    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 20.0);
    document.change(run().id, changed);
    EXPECT_EQ(run().name, "Ring, Amplitude A = 20");
    document.reset(run().id);
    document.start(run().id);
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

    ASSERT_TRUE(document.keep(run().id));
    EXPECT_EQ(document.runs()[2].name, "Ring, Amplitude A = 20");
    EXPECT_EQ(document.runs()[2].scenario.monitor.values.real("amplitude"), 20);
    ASSERT_TRUE(document.keep(run().id));
    EXPECT_EQ(document.runs()[3].name, "Ring, Amplitude A = 20 (2)") << "no two have the same name";
}

TEST_F(DocumentTest, ReferencesToRunsStayValid) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    DocumentRun& live = run();
    const DocumentRun& first = *document.runs().find(*document.keep(run().id));
    const std::string name = first.name;
    const std::size_t reports = first.history.size();
    for (int i = 0; i < 50; ++i) ASSERT_TRUE(document.keep(run().id));
    document.open(small_ring());
    document.remove(document.runs()[2].id);
    EXPECT_EQ(&live, &document.active()) << "the first run is active";
    EXPECT_EQ(&first, &document.runs()[1]);
    EXPECT_EQ(first.name, name);
    EXPECT_EQ(first.history.size(), reports);
}

TEST_F(DocumentTest, AViewportOfARemovedRunShowsTheActiveOne) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const RunId first = *document.keep(run().id), second = *document.keep(run().id);
    const std::size_t colour = document.runs().find(first)->colour;
    document.viewports().push_back({.run = first, .view = run().scenario.view});
    document.viewports().push_back({.run = second, .view = run().scenario.view});
    document.remove(first);
    ASSERT_EQ(document.runs().size(), 2U);
    EXPECT_EQ(document.runs()[1].name, "Ring (2)");
    EXPECT_EQ(document.viewports()[1].run, document.active().id);
    EXPECT_EQ(document.viewports()[2].run, second) << "the same run as before";
    document.keep(run().id);
    EXPECT_EQ(document.runs()[2].colour, colour) << "the colour is free again";
}

TEST_F(DocumentTest, ARunWithoutReportsIsNotKept) {
    Scenario refused = small_ring();
    refused.method.type = "magic";
    document.open(refused);
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_FALSE(document.keep(run().id));
    EXPECT_EQ(document.runs().size(), 1U);
}

TEST_F(DocumentTest, AChangeOfValuesBeginsAHistoryAndKeepsTheCurvesBeforeIt) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const std::size_t first = run().history.size();
    EXPECT_TRUE(run().earlier.empty());
    const auto change = [&](const char* key, double value) {
        Scenario changed = run().scenario;
        set_value(*catalogue, changed, key, value);
        document.change(run().id, changed);
        ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    };
    for (const double amplitude : {12.0, 15.0, 20.0}) // as by a slider
        change("monitor.amplitude", amplitude);
    document.end_gesture();
    ASSERT_EQ(run().earlier.size(), 1U) << "a gesture is one change";
    EXPECT_EQ(run().earlier[0].name, "Amplitude A = 10");
    EXPECT_EQ(run().earlier[0].curves.find("residual")->trace.values.size(), first);
    EXPECT_EQ(run().history.front().iteration, 0);
    EXPECT_EQ(run().history.back().iteration + 1, static_cast<int>(run().history.size()));
    EXPECT_LE(run().history.back().iteration, 40) << "of these values alone";
    change("monitor.amplitude", 25);
    document.end_gesture();
    change("monitor.radius", 0.2);
    ASSERT_EQ(run().earlier.size(), 3U);
    EXPECT_EQ(run().earlier[1].name, "Amplitude A = 20");
    EXPECT_EQ(run().earlier[2].name, "Radius r = 0.25");
    document.keep(run().id);
    EXPECT_TRUE(document.runs()[1].earlier.empty()) << "what is kept is this solve";
    document.reset(run().id);
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    EXPECT_TRUE(run().earlier.empty());
}

TEST_F(DocumentTest, RecordingsShareTheirMemoryAndRemovedRunsHaveNone) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const RunId kept = *document.keep(run().id);
    ASSERT_NE(document.runs().find(kept)->recording, nullptr);
    EXPECT_EQ(document.runs().find(kept)->recording->iterations(), run().recording->iterations());
    EXPECT_EQ(run().recording->budget(), recording_memory / 2);
    document.remove(kept);
    EXPECT_EQ(run().recording->budget(), recording_memory) << "it has all of it again";
    document.undo();
    ASSERT_NE(document.runs().find(kept), nullptr);
    EXPECT_EQ(document.runs().find(kept)->recording, nullptr) << "its memory was given back";
    EXPECT_FALSE(document.runs().find(kept)->history.empty());
}

TEST_F(DocumentTest, OnlyTheLastEarlierSolvesAreKept) {
    document.open(small_ring());
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    for (int i = 1; i <= 12; ++i) {
        Scenario changed = run().scenario;
        set_value(*catalogue, changed, "monitor.amplitude", 10.0 + i);
        document.change(run().id, changed);
        document.end_gesture();
        ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    }
    ASSERT_EQ(run().earlier.size(), most_earlier);
    EXPECT_EQ(run().earlier.back().name, "Amplitude A = 21");
}

TEST_F(DocumentTest, WhatIsMeasuredLaterCompletesTheHistory) {
    std::atomic<SolverThread*> solver = nullptr;
    std::atomic<bool> held = false;
    const auto hold = [&](const Snapshot& snapshot) { // before the next step
        if (!solver || snapshot.report.value("equidistribution") || held.exchange(true)) return;
        solver.load()->post(PauseCommand{});
    };
    Document watched(
        catalogue, [] {}, hold);
    const auto collected = [&](const auto& condition) {
        return wait_until([&] { return watched.collect(), condition(); });
    };
    Scenario ring = small_ring();
    for (const auto& [key, value] : {std::pair{"monitor.amplitude", 2.0}, {"method.step_size", 0.01}})
        set_value(*catalogue, ring, key, value);
    set_value(*catalogue, ring, "method.max_iterations", std::int64_t{100000});
    set_value(*catalogue, ring, "method.diagnostics_every", std::int64_t{1000});
    watched.open(ring);
    const DocumentRun& one = watched.active();
    watched.viewports().front().view.set("color", std::string("area")); // which needs no masses
    ASSERT_TRUE(collected([&] { return one.status.run == RunStatus::converged && !one.history.empty(); }));
    solver = one.solver.get();
    Scenario changed = one.scenario;
    for (const double amplitude : {2.0005, 2.001}) { // by one gesture; shown at once, but not yet solved
        set_value(*catalogue, changed, "monitor.amplitude", amplitude);
        watched.change(one.id, changed);
        ASSERT_TRUE(collected([&] { return one.changes.settled(); }));
    }
    ASSERT_TRUE(collected([&] { return one.changes.settled() && one.status.paused; }));
    ASSERT_TRUE(held) << "the change was not shown in part";
    ASSERT_TRUE(one.snapshot->report.value("equidistribution"));
    EXPECT_EQ(one.history.back().value("equidistribution"), one.snapshot->report.value("equidistribution"));
    const Trace& curve = one.curves.find("equidistribution")->trace;
    EXPECT_EQ(curve.values.back(), *one.snapshot->report.value("equidistribution"));
    EXPECT_EQ(one.curves.find("residual")->trace.values.size(), one.history.size()) << "no row twice";
    EXPECT_EQ(one.earlier.size(), 1U);
}

TEST_F(DocumentTest, ANameThatIsSavedAgainStandsForTheValuesSavedLast) {
    document.open(small_ring());
    const auto change = [&](double amplitude) {
        Scenario changed = run().scenario;
        set_value(*catalogue, changed, "monitor.amplitude", amplitude);
        document.change(run().id, changed);
    };
    for (const double amplitude : {20.0, 30.0}) {
        change(amplitude);
        Scenario saved = run().scenario;
        saved.name = saved.title = "mine";
        saved.modified.clear();
        document.name_saved(run().id, saved);
        EXPECT_EQ(run().title, "mine");
    }
    change(20);
    EXPECT_EQ(run().title, "mine (modified)");
    change(10);
    EXPECT_EQ(run().title, small_ring().title) << "as it was opened";
}

TEST_F(DocumentTest, RunsDifferInColour) {
    document.open(small_ring());
    document.open(find_scenario(*catalogue, "plane-bell"));
    document.pause(document.runs()[1].id);
    ASSERT_TRUE(wait_until([&] { return run().ended() && !document.runs()[1].history.empty(); }));
    EXPECT_EQ(document.viewports()[1].run, document.runs()[1].id);
    EXPECT_NE(document.runs()[0].colour, document.runs()[1].colour);
}

TEST_F(DocumentTest, AComparisonLeavesAScenarioAloneThatWasOpenedMeanwhile) {
    document.open(endless_ring());
    ASSERT_TRUE(wait_until([&] { return run().solving(); }));
    document.compare({"relaxation"});
    ASSERT_TRUE(wait_until([&] { return run().status.paused && document.runs()[1].history.size() > 1; }));
    EXPECT_FALSE(run().solving());
    document.replace(run().id, small_ring()); // another scenario is opened, and solved
    ASSERT_TRUE(wait_until([&] { return run().openings == 1 && run().ended(); }));
    ASSERT_EQ(run().history.size(), 41U);
    const auto solved = run().snapshot;
    ASSERT_TRUE(document.comparison().running());
    document.cancel_comparison();
    ASSERT_TRUE(solver_is_idle());
    EXPECT_TRUE(run().ended());
    EXPECT_EQ(run().snapshot, solved) << "the run was started again";
    EXPECT_EQ(run().history.size(), 41U);
}

TEST_F(DocumentTest, AComparisonDoesNotResumeARunThatWasPausedMeanwhile) {
    document.open(endless_ring());
    ASSERT_TRUE(wait_until([&] { return run().solving(); }));
    document.compare({"relaxation"});
    document.start(run().id);
    document.pause(run().id);
    document.cancel_comparison();
    EXPECT_FALSE(run().wants_to_run);
}

TEST(DocumentRun, ManyTimeStepsAreThinnedOutInHistoryAndCurves) {
    const Catalogue catalogue = builtin_catalogue();
    const auto table = std::make_shared<const SeriesTable>(SeriesInfo{.name = "residual"}, time_series(),
                                                           std::vector<SeriesInfo>{}, "residual");
    DocumentRun run;
    for (int i = 0; i < 30000; ++i) {
        StepReport report{.iteration = i, .residual = 1.0 / (i + 1), .series = table};
        report.values.assign(table->slots(), 0);
        report.set(time_names::time, i);
        append(run, catalogue, {SolverEventKind::step, report});
        ASSERT_LE(run.history.size(), most_time_steps);
    }
    EXPECT_EQ(run.history.back().iteration, 29999);
    const Trace& residual = run.curves.find("residual")->trace;
    ASSERT_EQ(residual.values.size(), run.history.size());
    ASSERT_EQ(residual.times.size(), run.history.size());
    EXPECT_EQ(residual.extremes.size(), run.history.size());
    for (std::size_t i = 0; i < run.history.size(); ++i) {
        ASSERT_EQ(residual.iterations[i], run.history[i].iteration);
        ASSERT_EQ(residual.times[i], run.history[i].iteration);
    }
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
