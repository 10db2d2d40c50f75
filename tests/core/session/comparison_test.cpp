// Several methods on one problem.
#include "core/scenario/toml.hpp"
#include "core/session/comparison.hpp"
#include "core/session/run.hpp"
#include "core/session/time_series.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <sstream>
#include <utility>

namespace gaspard {
namespace {

class Comparison : public testing::Test {
  protected:
    Scenario small(const std::vector<std::string>& settings = {}) const {
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, scenario, {"domain.cells=12"});
        apply_settings(*catalogue, scenario, settings);
        return scenario;
    }
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(Comparison, EveryShippedScenarioIsForAllMethodsOfItsKind) {
    for (const auto& builtin : builtin_scenarios()) {
        const auto names = methods_for(*catalogue, find_scenario(*catalogue, std::string(builtin.name)));
        std::vector<std::string> expected = {"relaxation", "accelerated", "quasi-newton", "newton", "auto"};
        if (builtin.name.starts_with("spline"))
            expected = {"picard", "picard-mixed", "accelerated", "newton", "auto"};
        if (builtin.name.starts_with("layer")) expected = {"mesh-pde", "solution-adapted"};
        if (builtin.name.starts_with("layer-1d") || builtin.name.starts_with("burgers"))
            expected = {"mesh-pde", "bakhvalov", "shishkin", "equidistribute", "solution-adapted"};
        if (builtin.name.starts_with("transport")) expected = {"nvfem"};
        EXPECT_TRUE(std::is_permutation(names.begin(), names.end(), expected.begin(), expected.end()))
            << builtin.name;
    }
}

TEST_F(Comparison, AnotherMethodSolvesTheSameProblem) {
    const Scenario scenario = small({"method.tolerance=1e-6", "method.max_iterations=77"});
    const Scenario newton = with_method(*catalogue, scenario, "newton");
    EXPECT_EQ(newton.method.type, "newton");
    EXPECT_EQ(newton.method.values.real("tolerance"), 1e-6);
    EXPECT_EQ(newton.method.values.integer("max_iterations"), 77);
    EXPECT_EQ(newton.monitor, scenario.monitor);
    EXPECT_EQ(with_method(*catalogue, scenario, "relaxation"), scenario) << "its step stays as it is";
}

TEST_F(Comparison, TheTableSaysWhatTheHistoriesSay) {
    std::vector<ComparisonRow> rows;
    for (const std::string method : {"relaxation", "newton"}) {
        gaspard::Run run(catalogue, with_method(*catalogue, small(), method));
        run.solve();
        rows.push_back(comparison_row(method, run.history()));
        EXPECT_EQ(rows.back().iterations, run.history().back().iteration);
        const int inner =
            std::accumulate(run.history().begin(), run.history().end(), 0,
                            [](int sum, const StepReport& report) { return sum + report.inner_iterations; });
        EXPECT_EQ(rows.back().inner_iterations, inner);
        EXPECT_EQ(rows.back().status, RunStatus::converged);
    }
    EXPECT_NEAR(*rows[0].equidistribution, *rows[1].equidistribution, 1e-6) << "the same mesh";
    EXPECT_LT(rows[1].iterations, rows[0].iterations);
    EXPECT_EQ(rows[0].inner_iterations, 0);
    EXPECT_GT(rows[1].inner_iterations, 0);
    EXPECT_EQ(comparison_cells(rows[0]).size(), comparison_heads().size());
    std::istringstream csv(comparison_csv(rows));
    std::string head, first;
    std::getline(csv, head);
    std::getline(csv, first);
    EXPECT_EQ(std::count(head.begin(), head.end(), ','), std::count(first.begin(), first.end(), ','));
    EXPECT_TRUE(first.starts_with("relaxation," + std::to_string(rows[0].iterations) + ",0,")) << first;
    EXPECT_TRUE(first.ends_with(",converged")) << first;
}

TEST_F(Comparison, OneMeasureForAllMethodsAndTheirOwnByName) {
    Scenario scenario = find_scenario(*catalogue, "spline-circle");
    apply_settings(*catalogue, scenario, {"domain.cells=64"});
    const auto solved = [&](const std::string& method) {
        gaspard::Run run(catalogue, with_method(*catalogue, scenario, method));
        run.solve();
        // What Newton's method says of the same map is the residual in the table.
        const gaspard::Run newton(catalogue, with_method(*catalogue, scenario, "newton"),
                                  {.start = run.state()});
        const ComparisonRow row = comparison_row(method, run.history());
        EXPECT_NEAR(row.residual, newton.history().front().residual, 1e-13) << method;
        return row;
    };
    const ComparisonRow picard = solved("picard"), newton = solved("newton");
    EXPECT_EQ(picard.criterion, "increment");
    EXPECT_LT(picard.criterion_value, 1e-8);
    EXPECT_GT(std::abs(picard.criterion_value - picard.residual), 1e-10) << "two measures";
    EXPECT_EQ(newton.criterion, "residual");
    EXPECT_EQ(newton.criterion_value, newton.residual);
    EXPECT_TRUE(comparison_cells(picard)[6].starts_with("increment ")) << comparison_cells(picard)[6];
    EXPECT_TRUE(comparison_cells(newton)[6].starts_with("residual ")) << comparison_cells(newton)[6];
}

TEST_F(Comparison, IterationsOnCoarserMeshesAreCountedByThemselves) {
    for (const auto& [name, method] : {std::pair{"spline-circle", "picard"},
                                       {"spline-circle", "picard-mixed"},
                                       {"plane-bell", "newton"},
                                       {"plane-bell", "accelerated"}}) {
        Scenario scenario = find_scenario(*catalogue, name);
        apply_settings(*catalogue, scenario, {"domain.cells=64"});
        gaspard::Run run(catalogue, with_method(*catalogue, scenario, method));
        int coarse = 0; // updates made from a state of a coarser mesh
        while (run.status() == RunStatus::running) {
            const bool first = run.history().size() == 1; // goes to the coarsest mesh within the step
            const bool below = run.state().layout.find("n=64") == std::string::npos;
            run.step();
            if (first || below) ++coarse;
        }
        const ComparisonRow row = comparison_row(method, run.history());
        EXPECT_EQ(row.coarse_iterations, coarse) << method;
        EXPECT_GT(coarse, 1) << method;
        EXPECT_GT(row.iterations, coarse) << method;
        const auto finest = finest_reports(run.history());
        ASSERT_EQ(finest.size(), static_cast<std::size_t>(row.iterations - coarse) + 1) << method;
        for (std::size_t i = 0; i < finest.size(); ++i) EXPECT_EQ(finest[i].iteration, static_cast<int>(i));
    }
    Scenario scenario = find_scenario(*catalogue, "spline-circle");
    apply_settings(*catalogue, scenario, {"domain.cells=64", "method.start=identity"});
    gaspard::Run run(catalogue, scenario);
    run.solve();
    EXPECT_EQ(comparison_row("picard", run.history()).coarse_iterations, 0);
}

TEST_F(Comparison, IterationsOfTimeStepsAreCountedAndPlacedInTime) {
    const Scenario scenario =
        small({"time.end=0.1", "time.monitor.center_x=center_x + 0.5*t", "time.rule=tolerance"});
    gaspard::Run run(catalogue, with_method(*catalogue, scenario, "newton"));
    run.solve();
    int iterations = 0; // of the solve for the start, and of all time steps
    for (const StepReport& report : run.history())
        iterations = is_time_step(report)
                         ? iterations + static_cast<int>(*report.value(time_names::iterations))
                         : report.iteration;
    const ComparisonRow row = comparison_row("newton", run.history());
    EXPECT_EQ(row.iterations, iterations);
    EXPECT_GT(iterations, run.history().back().iteration) << "more than one in a step";
    EXPECT_EQ(row.coarse_iterations, 0);
    const auto points = comparison_points(scenario, run.history());
    ASSERT_EQ(points.size(), 6u) << "the solved start and five time steps";
    EXPECT_EQ(points.front().x, 0);
    EXPECT_LT(points.front().report->residual, 1e-8);
    EXPECT_EQ(points.back().x, 0.1);
    EXPECT_EQ(comparison_axis(scenario), "time t");
    const gaspard::Run unsolved(catalogue, scenario);
    EXPECT_TRUE(comparison_points(scenario, unsolved.history()).empty()) << "time has not begun";
    gaspard::Run still(catalogue, small());
    still.solve();
    const auto curve = comparison_points(small(), still.history());
    ASSERT_EQ(curve.size(), still.history().size());
    EXPECT_EQ(curve.back().x, still.history().back().iteration);
    EXPECT_EQ(comparison_axis(small()), "iteration on the finest mesh");
}

TEST_F(Comparison, WhatHasNotBegunHasNoNumbers) {
    const ComparisonRow row = comparison_row("auto", {});
    EXPECT_EQ(row.status, RunStatus::preparing);
    EXPECT_EQ(comparison_cells(row).size(), comparison_heads().size());
    EXPECT_EQ(comparison_cells(row)[1], "");
}

} // namespace
} // namespace gaspard
