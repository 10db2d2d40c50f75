// Converged mesh PDEs on quadrilaterals: Newton's method from the result of Algorithm 3.
#include "core/layer/square_mesh_pde.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// (37).
LayerDensities varying_densities(double eps) {
    return [eps](const Points& x, std::span<double> m11, std::span<double> m22) {
        const auto layer = [](double width, double away) {
            return std::max(1.0, 0.4 * 0.99 / width * std::exp(-0.99 * away / (2.5 * width)));
        };
        for (std::size_t i = 0; i < m11.size(); ++i) {
            m11[i] = layer(eps * std::pow(1 + 2 * x.y[i], 2), 1 - x.x[i]);
            m22[i] = layer(eps * std::pow(3 - 2 * x.x[i], 2), 1 - x.y[i]);
        }
    };
}

/// (34).
LayerDensities two_sides(double eps) {
    return [eps](const Points& x, std::span<double> m11, std::span<double> m22) {
        const double b = 0.99 / (2.5 * eps);
        for (std::size_t i = 0; i < m11.size(); ++i) {
            m11[i] = 1;
            m22[i] = std::max(1.0, 0.28 * 0.99 / eps *
                                       (std::exp(-b * (x.y[i] - x.x[i] / 2)) + std::exp(-b * (1 - x.y[i]))));
        }
    };
}

SquareMeshPde algorithm_3(const LayerDensities& densities, int cells, const SquareMeshPdeOptions& options) {
    SquareMeshPde pde(options.form, options.samples, options.corners, coarsest_cells(cells, 4));
    while (pde.cells() < cells) {
        for (int i = 0; i < 4; ++i) pde.solve(densities);
        pde.refine();
    }
    for (int i = 0; i < 5; ++i) pde.solve(densities);
    return pde;
}

void expect_fixed_point(const LayerDensities& densities, int cells, const SquareMeshPdeOptions& options,
                        int steps, const char* what) {
    SquareMeshPde pde = algorithm_3(densities, cells, options);
    const auto result = converge_square(pde, densities, 1e-8, steps);
    EXPECT_TRUE(result.converged) << what << ' ' << cells << ' ' << result.residual;
    EXPECT_EQ(inverted_triangles(pde.nodes(), cells), 0U) << what << ' ' << cells;
    EXPECT_LT(pde.solve(densities).update, 1e-8) << what << ' ' << cells;
}

// The iteration of the fixed point itself never ends for eps <= 1e-6.
TEST(SquareNewton, ConvergesInBothDirections) {
    expect_fixed_point(varying_densities(1e-2), 16, {}, 4, "1e-2");
    expect_fixed_point(varying_densities(1e-4), 8, {}, 20, "1e-4");
    expect_fixed_point(varying_densities(1e-6), 8, {}, 40, "1e-6");
    expect_fixed_point(varying_densities(1e-6), 32, {}, 40, "1e-6");
    const SquareMeshPdeOptions corners{.samples = DensitySamples::corners};
    expect_fixed_point(varying_densities(1e-2), 9, corners, 12, "corners, 1e-2");
    expect_fixed_point(varying_densities(1e-8), 32, corners, 40, "corners, 1e-8");
}

TEST(SquareNewton, ConvergesInOneDirection) {
    SquareMeshPdeOptions options{.form = MeshPdeForm::one_direction,
                                 .corners = {Vec3{0, 0}, {1, 0.5}, {0, 1}, {1, 1}}};
    expect_fixed_point(two_sides(1e-2), 16, options, 5, "1e-2");
    expect_fixed_point(two_sides(1e-4), 16, options, 30, "1e-4");
    options.samples = DensitySamples::corners; // with degree 4 there are many solutions
    for (const double eps : {1e-2, 1e-4, 1e-6, 1e-8})
        for (const int cells : {16, 32}) expect_fixed_point(two_sides(eps), cells, options, 120, "corners");
}

TEST(SquareNewton, ConvergesQuadratically) {
    const LayerDensities densities = varying_densities(1e-2);
    SquareMeshPde pde = algorithm_3(densities, 16, {});
    pde.newton(densities);
    const auto second = pde.newton(densities), third = pde.newton(densities);
    EXPECT_EQ(second.factor, 1);
    EXPECT_LT(second.residual, 1e-3);
    EXPECT_LT(third.residual, 10 * second.residual * second.residual);
}

// Steps may increase the residual, but invert nothing; none changes an area by more than a factor of 7.4.
TEST(SquareNewton, StepsInvertNoTriangle) {
    const LayerDensities densities = varying_densities(1e-6);
    const SquareMeshPdeOptions options;
    SquareMeshPde pde(options.form, options.samples, options.corners, 8);
    for (int i = 0; i < 4; ++i) pde.solve(densities);
    bool damped = false;
    for (int i = 0; i < 12; ++i) {
        const Points before = pde.nodes();
        const auto step = pde.newton(densities);
        EXPECT_EQ(inverted_triangles(pde.nodes(), 8), 0U) << i;
        ASSERT_GT(step.factor, 0) << i;
        const double h = before.x[1] - before.x[0], now = pde.nodes().x[1] - pde.nodes().x[0];
        EXPECT_LT(std::abs(std::log(now / h)), 2 * std::log(7.4)) << i;
        damped = damped || step.factor < 1;
    }
    EXPECT_TRUE(damped);
}

// The cells at y = 1 have a width of 1e-10: rounding of y changes the flows by 1e-6.
TEST(SquareNewton, EndsWhereRoundingLeavesNothing) {
    const LayerDensities densities = two_sides(1e-8);
    const SquareMeshPdeOptions options{.form = MeshPdeForm::one_direction,
                                       .samples = DensitySamples::corners,
                                       .corners = {Vec3{0, 0}, {1, 0.5}, {0, 1}, {1, 1}}};
    SquareMeshPde pde = algorithm_3(densities, 16, options);
    EXPECT_TRUE(converge_square(pde, densities, 0).converged);
    const auto last = pde.newton(densities);
    EXPECT_GT(last.rounding, 1e-9);
    EXPECT_LT(last.residual, 4 * last.rounding);
}

} // namespace
} // namespace gaspard
