// Runs on patches are judged by the spline map, not by the cells that are drawn of it.
#include "core/method/spline_map.hpp"
#include "support/solved_run.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

double bound(const gaspard::Run& run) { return *run.history().back().value("bound_jacobian_psi"); }

/// det grad Psi from the derivatives of its components, without polynomials on cells.
double determinant(const std::vector<SplineFunction>& psi, double x, double y) {
    const auto slope = [&](std::size_t component, std::array<int, 3> orders) {
        return evaluate(psi[component].space, psi[component].coefficients, {x, y, 0}, orders);
    };
    return slope(0, {1, 0, 0}) * slope(1, {0, 1, 0}) - slope(0, {0, 1, 0}) * slope(1, {1, 0, 0});
}

struct Sampled {
    double smallest = 1e300, x = 0, y = 0;
};

/// On a grid of the square, then on ever finer grids around the smallest value.
Sampled smallest_sample(const gaspard::Run& run, int points) {
    const auto psi = *spline_map(run.state());
    Sampled best;
    double left = 0, bottom = 0, size = 1;
    for (int level = 0; level < 6; ++level) {
        for (int j = 0; j <= points; ++j)
            for (int i = 0; i <= points; ++i) {
                const double x = std::clamp(left + size * i / points, 0.0, 1.0),
                             y = std::clamp(bottom + size * j / points, 0.0, 1.0);
                const double value = determinant(psi, x, y);
                if (value < best.smallest) best = {value, x, y};
            }
        size *= 4.0 / points;
        left = best.x - size / 2, bottom = best.y - size / 2;
        points = std::min(points, 40);
    }
    return best;
}

struct FoldCase {
    std::string scenario;
    std::vector<std::string> settings;
    double smallest; ///< of det grad Psi, to three digits
    RunStatus status;
    std::size_t folded;
    int samples; ///< per direction, where plain sampling starts
};

class MapFolds : public testing::TestWithParam<FoldCase> {};
INSTANTIATE_TEST_SUITE_P(
    Cases, MapFolds,
    testing::Values(
        // Cells of order 2 fold: eight of these sixteen, and eight of the face.
        FoldCase{"spline-circle", {"domain.cells=4", "domain.degree=7"}, 0.265, RunStatus::converged, 0, 200},
        FoldCase{"spline-face", {"domain.cells=32"}, 0.0451, RunStatus::converged, 0, 256},
        // The map folds between the points of a grid of 100 x 100.
        FoldCase{"spline-spiral", {"domain.cells=32"}, -0.2135, RunStatus::tangled, 4, 256}),
    [](const auto& one) { return one.param.scenario.substr(7); });

TEST_P(MapFolds, JudgeTheMeshWhateverItsCells) {
    const gaspard::Run run = solved_run(GetParam().scenario, GetParam().settings);
    EXPECT_EQ(run.status(), GetParam().status);
    EXPECT_EQ(run.history().back().tangled_cells, GetParam().folded);
    EXPECT_NEAR(bound(run), GetParam().smallest, 5e-4);
}

TEST_P(MapFolds, AreWhereSamplingFindsThem) {
    gaspard::Run run = solved_run(GetParam().scenario, GetParam().settings);
    const Sampled sampled = smallest_sample(run, GetParam().samples);
    EXPECT_LE(bound(run), sampled.smallest + 1e-12);
    EXPECT_NEAR(bound(run), sampled.smallest, 2e-5);
    const auto snapshot = run.snapshot();
    ASSERT_NE(snapshot->tangled, nullptr);
    EXPECT_EQ(snapshot->tangled->size(), GetParam().folded);
    const auto cells = static_cast<double>(run.scenario().domain.values.integer("cells"));
    const auto cell =
        static_cast<std::uint32_t>(std::floor(sampled.y * cells) * cells + std::floor(sampled.x * cells));
    EXPECT_EQ(std::count(snapshot->tangled->begin(), snapshot->tangled->end(), cell),
              sampled.smallest <= 0 ? 1 : 0);
}

TEST(MapFoldsInCells, AreSaidApartFromThoseOfTheMap) {
    const gaspard::Run run = solved_run("spline-two-circles", {"domain.cells=4"});
    const StepReport& last = run.history().back();
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_EQ(last.tangled_cells, 0u);
    EXPECT_GT(bound(run), 0.1);
    EXPECT_EQ(last.value("folded_drawn_cells"), 2);
    EXPECT_EQ(last.note, "2 of 16 drawn cells fold; the map does not");
}

TEST(MapFoldsOnAGrid, TheGridOfThePaperMissesTheSpirals) {
    const gaspard::Run run = solved_run("spline-spiral", {"domain.cells=32"});
    EXPECT_GT(*run.history().back().value("min_jacobian_psi"), 0.03);
    EXPECT_LT(bound(run), -0.21);
}

} // namespace
} // namespace gaspard
