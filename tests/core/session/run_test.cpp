#include "core/base/error.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class RunTest : public testing::Test {
  protected:
    Scenario scenario(const std::vector<std::string>& settings = {}, const std::string& name = "plane-ring") {
        Scenario result = find_scenario(*catalogue, name);
        apply_settings(*catalogue, result, {"domain.cells=16"});
        apply_settings(*catalogue, result, settings);
        return result;
    }
    gaspard::Run make(const std::vector<std::string>& settings = {}) {
        return gaspard::Run(catalogue, scenario(settings));
    }
    static void finish(gaspard::Run& run) {
        while (run.status() == RunStatus::running) run.step();
    }
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(RunTest, StartsFromAStateOrStaysAsItIs) {
    gaspard::Run solved = make();
    finish(solved);
    gaspard::Run run = make();
    run.step();
    run.start_from(solved.state());
    EXPECT_EQ(run.history().size(), 1u);
    EXPECT_EQ(run.status(), RunStatus::converged) << "the solution is one";
    EXPECT_EQ(run.snapshot()->x, solved.snapshot()->x);
    State other = solved.state();
    other.layout = "of something else";
    EXPECT_THROW(run.start_from(other), InputError);
    EXPECT_EQ(run.snapshot()->x, solved.snapshot()->x);
    EXPECT_EQ(run.status(), RunStatus::converged);
}

TEST_F(RunTest, HistoryHasOneRowPerIterationFromTheStart) {
    gaspard::Run run = make({"method.diagnostics_every=1"});
    EXPECT_EQ(run.history().size(), 1u);
    EXPECT_EQ(run.status(), RunStatus::running);
    finish(run);
    EXPECT_EQ(run.status(), RunStatus::converged);
    for (std::size_t i = 0; i < run.history().size(); ++i) {
        const StepReport& report = run.history()[i];
        EXPECT_EQ(report.iteration, static_cast<int>(i));
        EXPECT_TRUE(report.value("equidistribution") && report.value("min_jacobian") &&
                    report.value("max_jacobian") && report.tangled_cells);
        EXPECT_EQ(report.step_size, i == 0 ? 0.0 : 0.1);
        if (i > 0) {
            EXPECT_GE(report.seconds, run.history()[i - 1].seconds);
        }
    }
    EXPECT_LT(run.history().back().residual, 1e-8);
    EXPECT_GE(run.history()[run.history().size() - 2].residual, 1e-8);
}

TEST_F(RunTest, TheIterationLimitCountsUpdates) {
    gaspard::Run run = make({"method.max_iterations=7"});
    finish(run);
    EXPECT_EQ(run.status(), RunStatus::iteration_limit);
    EXPECT_EQ(run.history().back().iteration, 7);
    EXPECT_EQ(make({"method.max_iterations=0"}).status(), RunStatus::iteration_limit);
}

TEST_F(RunTest, ATooLargeStepDivergesWithFiniteNumbers) {
    for (const char* step : {"method.step_size=1.5", "method.step_size=10"}) {
        gaspard::Run run = make({step});
        finish(run);
        EXPECT_EQ(run.status(), RunStatus::diverged) << "also if its last mesh is tangled";
        EXPECT_FALSE(run.history().back().note.empty());
        for (const auto& report : run.history()) EXPECT_TRUE(std::isfinite(report.residual));
        for (const double value : run.state().arrays[0].values) ASSERT_TRUE(std::isfinite(value));
    }
}

TEST_F(RunTest, AResidualThatCannotFallEndsAsStalled) {
    gaspard::Run run = make({"method.tolerance=1e-14", "monitor.amplitude=2", "monitor.sharpness=20",
                             "domain.cells=32", "method.diagnostics_every=1000"});
    finish(run);
    EXPECT_EQ(run.status(), RunStatus::stalled) << "residual " << run.history().back().residual;
    EXPECT_LT(run.history().back().residual, 1e-10);
}

