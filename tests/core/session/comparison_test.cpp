// Several methods on one problem.
#include "core/scenario/toml.hpp"
#include "core/session/comparison.hpp"
#include "core/session/run.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <sstream>

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

TEST_F(Comparison, WhatHasNotBegunHasNoNumbers) {
    const ComparisonRow row = comparison_row("auto", {});
    EXPECT_EQ(row.status, RunStatus::preparing);
    EXPECT_EQ(comparison_cells(row).size(), comparison_heads().size());
    EXPECT_EQ(comparison_cells(row)[1], "");
}

} // namespace
} // namespace gaspard
