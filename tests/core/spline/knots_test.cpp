#include "core/spline/knots.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <tuple>

namespace gaspard {
namespace {

/// The recursion (2.3), (2.4) as printed; x in [0, 1), or left of a knot.
double cox_de_boor(const std::vector<double>& t, std::size_t i, int p, double x) {
    if (p == 0) return t[i] <= x && x < t[i + 1];
    const auto q = static_cast<std::size_t>(p);
    double sum = 0;
    if (t[i + q] > t[i]) sum += (x - t[i]) / (t[i + q] - t[i]) * cox_de_boor(t, i, p - 1, x);
    if (t[i + q + 1] > t[i + 1])
        sum += (t[i + q + 1] - x) / (t[i + q + 1] - t[i + 1]) * cox_de_boor(t, i + 1, p - 1, x);
    return sum;
}

double evaluate(const KnotVector& space, const std::vector<double>& coefficients, double x,
                int derivative = 0) {
    const auto p = static_cast<std::size_t>(space.degree);
    std::vector<double> values((static_cast<std::size_t>(derivative) + 1) * (p + 1));
    const std::size_t span = find_span(space, x);
    basis_functions(space, span, x, derivative, values);
    double sum = 0;
    for (std::size_t k = 0; k <= p; ++k)
        sum += values[static_cast<std::size_t>(derivative) * (p + 1) + k] * coefficients[span - p + k];
    return sum;
}

std::vector<double> random_between(std::size_t n, unsigned seed, double low = -1, double high = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(low, high);
    std::vector<double> all(n);
    for (double& one : all) one = number(random);
    return all;
}

const std::vector<double> uneven_breaks = {0, 0.1, 0.15, 0.5, 0.8, 1};

/// Every degree with every regularity on unequal cells.
class Knots : public testing::TestWithParam<std::tuple<int, int>> {
  protected:
    const int degree = std::get<0>(GetParam());
    const KnotVector space = open_knots(degree, uneven_breaks, std::min(std::get<1>(GetParam()), degree - 1));
    const std::vector<double> coefficients = random_between(space.size(), 1);
    const std::vector<double> points = random_between(100, 2, 0, 1);
};
INSTANTIATE_TEST_SUITE_P(DegreesAndRegularities, Knots,
                         testing::Combine(testing::Range(1, 8), testing::Values(-1, 0, 1, 3, 6)));

TEST_P(Knots, MatchTheRecursion) {
    for (const double x : points) {
        const std::size_t span = find_span(space, x);
        std::vector<double> values(static_cast<std::size_t>(degree) + 1);
        basis_functions(space, span, x, 0, values);
        double sum = 0;
        for (std::size_t i = 0; i < space.size(); ++i) {
            const std::size_t first = span - static_cast<std::size_t>(degree);
            const double ours = i >= first && i <= span ? values[i - first] : 0;
            EXPECT_NEAR(ours, cox_de_boor(space.knots, i, degree, x), 1e-14);
            sum += ours;
        }
        EXPECT_NEAR(sum, 1, 1e-14);
    }
}

TEST_P(Knots, InterpolateAtBothEndsExactly) {
    EXPECT_EQ(evaluate(space, coefficients, 0), coefficients.front());
    EXPECT_EQ(evaluate(space, coefficients, 1), coefficients.back());
}

TEST_P(Knots, DerivativesMatchFiniteDifferences) {
    constexpr double h = 1e-5;
    for (const double x : points) {
        if (find_span(space, x - h) != find_span(space, x + h)) continue;
        for (int d = 1; d <= 3; ++d) {
            const double difference =
                (evaluate(space, coefficients, x + h, d - 1) - evaluate(space, coefficients, x - h, d - 1)) /
                (2 * h);
            const double scale = std::pow(degree / 0.05, d + 2);
            EXPECT_NEAR(evaluate(space, coefficients, x, d), difference, 1e-9 * scale) << x << ' ' << d;
        }
    }
}

TEST_P(Knots, DerivativesAreSplinesOfOneDegreeLess) {
    if (std::get<1>(GetParam()) < 0) return; // these may be discontinuous
    const KnotVector below = derivative_space(space);
    EXPECT_TRUE(degree == 1 || is_open(below));
    const auto slopes = derivative_coefficients(space, coefficients);
    for (const double x : points)
        EXPECT_NEAR(evaluate(below, slopes, x), evaluate(space, coefficients, x, 1), 1e-11);
}

TEST_P(Knots, StayTheSameSplinesWhenKnotsAreInserted) {
    KnotVector fine = space;
    for (const double knot : {0.05, 0.3, 0.3, 0.31, 0.95}) {
        if (std::count(fine.knots.begin(), fine.knots.end(), knot) > degree) continue;
        fine.knots.insert(std::upper_bound(fine.knots.begin(), fine.knots.end(), knot), knot);
    }
    ASSERT_TRUE(is_open(fine));
    ASSERT_TRUE(refines(fine, space));
    EXPECT_FALSE(refines(space, fine));
    const LineMatrix matrix = insertion(space, fine);
    std::vector<double> inserted(fine.size(), 0.0);
    for (std::size_t i = 0; i < matrix.rows; ++i)
        for (std::size_t j = 0; j < matrix.columns; ++j) inserted[i] += matrix(i, j) * coefficients[j];
    for (const double x : points)
        for (int d = 0; d <= 2; ++d)
            EXPECT_NEAR(evaluate(fine, inserted, x, d), evaluate(space, coefficients, x, d),
                        1e-13 * std::pow(degree / 0.01, d));
}

TEST_P(Knots, ReproduceTheIdentityAndTheSquare) {
    const auto identity = greville(space);
    for (const double x : points) EXPECT_NEAR(evaluate(space, identity, x), x, 1e-14);
    EXPECT_NEAR(evaluate(space, identity, 1.25), 1.25, 1e-12); // polynomials continue beyond the ends
    if (degree < 2) return;
    const auto square = square_coefficients(space);
    for (const double x : points) EXPECT_NEAR(evaluate(space, square, x), x * x, 1e-14);
}

TEST(KnotTransfer, BetweenMeshesThatAreNotNestedIsExactForPolynomials) {
    const KnotVector from = uniform_knots(3, 7), to = uniform_knots(4, 5);
    const LineMatrix matrix = transfer(from, to);
    const auto square = square_coefficients(from), expected = square_coefficients(to);
    for (std::size_t i = 0; i < to.size(); ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < from.size(); ++j) sum += matrix(i, j) * square[j];
        EXPECT_NEAR(sum, expected[i], 1e-13);
    }
}

TEST(KnotVectors, AreRecognisedIfNotOpen) {
    EXPECT_TRUE(is_open({2, {0, 0, 0, 0.5, 0.5, 1, 1, 1}}));
    EXPECT_FALSE(is_open({2, {0, 0, 0.5, 1, 1, 1}}));         // multiplicity too low at the start
    EXPECT_FALSE(is_open({2, {0, 0, 0, 0.5, 0.4, 1, 1, 1}})); // not ascending
    EXPECT_FALSE(is_open({1, {0, 0, 0.5, 0.5, 0.5, 1, 1}}));  // multiplicity too high
    EXPECT_FALSE(is_open({1, {0, 0, 0.5, 2, 2}}));            // not over [0, 1]
    EXPECT_FALSE(is_open({8, std::vector<double>(18, 0.0)}));
}

} // namespace
} // namespace gaspard
