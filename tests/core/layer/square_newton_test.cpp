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
    expect_fixed_point(varying_densities(1e-4), 8, {}, 14, "1e-4");
    expect_fixed_point(varying_densities(1e-6), 8, {}, 32, "1e-6");
    expect_fixed_point(varying_densities(1e-8), 4, {}, 30, "1e-8");
    expect_fixed_point(varying_densities(1e-2), 9, {.samples = DensitySamples::corners}, 12, "corners");
}

TEST(SquareNewton, ConvergesInOneDirection) {
    const SquareMeshPdeOptions options{.form = MeshPdeForm::one_direction,
                                       .corners = {Vec3{0, 0}, {1, 0.5}, {0, 1}, {1, 1}}};
    expect_fixed_point(two_sides(1e-2), 16, options, 5, "1e-2");
    expect_fixed_point(two_sides(1e-4), 16, options, 12, "1e-4");
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

// Whatever the start, a step inverts nothing and what it accepts is better.
TEST(SquareNewton, ShortensStepsThatInvertTriangles) {
    const LayerDensities densities = varying_densities(1e-6);
    const SquareMeshPdeOptions options;
    SquareMeshPde pde(options.form, options.samples, options.corners, 8);
    for (int i = 0; i < 4; ++i) pde.solve(densities);
    bool shortened = false;
    double before = 1e300;
    for (int i = 0; i < 12; ++i) {
        const auto step = pde.newton(densities);
        EXPECT_EQ(inverted_triangles(pde.nodes(), 8), 0U) << i;
        EXPECT_LT(step.residual, before) << i;
        before = step.factor > 0 ? step.residual : 1e300;
        shortened = shortened || (step.factor > 0 && step.factor < 1);
    }
    EXPECT_TRUE(shortened);
}

} // namespace
} // namespace gaspard