TEST_F(RunTest, AConvergedRunWithTangledCellsIsTangled) {
    // On 4 x 4 cells the ring is far from resolved; the smallest amplitude that folds a cell is looked for.
    for (int amplitude = 50; amplitude <= 1000; amplitude += 50) {
        gaspard::Run run(catalogue, scenario({"domain.cells=8", "monitor.radius=0.15",
                                              "method.step_size=0.01", "method.max_iterations=2000",
                                              "monitor.amplitude=" + std::to_string(amplitude)}));
        finish(run);
        if (*run.history().back().tangled_cells == 0) continue;
        EXPECT_EQ(run.status(), RunStatus::tangled);
        EXPECT_LE(*run.history().back().value("min_jacobian"), 0);
        return;
    }
    FAIL() << "no amplitude folds a cell";
}

TEST_F(RunTest, DiagnosticsCanBeLeftOutButNotForTheLast) {
    gaspard::Run run = make({"method.diagnostics_every=10"});
    finish(run);
    for (const auto& report : run.history())
        EXPECT_EQ(report.value("equidistribution").has_value(),
                  report.iteration % 10 == 0 || report.iteration == run.history().back().iteration);
    gaspard::Run full = make();
    finish(full);
    EXPECT_EQ(run.history().back().value("equidistribution"),
              full.history().back().value("equidistribution"));
    EXPECT_EQ(run.state(), full.state());
}

TEST_F(RunTest, InterruptingKeepsTheIterate) {
    gaspard::Run run = make({"method.diagnostics_every=1000"});
    for (int i = 0; i < 5; ++i) run.step();
    run.interrupt();
    EXPECT_EQ(run.status(), RunStatus::interrupted);
    EXPECT_EQ(run.history().back().iteration, 5);
    EXPECT_TRUE(run.history().back().value("equidistribution").has_value());
}

TEST_F(RunTest, TheSameInputGivesTheSameNumbersWhateverTheThreads) {
    gaspard::Run one(catalogue, scenario(), RunOptions{.threads = 1}),
        three(catalogue, scenario(), RunOptions{.threads = 3});
    finish(one), finish(three);
    EXPECT_EQ(one.state(), three.state());
    EXPECT_EQ(one.history().back().value("equidistribution"),
              three.history().back().value("equidistribution"));
}

TEST_F(RunTest, AStoredStateGoesOnWhereItWas) {
    gaspard::Run half = make({"method.max_iterations=40"});
    finish(half);
    gaspard::Run rest(catalogue, scenario(), RunOptions{.start = half.state()});
    EXPECT_EQ(rest.history().front().residual, half.history().back().residual);
    finish(rest);
    gaspard::Run whole = make();
    finish(whole);
    EXPECT_EQ(rest.state(), whole.state());
    EXPECT_EQ(rest.history().back().iteration + 40, whole.history().back().iteration);
}

TEST_F(RunTest, AStateOfAnotherKindIsRefused) {
    gaspard::Run walls = make({"domain.boundary=walls"});
    EXPECT_THROW(gaspard::Run(catalogue, scenario(), RunOptions{.start = walls.state()}), InputError);
    State nonsense = walls.state();
    nonsense.layout = "something else";
    EXPECT_THROW(gaspard::Run(catalogue, scenario(), RunOptions{.start = nonsense}), InputError);
}

TEST_F(RunTest, AChangedMonitorKeepsTheMap) {
    gaspard::Run run = make();
    finish(run);
    const State before = run.state();
    EXPECT_EQ(run.change(scenario({"monitor.amplitude=12"})), "");
    EXPECT_EQ(run.state(), before);
    ASSERT_EQ(run.history().size(), 1U) << "a history of the new values";
    EXPECT_EQ(run.history().front().iteration, 0);
    EXPECT_EQ(run.epoch(), 1);
    EXPECT_EQ(run.status(), RunStatus::running);
    EXPECT_LT(run.history().back().residual, 0.2) << "the old map is a good start";
    finish(run);
    gaspard::Run fresh = make({"monitor.amplitude=12"});
    finish(fresh);
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_NEAR(*run.history().back().value("equidistribution"),
                *fresh.history().back().value("equidistribution"), 1e-7);
}

