// Meshes of an interval from solutions alone, beside those from densities that know eps.
#include "core/base/error.hpp"
#include "core/layer/solution_density.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <span>

namespace gaspard {
namespace {

/// -eps^2 u'' + u = source.
IntervalProblem boundary_layers(double eps, double (*source)(double)) {
    return {{eps * eps}, [=](std::span<const double> x, IntervalCoefficients& at) {
                std::fill(at.reaction.begin(), at.reaction.end(), 1.0);
                std::transform(x.begin(), x.end(), at.source.begin(), source);
            }};
}
/// (6).
IntervalProblem boundary_layers(double eps) {
    return boundary_layers(eps, [](double x) { return 1 - x; });
}
double error_of_6(double eps, const std::vector<double>& x) {
    const double d = -std::expm1(-2 / eps);
    const IntervalExact exact = {
        [=](double t) { return 1 - t - (std::exp(-t / eps) - std::exp(-(2 - t) / eps)) / d; },
        [=](double t) { return -1 + (std::exp(-t / eps) + std::exp(-(2 - t) / eps)) / (eps * d); }};
    const IntervalProblem problem = boundary_layers(eps);
    return exact_error(problem, x, solve_interval(problem, x, 1), exact);
}

/// sqrt(eps) / N times what (18) gives for small eps (Table 3 of Hill, Madden: 1.325 at N = 32, 1.326 at
/// 256).
double error_of_18(double eps, int cells) { return 1.326 * std::sqrt(eps) / cells; }

TEST(SolutionDensity, FindsALayerOfAnyWidth) {
    for (const double eps : {1e-4, 1e-6, 1e-8})
        for (const int cells : {32, 128}) {
            const auto error = [&](SolutionDensity density) {
                return error_of_6(eps, mesh_from_solution(boundary_layers(eps), {}, cells, {density})) /
                       error_of_18(eps, cells);
            };
            EXPECT_LT(error(SolutionDensity::arc_length), 1.6) << eps << ' ' << cells;
            EXPECT_LT(error(SolutionDensity::curvature), 1) << eps << ' ' << cells;
            EXPECT_LT(error(SolutionDensity::estimate), 1.1) << eps << ' ' << cells;
        }
}

// -eps^2 u'' + u = 1 + x has layers at both ends, of different heights.
TEST(SolutionDensity, FindsLayersAtBothEndsByArcLength) {
    for (const double eps : {1e-2, 1e-4, 1e-6, 1e-8}) {
        const IntervalProblem problem = boundary_layers(eps, [](double x) { return 1 + x; });
        const auto x = mesh_from_solution(problem, {}, 64, {});
        const double error =
            reference_error(problem, x, solve_interval(problem, x, 1), solve_interval(problem, x, 2));
        EXPECT_LT(error, 6.5 * std::sqrt(eps) / 64) << eps;
    }
}

TEST(SolutionDensity, EstimatesTheErrorOfAResolvedLayer) {
    for (const double eps : {1.0, 1e-2, 1e-6}) {
        const auto x = mesh_from_solution(boundary_layers(eps), {}, 128, {SolutionDensity::estimate});
        const IntervalProblem problem = boundary_layers(eps);
        const double estimate = estimated_error(problem, x, solve_interval(problem, x, 1));
        EXPECT_NEAR(estimate / error_of_6(eps, x), 1, 0.02) << eps;
    }
}

// On 8 cells Galerkin's solution oscillates everywhere. A density for exp(-(1 - x)/eps), of the form of (18),
// gives 1.33 / N.
TEST(SolutionDensity, FindsALayerOfConvection) {
    for (const double eps : {1e-2, 1e-6, 1e-8}) {
        const IntervalProblem problem = {{eps}, [](std::span<const double>, IntervalCoefficients& at) {
                                             std::fill(at.convection.begin(), at.convection.end(), 1.0);
                                             std::fill(at.source.begin(), at.source.end(), 1.0);
                                         }};
        for (const int cells : {32, 128}) {
            const auto error = [&](SolutionDensity density) {
                const auto x = mesh_from_solution(problem, {}, cells, {density});
                return reference_error(problem, x, solve_interval(problem, x, 1),
                                       solve_interval(problem, x, 2)) *
                       cells / 1.33;
            };
            EXPECT_LT(error(SolutionDensity::arc_length), 1.6) << eps << ' ' << cells;
            EXPECT_LT(error(SolutionDensity::curvature), 1) << eps << ' ' << cells;
            EXPECT_LT(error(SolutionDensity::estimate), 1) << eps << ' ' << cells;
        }
    }
}

// Slopes 1, 4, 2 on cells of width 1, 1/2, 1/2; u'' is 4 and 4 at the inner nodes.
TEST(SolutionDensity, IsThatOfTheFormulas) {
    const std::vector<double> x = {0, 1, 1.5, 2};
    const IntervalSolution solution{1, {{0, 1, 3, 4}}, {}};
    const auto arc = arc_length_densities(x, solution); // the mean slope is 2
    EXPECT_DOUBLE_EQ(arc[0], std::sqrt(1.25));
    EXPECT_DOUBLE_EQ(arc[1], std::sqrt(5));
    EXPECT_DOUBLE_EQ(arc[2], std::sqrt(2));
    for (const double density : curvature_densities(x, solution, 4))
        EXPECT_DOUBLE_EQ(density, std::pow(2, 0.25));
    const IntervalProblem problem = {{3}, [](std::span<const double>, IntervalCoefficients&) {}};
    // eta^2 = 3 h^3 16 / 12 + h^5 16 / 120 = 4 h^3 + 2 h^5 / 15
    const double first = 4 + 2.0 / 15, other = 0.5 + 1.0 / 240;
    EXPECT_DOUBLE_EQ(estimated_error(problem, x, solution), std::sqrt(first + 2 * other));
    const double mean = (std::cbrt(first) + 2 * std::cbrt(other)) / 2;
    const auto estimate = estimate_densities(problem, x, solution);
    EXPECT_DOUBLE_EQ(estimate[0], 1 + std::cbrt(first) / mean);
    EXPECT_DOUBLE_EQ(estimate[2], 1 + std::cbrt(other) / 0.5 / mean);
    const IntervalSolution constant{1, {{2, 2, 2, 2}}, {}};
    EXPECT_EQ(arc_length_densities(x, constant), std::vector<double>(3, 1.0));
    EXPECT_EQ(curvature_densities(x, constant), std::vector<double>(3, 1.0));
    EXPECT_EQ(estimate_densities(problem, x, constant), std::vector<double>(3, 1.0));
}

TEST(SolutionDensity, SmoothsAndIsAMonitor) {
    EXPECT_EQ(smoothed_densities({1, 5, 1}, 1), (std::vector<double>{2, 3, 2}));
    EXPECT_EQ(smoothed_densities({1, 5, 1}, 0), (std::vector<double>{1, 5, 1}));
    const auto monitor = cell_monitor({0, 1, 3}, {7, 9});
    Points at(4);
    at.x = {0, 0.99, 1, 3};
    std::vector<double> values(4);
    monitor->values(at, values);
    EXPECT_EQ(values, (std::vector<double>{7, 7, 9, 9}));
}

TEST(SolutionDensity, SaysWhatIsWrong) {
    EXPECT_THROW(arc_length_densities(std::vector<double>{0, 1}, {1, {{0, 1}}, {}}), InputError);
    EXPECT_THROW(arc_length_densities(std::vector<double>{0, 1, 2}, {1, {{0, 1}}, {}}), InputError);
    EXPECT_THROW(curvature_densities(std::vector<double>{0, 1, 2}, {1, {{0, 1, 0}}, {}}, 0.5), InputError);
    EXPECT_THROW(cell_monitor({0, 1}, {1, 2}), InputError);
    EXPECT_THROW(mesh_from_solution(boundary_layers(1), {}, 8, {.start_cells = 2}), InputError);
    EXPECT_THROW(mesh_from_solution(boundary_layers(1), {}, 4, {}), InputError);
}

} // namespace
} // namespace gaspard
