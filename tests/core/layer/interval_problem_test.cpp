// Solutions on an interval beside Hill, Madden (2021) and beside closed forms.
#include "core/layer/interval_mesh.hpp"
#include "core/layer/interval_problem.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <span>

namespace gaspard {
namespace {

/// One component, from the coefficients c, r, f at one point.
IntervalProblem scalar_problem(double diffusion,
                               const std::function<std::array<double, 3>(double)>& at_point) {
    return {{diffusion}, [=](std::span<const double> x, IntervalCoefficients& at) {
                for (std::size_t i = 0; i < x.size(); ++i) {
                    const auto [c, r, f] = at_point(x[i]);
                    at.convection[i] = c, at.reaction[i] = r, at.source[i] = f;
                }
            }};
}
/// (6).
IntervalProblem reaction_diffusion(double eps) {
    return scalar_problem(eps * eps, [](double x) { return std::array{0.0, 1.0, 1 - x}; });
}
IntervalExact exact_solution(double eps) {
    const double d = -std::expm1(-2 / eps);
    return {[=](double x) { return 1 - x - (std::exp(-x / eps) - std::exp(-(2 - x) / eps)) / d; },
            [=](double x) { return -1 + (std::exp(-x / eps) + std::exp(-(2 - x) / eps)) / (eps * d); }};
}

// The errors of Table 3 on Bakhvalov's mesh agree to three digits for small eps, as the paper says.
TEST(IntervalProblem, HasTheErrorsOfSmallEps) {
    for (const double eps : {1e-4, 1e-6, 1e-8}) {
        const auto x = bakhvalov_mesh({.eps = eps}, {}, 1024).x;
        const IntervalProblem problem = reaction_diffusion(eps);
        const auto p1 = solve_interval(problem, x, 1), p2 = solve_interval(problem, x, 2);
        const double expected = 1.295e-3 * std::sqrt(eps);
        EXPECT_NEAR(reference_error(problem, x, p1, p2), expected, 2e-3 * expected);
        EXPECT_NEAR(exact_error(problem, x, p1, exact_solution(eps)), expected, 2e-3 * expected);
    }
}

TEST(IntervalProblem, ConvergesWithTheOrderOfItsElements) {
    const IntervalExact u = {[](double x) { return std::sin(std::numbers::pi * x); },
                             [](double x) { return std::numbers::pi * std::cos(std::numbers::pi * x); }};
    const IntervalProblem problem = scalar_problem(0.5, [&](double x) {
        const double pi = std::numbers::pi;
        return std::array{1 + x, x * x,
                          0.5 * pi * pi * u.value(x) + (1 + x) * u.slope(x) + x * x * u.value(x)};
    });
    double before = 0, middle_before = 0;
    for (const int cells : {16, 32, 64}) {
        const auto x = uniform_interval({}, cells);
        const auto p1 = solve_interval(problem, x, 1), p2 = solve_interval(problem, x, 2);
        const double error = exact_error(problem, x, p1, u);
        double middle = 0;
        for (std::size_t i = 0; i < p2.middles[0].size(); ++i)
            middle = std::max(middle, std::abs(p2.middles[0][i] - u.value(0.5 * (x[i] + x[i + 1]))));
        if (before > 0) {
            EXPECT_NEAR(before / error, 2, 0.02);
            EXPECT_GT(middle_before / middle, 7.5);
        }
        before = error, middle_before = middle;
    }
}

// On a uniform mesh the layer falls between two nodes: the reference of order 2 knows as little of it.
TEST(IntervalProblem, ExactErrorSeesALayerThatTheReferenceMisses) {
    const double eps = 1e-6;
    const IntervalProblem problem = reaction_diffusion(eps);
    const auto x = uniform_interval({}, 64);
    const auto p1 = solve_interval(problem, x, 1), p2 = solve_interval(problem, x, 2);
    // u_h is close to the reduced solution next to the layer, whose energy is eps/2 + ...
    const double exact = exact_error(problem, x, p1, exact_solution(eps));
    EXPECT_GT(exact, 0.03);
    EXPECT_GT(exact, 1.25 * reference_error(problem, x, p1, p2));
}

// -e u'' + c u' = 1, c = 1 and -1, has a closed form; fitting is exact at the nodes of a uniform mesh.
TEST(IntervalProblem, ExponentialFittingIsExactAtNodes) {
    const std::vector<double> x = uniform_interval({}, 8);
    for (const double e : {1.0, 1e-2, 1e-6})
        for (const double c : {1.0, -1.0}) {
            const auto problem = scalar_problem(e, [c](double) { return std::array{c, 0.0, 1.0}; });
            const auto fitted = solve_fitted(problem, x).nodes[0];
            for (std::size_t i = 0; i < x.size(); ++i) {
                const double t = c > 0 ? x[i] : 1 - x[i];
                const double u = t - std::exp((t - 1) / e) * std::expm1(-t / e) / std::expm1(-1 / e);
                EXPECT_NEAR(fitted[i], u, 1e-12) << e << ' ' << c << ' ' << i;
            }
        }
    const auto stiff = scalar_problem(1e-2, [](double) { return std::array{1.0, 0.0, 1.0}; });
    EXPECT_GT(std::abs(solve_interval(stiff, x, 1).nodes[0][7] - 0.875), 0.1) << "Galerkin's is not";
}

TEST(IntervalProblem, ExponentialFittingIsGalerkinsMethodWithoutConvection) {
    const std::vector<double> x = {0, 0.1, 0.4, 0.5, 0.95, 1};
    const auto fitted = solve_fitted(reaction_diffusion(1e-2), x).nodes[0],
               galerkin = solve_interval(reaction_diffusion(1e-2), x, 1).nodes[0];
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(fitted[i], galerkin[i], 1e-14) << i;
}

} // namespace
} // namespace gaspard