TEST_F(RunTest, AfterABlowUpAChangeGoesOnFromTheLastUntangledMesh) {
    gaspard::Run run = make();
    for (int i = 0; i < 50; ++i) run.step();
    run.change(scenario({"method.step_size=3"}));
    finish(run);
    ASSERT_GT(*run.history().back().tangled_cells, 0u);
    run.change(scenario({"method.step_size=0.05"}));
    EXPECT_EQ(*run.history().back().tangled_cells, 0u);
    EXPECT_NE(run.history().back().note.find("restarted from the last mesh"), std::string::npos);
    finish(run);
    EXPECT_EQ(run.status(), RunStatus::converged);
}

TEST_F(RunTest, AMeshThatIsTangledOnTheWayIsNoPlaceToGoBackTo) {
    gaspard::Run run = make({"method.diagnostics_every=1"});
    for (int i = 0; i < 20; ++i) run.step();
    run.change(scenario({"method.step_size=1", "method.diagnostics_every=1"}));
    while (run.status() == RunStatus::running && *run.history().back().tangled_cells == 0) run.step();
    ASSERT_EQ(run.status(), RunStatus::running) << "tangled, but not yet out of bounds";
    run.change(scenario({"method.step_size=3", "method.diagnostics_every=1"})); // in the middle of it
    finish(run);
    run.change(scenario({"method.step_size=0.05"}));
    EXPECT_EQ(*run.history().back().tangled_cells, 0u);
}

TEST_F(RunTest, AutoOnATangledMeshStartsFromOneThatIsNot) {
    for (const char* automatic : {"method.step_size=auto", "method.type=auto"}) {
        gaspard::Run run = make({"method.diagnostics_every=1"});
        for (int i = 0; i < 20; ++i) run.step();
        run.change(scenario({"method.step_size=1", "method.diagnostics_every=1"}));
        while (run.status() == RunStatus::running && *run.history().back().tangled_cells == 0) run.step();
        ASSERT_EQ(run.status(), RunStatus::running) << "paused on a tangled mesh";
        run.change(scenario({automatic}));
        EXPECT_EQ(*run.history().back().tangled_cells, 0u) << automatic;
        finish(run);
        EXPECT_EQ(run.status(), RunStatus::converged) << automatic;
    }
}

TEST_F(RunTest, TheAcceleratedMethodCanBeChangedToAndFromOnItsWay) {
    gaspard::Run run = make({"domain.cells=60", "method.type=accelerated"});
    const double at_first = run.history().front().residual;
    for (int i = 0; i < 5; ++i) run.step();
    ASSERT_NE(run.state().layout, "plane periodic Q2 n=60"); // on a coarser plane
    EXPECT_EQ(run.snapshot()->x.size(), 61u * 61u);
    EXPECT_EQ(run.change(scenario({"domain.cells=60", "method.type=relaxation"})), "");
    EXPECT_EQ(run.state().layout, "plane periodic Q2 n=60");
    EXPECT_LT(run.history().back().residual, at_first);
    run.step();
    EXPECT_EQ(run.change(scenario({"domain.cells=60", "method.type=accelerated"})), "");
    EXPECT_EQ(run.epoch(), 2);
    finish(run);
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_EQ(run.state().layout, "plane periodic Q2 n=60");
    EXPECT_EQ(*run.history().back().tangled_cells, 0u);
}

TEST_F(RunTest, AChangedResolutionKeepsTheMapToo) {
    gaspard::Run run = make({"monitor.sharpness=50"});
    finish(run);
    EXPECT_EQ(run.change(scenario({"monitor.sharpness=50", "domain.cells=30"})), "");
    EXPECT_EQ(run.snapshot()->mesh->cell_count(), 900u);
    const double transferred = run.history().back().residual;
    const double identity = make({"monitor.sharpness=50", "domain.cells=30"}).history().front().residual;
    EXPECT_LT(transferred, 0.2 * identity);
    finish(run);
    EXPECT_EQ(run.status(), RunStatus::converged);
}

TEST_F(RunTest, AMapThatCannotBeKeptStartsAgainAndSaysSo) {
    gaspard::Run run = make();
    finish(run);
    EXPECT_NE(run.change(scenario({"domain.boundary=walls"})), "");
    EXPECT_EQ(run.epoch(), 1);
    EXPECT_EQ(run.history().size(), 1u);
    EXPECT_EQ(run.snapshot()->x, run.snapshot()->mesh->nodes);
}

