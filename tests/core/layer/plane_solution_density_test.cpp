#include "core/base/error.hpp"
#include "core/layer/plane_solution_density.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

constexpr int plane_cells = 8;

/// Parameters of a uniform mesh, and the values of a function there.
struct ParameterGrid {
    Points parameters{(plane_cells + 1) * (plane_cells + 1)};
    TriangleSolution solution;
    explicit ParameterGrid(const std::function<double(double, double)>& u) {
        for (std::size_t j = 0; j <= plane_cells; ++j)
            for (std::size_t i = 0; i <= plane_cells; ++i) {
                const double s = static_cast<double>(i) / plane_cells,
                             t = static_cast<double>(j) / plane_cells;
                parameters.set(j * (plane_cells + 1) + i, {s, t});
                solution.values.push_back(u(s, t));
            }
    }
};

TEST(PlaneSolutionDensity, IsThatOfAnIntervalAlongEveryLine) {
    const ParameterGrid grid([](double s, double) { return std::exp(-8 * s); });
    for (const auto density : {SolutionDensity::arc_length, SolutionDensity::curvature}) {
        const TriangleDensities m =
            plane_solution_densities({.density = density}, grid.parameters, plane_cells, grid.solution);
        const std::span<const double> x(grid.parameters.x.data(), plane_cells + 1);
        const IntervalSolution line{
            .order = 1,
            .nodes = {{grid.solution.values.begin(), grid.solution.values.begin() + plane_cells + 1}},
            .middles = {}};
        const auto expected =
            smoothed_densities(density == SolutionDensity::curvature ? curvature_densities(x, line, 4)
                                                                     : arc_length_densities(x, line),
                               2);
        for (std::size_t q = 0; q < plane_cells * plane_cells; ++q)
            for (std::size_t t = 0; t < 4; ++t) {
                EXPECT_NEAR(m[0][4 * q + t], expected[q % plane_cells], 1e-12 * expected[q % plane_cells]);
                EXPECT_EQ(m[1][4 * q + t], 1) << "nothing changes in this direction";
            }
        EXPECT_GT(expected.front(), 2 * expected.back());
    }
}

// The size of u plays no part, and held sides, where u = 0, take the densities of their neighbours.
TEST(PlaneSolutionDensity, DoesNotDependOnTheSizeOfTheSolutionOnALine) {
    const ParameterGrid grid([](double s, double t) { return std::exp(-5 * s) * t * (1 - t); });
    const auto m = plane_solution_densities({}, grid.parameters, plane_cells, grid.solution);
    for (std::size_t j = 1; j < plane_cells; ++j)
        for (std::size_t i = 0; i < plane_cells; ++i)
            EXPECT_NEAR(m[0][4 * (j * plane_cells + i)], m[0][4 * i], 1e-12 * m[0][4 * i]) << i << ' ' << j;
    const ParameterGrid transposed([](double s, double t) { return std::exp(-5 * t) * s * (1 - s); });
    const auto other = plane_solution_densities({}, transposed.parameters, plane_cells, transposed.solution);
    for (std::size_t j = 0; j < plane_cells; ++j)
        for (std::size_t i = 0; i < plane_cells; ++i)
            EXPECT_NEAR(other[1][4 * (i * plane_cells + j) + 3], m[0][4 * (j * plane_cells + i) + 3], 1e-12);
}

TEST(PlaneSolutionDensity, RefusesWhatDoesNotFit) {
    const ParameterGrid grid([](double s, double t) { return s + t; });
    EXPECT_THROW(plane_solution_densities({}, grid.parameters, plane_cells - 1, grid.solution), InputError);
    EXPECT_THROW(plane_solution_densities({}, Points(4), 1, {1, {0, 0, 0, 0}}), InputError);
    EXPECT_THROW(plane_solution_densities({.density = SolutionDensity::estimate}, grid.parameters,
                                          plane_cells, grid.solution),
                 InputError);
    SquareMeshPde pde(MeshPdeForm::componentwise, DensitySamples::corners, SquareMeshPdeOptions{}.corners, 2);
    EXPECT_THROW(pde.solve(TriangleDensities{std::vector<double>(16, 1.0), std::vector<double>(15, 1.0)}),
                 InputError);
    EXPECT_THROW(pde.solve(TriangleDensities{std::vector<double>(16, 1.0), std::vector<double>(16, 0.0)}),
                 InputError);
}

} // namespace
} // namespace gaspard
