// Transport between shapes that no affine map exchanges, from the start to the solution.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

StepReport transported(const std::vector<std::string>& settings) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "transport-ring");
    apply_settings(*catalogue, scenario, {"domain.cells=24"});
    apply_settings(*catalogue, scenario, settings);
    Run run(catalogue, std::move(scenario));
    while (run.status() == RunStatus::running) run.step();
    EXPECT_EQ(run.status(), RunStatus::converged);
    return run.history().back();
}

const std::vector<std::string> square_to_triangle = {"domain.shape=polygon", "domain.target.shape=polygon",
                                                     "domain.target.points=-1 -1, 1 -1, 0 1"};

TEST(TransportShapes, ASquareGoesToATriangle) {
    std::vector<std::string> settings = square_to_triangle;
    settings.emplace_back("monitor.type=constant");
    const StepReport report = transported(settings);
    EXPECT_EQ(report.tangled_cells, 0U);
    EXPECT_GT(report.value("convexity").value(), 0);
    EXPECT_LT(report.iteration, 30);
}

// No continuation in powers of the densities without steps for equal densities before it.
TEST(TransportShapes, ASquareGoesToATriangleWithWaves) {
    std::vector<std::string> settings = square_to_triangle;
    settings.insert(settings.end(), {"monitor.type=random-waves", "monitor.contrast=10"});
    const StepReport report = transported(settings);
    EXPECT_EQ(report.tangled_cells, 0U);
    EXPECT_LT(report.iteration, 40);
}

// The continuation begins on the coarsest mesh.
TEST(TransportShapes, DensitiesOnBothSides) {
    const StepReport report = transported({"domain.target.shape=polygon", "monitor.type=bell",
                                           "monitor.amplitude=10", "monitor.source.type=random-waves"});
    EXPECT_EQ(report.tangled_cells, 0U);
    EXPECT_LT(report.iteration, 40);
}

} // namespace
} // namespace gaspard