TEST_F(RunTest, AnInvalidChangeChangesNothing) {
    gaspard::Run run = make();
    run.step();
    Scenario broken = scenario();
    broken.monitor.type = "nothing";
    EXPECT_THROW(run.change(broken), InputError);
    EXPECT_EQ(run.scenario(), scenario());
    EXPECT_EQ(run.history().size(), 2u);
    run.step();
}

TEST_F(RunTest, ViewAndOutputValuesDoNotTouchTheIteration) {
    gaspard::Run run = make();
    finish(run);
    const auto rows = run.history().size();
    EXPECT_EQ(run.change(scenario({"view.blend=0.5"})), "");
    EXPECT_EQ(run.history().size(), rows);
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_EQ(run.scenario().view.real("blend"), 0.5);
}

TEST_F(RunTest, ResetGoesBackToTheIdentity) {
    gaspard::Run run = make();
    finish(run);
    run.reset();
    EXPECT_EQ(run.history().size(), 1u);
    EXPECT_EQ(run.epoch(), 1);
    EXPECT_EQ(run.snapshot()->x, run.snapshot()->mesh->nodes);
    finish(run);
    EXPECT_EQ(run.status(), RunStatus::converged);
}

TEST_F(RunTest, SnapshotsAreCompleteAndVersioned) {
    gaspard::Run run = make();
    const auto first = run.snapshot();
    run.step();
    const auto second = run.snapshot();
    EXPECT_EQ(first->mesh, second->mesh) << "connectivity is shared";
    EXPECT_LT(first->version, second->version);
    EXPECT_EQ(first->x, first->mesh->nodes) << "a snapshot does not change";
    ASSERT_NE(second->field("monitor"), nullptr);
    EXPECT_EQ(second->field("monitor")->values.size(), second->mesh->node_count());
    ASSERT_NE(second->field("jacobian"), nullptr);
    EXPECT_EQ(second->field("jacobian")->values.size(), second->mesh->cell_count());
    EXPECT_EQ(second->report.iteration, 1);
}

TEST(SphereRun, ReportsTheDeviationFromTheExactMapAndFollowsTheMonitor) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "sphere-x2");
    apply_settings(*catalogue, scenario, {"domain.cells=6"});
    gaspard::Run run(catalogue, scenario);
    const double before = *run.history().back().value("exact_rms");
    EXPECT_GT(before, 0.1);
    while (run.status() == RunStatus::running) run.step();
    EXPECT_EQ(run.status(), RunStatus::converged);
    const StepReport last = run.history().back();
    EXPECT_LT(*last.value("exact_rms"), 0.01);
    EXPECT_LT(*last.value("exact_rms_nodes"), *last.value("exact_rms"));
    const auto first = run.snapshot();
    ASSERT_TRUE(first->exact);
    EXPECT_EQ(first->exact->size(), first->x.size());
    EXPECT_EQ(run.snapshot()->exact, first->exact); // made once

    apply_settings(*catalogue, scenario, {"monitor.center_latitude=20"});
    EXPECT_EQ(run.change(scenario), "");
    EXPECT_NE(run.snapshot()->exact, first->exact);
    EXPECT_GT(*run.history().back().value("exact_rms"), *last.value("exact_rms"));
    EXPECT_LT(run.history().back().residual, 0.3); // from the present map
    apply_settings(*catalogue, scenario, {"monitor.type=cross"});
    EXPECT_EQ(run.change(scenario), "");
    EXPECT_FALSE(run.snapshot()->exact);
    EXPECT_FALSE(run.history().back().value("exact_rms"));
    apply_settings(*catalogue, scenario, {"domain.type=icosahedral-sphere", "domain.refinements=2"});
    EXPECT_EQ(run.change(scenario), ""); // the map is kept from one sphere to another
    apply_settings(*catalogue, scenario, {"domain.type=plane", "monitor.type=ring"});
    EXPECT_NE(run.change(scenario), "");
    EXPECT_FALSE(run.history().back().value("exact_rms"));
}

} // namespace
} // namespace gaspard
