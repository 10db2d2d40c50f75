// Bounds of det grad Psi against polynomials whose minimum is known, and against plain sampling.
#include "core/spline/jacobian_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace gaspard {
namespace {

using Map = std::array<SplineFunction, 2>;

/// A function of two variables that the space contains, by interpolation.
template <class Function>
SplineFunction spline(const KnotVector& x, const KnotVector& y, const Function& function) {
    const auto at_x = greville(x), at_y = greville(y);
    const LineMatrix to_x = interpolation(x), to_y = interpolation(y);
    SplineFunction result{{{x, y}}, std::vector<double>(x.size() * y.size(), 0.0)};
    for (std::size_t j = 0; j < y.size(); ++j)
        for (std::size_t i = 0; i < x.size(); ++i)
            for (std::size_t l = 0; l < y.size(); ++l)
                for (std::size_t k = 0; k < x.size(); ++k)
                    result.coefficients[j * x.size() + i] +=
                        to_y(j, l) * to_x(i, k) * function(at_x[k], at_y[l]);
    return result;
}

/// J = low + 4 (x - 0.37)^2 along a line of slope 0, or of slope -1: low + 4 (x + y - 0.77)^2.
Map valley(double low, bool oblique, std::size_t cells) {
    const KnotVector line = uniform_knots(3, cells);
    const auto straight = [low](double x, double) { return low * x + 4 * std::pow(x - 0.37, 3) / 3; };
    const auto across = [low](double x, double y) { return low * x + 4 * std::pow(x + y - 0.77, 3) / 3; };
    const auto second = [](double, double y) { return y; };
    return {oblique ? spline(line, line, across) : spline(line, line, straight), spline(line, line, second)};
}

double jacobian(const Map& map, Vec3 at) {
    const auto slope = [&](std::size_t component, std::array<int, 3> orders) {
        return evaluate(map[component].space, map[component].coefficients, at, orders);
    };
    return slope(0, {1, 0, 0}) * slope(1, {0, 1, 0}) - slope(0, {0, 1, 0}) * slope(1, {1, 0, 0});
}

TEST(JacobianBounds, FindTheMinimumOfAPolynomialBetweenAnySamples) {
    for (const bool oblique : {false, true}) {
        const double low = oblique ? 1e-4 : 1e-6; // not negative for |x - .37| < 5e-4
        const JacobianBounds above = bound_jacobian(valley(low, oblique, 5), 5);
        EXPECT_TRUE(above.folded.empty());
        EXPECT_LE(above.bound, low + 1e-12);
        EXPECT_GE(above.smallest, low - 1e-12);
        EXPECT_GT(above.bound, 0);
        EXPECT_LT(above.smallest - above.bound, 8 * jacobian_tolerance);
        const JacobianBounds below = bound_jacobian(valley(-low, oblique, 5), 5);
        EXPECT_NEAR(below.bound, -low, 8 * jacobian_tolerance);
        if (oblique) // the diagonal x + y = .77 crosses these cells
            EXPECT_EQ(below.folded, (std::vector<std::uint32_t>{2, 3, 6, 7, 10, 11, 15}));
        else
            EXPECT_EQ(below.folded, (std::vector<std::uint32_t>{1, 6, 11, 16, 21}));
    }
}

TEST(JacobianBounds, CellsMayBeFinerThanTheSplines) {
    const JacobianBounds bounds = bound_jacobian(valley(-1e-3, false, 5), 20);
    ASSERT_EQ(bounds.folded.size(), 20u); // .354 to .386 is within the eighth of 20 columns
    for (const std::uint32_t cell : bounds.folded) EXPECT_EQ(cell % 20, 7u);
    EXPECT_NEAR(bounds.smallest, -1e-3, 8 * jacobian_tolerance);
}

TEST(JacobianBounds, TheIdentityIsCertainWithoutSubdivision) {
    const KnotVector line = uniform_knots(7, 16);
    const auto first = [](double x, double) { return x; };
    const auto second = [](double, double y) { return y; };
    const JacobianBounds bounds = bound_jacobian({spline(line, line, first), spline(line, line, second)}, 16);
    EXPECT_TRUE(bounds.folded.empty());
    EXPECT_NEAR(bounds.smallest, 1, 1e-9); // the rounding of degree 12
    EXPECT_NEAR(bounds.bound, 1, 1e-9);
}

TEST(JacobianBounds, AreNoneWhereTheMapIsNoNumber) {
    Map map = valley(1, false, 5);
    map[0].coefficients[0] = std::numeric_limits<double>::quiet_NaN();
    const JacobianBounds bounds = bound_jacobian(map, 5);
    ASSERT_FALSE(bounds.folded.empty());
    EXPECT_EQ(bounds.folded.front(), 0u);
    EXPECT_EQ(bounds.bound, -std::numeric_limits<double>::infinity());
    EXPECT_GE(bounds.smallest, 1 - 1e-12) << "of the other cells";
}

/// Maps of either form of the spline spaces, disturbed at random so that some cells fold.
TEST(JacobianBounds, EncloseDenseSamplesOfRandomMaps) {
    std::mt19937 random(5);
    for (const int degree : {2, 3, 5, 7})
        for (const bool mixed : {false, true}) {
            const KnotVector upper = uniform_knots(degree, 4), lower = derivative_space(upper);
            const KnotVector &x = mixed ? upper : lower, &y = mixed ? lower : upper;
            Map map{spline(x, y, [](double a, double) { return a; }),
                    spline(y, x, [](double, double b) { return b; })};
            std::uniform_real_distribution<double> shift(-0.2, 0.2);
            for (SplineFunction& component : map)
                for (double& value : component.coefficients) value += shift(random);
            const JacobianBounds bounds = bound_jacobian(map, 4);
            double smallest = 1e300;
            std::vector<char> folded(16, 0);
            constexpr std::size_t fine = 100; // samples per cell and direction, borders included
            const auto place = [](std::size_t k) {
                const double t = static_cast<double>(k % (fine + 1)) / fine;
                return (static_cast<double>(k / (fine + 1)) + std::clamp(t, 1e-9, 1 - 1e-9)) / 4;
            };
            for (std::size_t j = 0; j < 4 * (fine + 1); ++j)
                for (std::size_t i = 0; i < 4 * (fine + 1); ++i) {
                    const double value = jacobian(map, {place(i), place(j), 0});
                    smallest = std::min(smallest, value);
                    if (value <= 0) folded[4 * (j / (fine + 1)) + i / (fine + 1)] = 1;
                }
            EXPECT_LE(bounds.bound, smallest) << degree;
            EXPECT_LT(smallest - bounds.smallest, 0.02 * std::abs(smallest) + 1e-3) << degree;
            EXPECT_LE(bounds.smallest - bounds.bound, 1e-4) << degree;
            for (std::uint32_t c = 0; c < 16; ++c) {
                if (folded[c] == 0) continue;
                EXPECT_TRUE(std::find(bounds.folded.begin(), bounds.folded.end(), c) != bounds.folded.end())
                    << degree << ", cell " << c;
            }
            EXPECT_FALSE(bounds.folded.empty()) << degree;
        }
}

TEST(JacobianBounds, WhatIsNotANumberFolds) {
    Map map = valley(1, false, 4);
    map[0].coefficients[0] = std::nan("");
    EXPECT_EQ(bound_jacobian(map, 4).folded, std::vector<std::uint32_t>{0});
}

} // namespace
} // namespace gaspard
