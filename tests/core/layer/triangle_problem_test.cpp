// Energy errors on layer-adapted triangles, as an independent implementation (FEniCS) has them.
#include "core/layer/square_mesh_pde.hpp"
#include "core/layer/triangle_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>

namespace gaspard {
namespace {

double layer(double width, double away) {
    return std::max(1.0, 0.4 * 0.99 / width * std::exp(-0.99 * away / (2.5 * width)));
}

// (35) with the exponent, on the meshes of (29), (37).
TEST(TriangleProblem, HasTheErrorsOfVaryingDiffusion) {
    const std::array<std::pair<double, std::array<double, 3>>, 3> cases = {
        {{1e-2, {3.74e-2, 1.87e-2, 9.38e-3}},
         {1e-4, {6.95e-3, 3.09e-3, 1.51e-3}},
         {1e-8, {4.12e-3, 1.04e-3, 2.62e-4}}}};
    for (const auto& [eps_of_case, expected] : cases) {
        const double eps = eps_of_case;
        const auto first = [eps](double y) { return eps * (1 + 2 * y) * (1 + 2 * y); };
        const auto second = [eps](double x) { return eps * (3 - 2 * x) * (3 - 2 * x); };
        const LayerDensities densities = [&](const Points& x, std::span<double> m11, std::span<double> m22) {
            for (std::size_t i = 0; i < m11.size(); ++i) {
                m11[i] = layer(first(x.y[i]), 1 - x.x[i]);
                m22[i] = layer(second(x.x[i]), 1 - x.y[i]);
            }
        };
        const TriangleProblem problem = {pointwise([&](double x, double y) {
            return TriangleCoefficients{.k1 = std::pow(first(y), 2),
                                        .k2 = std::pow(second(x), 2),
                                        .f = std::expm1(x) * std::expm1(y)};
        })};
        for (int k = 0, n = 16; k < 3; ++k, n *= 2) {
            const auto mesh = mesh_pde_square(densities, n, {});
            const auto p1 = solve_triangles(problem, mesh.x, n, 1),
                       p2 = solve_triangles(problem, mesh.x, n, 2);
            const double wanted = expected[static_cast<std::size_t>(k)];
            EXPECT_NEAR(reference_error(problem, mesh.x, n, p1, p2), wanted, 2.5e-3 * wanted)
                << eps << ' ' << n;
        }
    }
}

// With convection, which makes the matrix unsymmetric: order 2 at the nodes.
TEST(TriangleProblem, ConvergesForASmoothSolution) {
    const double pi = std::numbers::pi;
    const auto u = [pi](double x, double y) { return std::sin(pi * x) * std::sin(pi * y); };
    const TriangleProblem problem = {pointwise([&](double x, double y) {
        const double ux = pi * std::cos(pi * x) * std::sin(pi * y),
                     uy = pi * std::sin(pi * x) * std::cos(pi * y);
        return TriangleCoefficients{.k1 = 2,
                                    .k2 = 1,
                                    .c1 = 1,
                                    .c2 = -3,
                                    .r = 0.5,
                                    .f = 3 * pi * pi * u(x, y) + ux - 3 * uy + 0.5 * u(x, y)};
    })};
    std::array<double, 2> before = {1e9, 1e9};
    for (const int n : {8, 16, 32}) {
        Points x;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i)
                x.x.push_back(static_cast<double>(i) / n), x.y.push_back(static_cast<double>(j) / n),
                    x.z.push_back(0);
        for (const int order : {1, 2}) {
            const auto solution = solve_triangles(problem, x, n, order);
            double most = 0;
            const int fine = order * n;
            for (int j = 0; j <= fine; ++j)
                for (int i = 0; i <= fine; ++i)
                    most = std::max(
                        most, std::abs(solution.values[static_cast<std::size_t>(j * (fine + 1) + i)] -
                                       u(static_cast<double>(i) / fine, static_cast<double>(j) / fine)));
            double& last = before[static_cast<std::size_t>(order - 1)];
            EXPECT_LT(most, last / (order == 1 ? 3.4 : 6.5)) << n << ' ' << order;
            last = most;
        }
    }
}

} // namespace
} // namespace gaspard
