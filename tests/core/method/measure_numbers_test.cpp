// The equidistribution in space of meshes with method.measure = physical, to 64 cells per side: the table of
// docs/splines.md.
#include "core/method/measured_runs.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(MeasureNumbers, TheEquidistributionTendsToZeroOnEveryPatch) {
    for (const MeasuredPatch& patch : measured_patches())
        for (const std::string method : {"picard", "picard-mixed", "newton"}) {
            std::vector<double> values;
            std::vector<int> iterations;
            for (const int cells : {16, 32, 64}) {
                const gaspard::Run run = measured_run(patch, method, cells, "physical");
                EXPECT_EQ(run.status(), RunStatus::converged) << patch.name << ' ' << method << cells;
                values.push_back(last_value(run, "equidistribution"));
                iterations.push_back(run.history().back().iteration);
            }
            EXPECT_GT(std::log2(values[0] / values[2]) / 2, 1.9) << patch.name << ' ' << method;
            EXPECT_LT(values[2], 1e-3) << patch.name << ' ' << method;
            EXPECT_NEAR(iterations[2], iterations[0], 13) << patch.name << ' ' << method;
        }
}

TEST(MeasureNumbers, OfTheParameterSquareItDoesNotInSpace) {
    for (const MeasuredPatch& patch : measured_patches()) {
        const gaspard::Run run = measured_run(patch, "newton", 64, "parameter");
        EXPECT_GT(last_value(run, "equidistribution"), 0.02) << patch.name;
        EXPECT_LT(last_value(run, "equidistribution_square"), 1e-3) << patch.name;
    }
}

} // namespace
} // namespace gaspard
