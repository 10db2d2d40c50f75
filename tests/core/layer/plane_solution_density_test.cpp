#include "core/base/error.hpp"
#include "core/layer/plane_solution_density.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

constexpr int n = 8;

/// Parameters of a uniform mesh, and the values of a function there.
struct Grid {
    Points parameters{(n + 1) * (n + 1)};
    TriangleSolution solution;
    explicit Grid(const std::function<double(double, double)>& u) {
        for (std::size_t j = 0; j <= n; ++j)
            for (std::size_t i = 0; i <= n; ++i) {
                const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
                parameters.set(j * (n + 1) + i, {s, t});
                solution.values.push_back(u(s, t));
            }
    }
};

TEST(PlaneSolutionDensity, IsThatOfAnIntervalAlongEveryLine) {
    const Grid grid([](double s, double) { return std::exp(-5 * s); });
    for (const auto density : {SolutionDensity::arc_length, SolutionDensity::curvature}) {
        const TriangleDensities m =
            plane_solution_densities({.density = density}, grid.parameters, n, grid.solution);
        const std::span<const double> x(grid.parameters.x.data(), n + 1);
        const IntervalSolution line{
            .order = 1,
            .nodes = {{grid.solution.values.begin(), grid.solution.values.begin() + n + 1}},
            .middles = {}};
        const auto expected =
            smoothed_densities(density == SolutionDensity::curvature ? curvature_densities(x, line)
                                                                     : arc_length_densities(x, line),
                               2);
        for (std::size_t q = 0; q < n * n; ++q)
            for (std::size_t t = 0; t < 4; ++t) {
                EXPECT_NEAR(m[0][4 * q + t], expected[q % n], 1e-12 * expected[q % n]);
                EXPECT_EQ(m[1][4 * q + t], 1) << "nothing changes in this direction";
            }
        EXPECT_GT(expected.front(), 2 * expected.back());
    }
}

// The size of u plays no part, and held sides, where u = 0, take the densities of their neighbours.
TEST(PlaneSolutionDensity, DoesNotDependOnTheSizeOfTheSolutionOnALine) {
    const Grid grid([](double s, double t) { return std::exp(-5 * s) * t * (1 - t); });
    const auto m = plane_solution_densities({}, grid.parameters, n, grid.solution);
    for (std::size_t j = 1; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_NEAR(m[0][4 * (j * n + i)], m[0][4 * i], 1e-12 * m[0][4 * i]) << i << ' ' << j;
    const Grid transposed([](double s, double t) { return std::exp(-5 * t) * s * (1 - s); });
    const auto other = plane_solution_densities({}, transposed.parameters, n, transposed.solution);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_NEAR(other[1][4 * (i * n + j) + 3], m[0][4 * (j * n + i) + 3], 1e-12);
}

TEST(PlaneSolutionDensity, RefusesWhatDoesNotFit) {
    const Grid grid([](double s, double t) { return s + t; });
    EXPECT_THROW(plane_solution_densities({}, grid.parameters, n - 1, grid.solution), InputError);
    EXPECT_THROW(plane_solution_densities({}, Points(4), 1, {1, {0, 0, 0, 0}}), InputError);
    EXPECT_THROW(
        plane_solution_densities({.density = SolutionDensity::estimate}, grid.parameters, n, grid.solution),
        InputError);
    SquareMeshPde pde(MeshPdeForm::componentwise, DensitySamples::corners, SquareMeshPdeOptions{}.corners, 2);
    EXPECT_THROW(pde.solve(TriangleDensities{std::vector<double>(16, 1.0), std::vector<double>(15, 1.0)}),
                 InputError);
    EXPECT_THROW(pde.solve(TriangleDensities{std::vector<double>(16, 1.0), std::vector<double>(16, 0.0)}),
                 InputError);
}

} // namespace
} // namespace gaspard
