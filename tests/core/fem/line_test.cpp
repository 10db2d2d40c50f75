#include "core/base/error.hpp"
#include "core/fem/gauss.hpp"
#include "core/fem/line_map.hpp"
#include "core/linear/slow_line.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

TEST(Gauss, IsExactUpToItsDegreeOnly) {
    for (const int points : {1, 2, 3, 4, 5, 6, 10, 20}) {
        const LineQuadrature rule = gauss_legendre(points);
        ASSERT_EQ(rule.points.size(), static_cast<std::size_t>(points));
        const auto error = [&](int power) {
            long double sum = 0;
            for (std::size_t q = 0; q < rule.points.size(); ++q)
                sum += rule.weights[q] * std::pow(static_cast<long double>(rule.points[q]), power);
            return static_cast<double>(std::abs(sum - 1.0L / (power + 1)));
        };
        for (int power = 0; power <= 2 * points - 1; ++power)
            EXPECT_LT(error(power), 2e-15) << points << " points, power " << power;
        // The error of the next power is (n!)^4 / ((2n+1) ((2n)!)^2).
        const double miss =
            std::exp(4 * std::lgamma(points + 1) - 2 * std::lgamma(2 * points + 1)) / (2 * points + 1);
        EXPECT_NEAR(error(2 * points), miss, 2e-15);
    }
}

TEST(Gauss, HasInteriorAscendingPointsAndPositiveWeights) {
    const LineQuadrature rule = gauss_legendre(7);
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_GT(rule.weights[i], 0);
        EXPECT_GT(rule.points[i], i == 0 ? 0 : rule.points[i - 1]);
        EXPECT_NEAR(rule.points[i] + rule.points[6 - i], 1, 1e-15);
    }
    EXPECT_LT(rule.points[6], 1);
    EXPECT_THROW(gauss_legendre(0), InternalError);
}

struct Use {
    const char* name;
    int degree;
    Symmetry symmetry;
    LineForm form;
};
// The four maps of PlaneQ2, and other combinations.
const Use uses[] = {
    {"second", 2, Symmetry::even, {true, true}},     {"first", 2, Symmetry::odd, {false, true}},
    {"slope_q1", 1, Symmetry::odd, {false, true}},   {"value_q1", 1, Symmetry::even, {false, false}},
    {"identity", 2, Symmetry::even, {false, false}}, {"slope_even", 2, Symmetry::even, {false, true}},
    {"second_q1", 1, Symmetry::even, {true, true}},  {"slope_weak", 2, Symmetry::odd, {true, false}}};

Eigen::MatrixXd dense_map(slow::Line line, const Use& use) {
    Eigen::MatrixXd mass = slow::mass(line, use.degree);
    Eigen::MatrixXd right =
        slow::line_matrix(line, {use.degree, use.form.derive_test}, {2, use.form.derive_trial});
    if (!line.periodic && use.symmetry == Symmetry::odd) // values and test functions vanish at the ends
        for (const Eigen::Index end : {Eigen::Index{0}, mass.rows() - 1}) {
            mass.row(end).setZero();
            mass(end, end) = 1;
            right.row(end).setZero();
        }
    return slow::solve(mass, right);
}

class Maps : public testing::TestWithParam<std::tuple<int, bool>> {};
INSTANTIATE_TEST_SUITE_P(Lines, Maps, testing::Combine(testing::Values(4, 5, 7, 30), testing::Bool()));

TEST_P(Maps, AgreeWithDenseMatrices) {
    const auto [n, periodic] = GetParam();
    const slow::Line line{n, periodic};
    for (const Use& use : uses) {
        SCOPED_TRACE(use.name);
        const LineMap map({static_cast<std::size_t>(n), periodic}, use.degree, use.symmetry, use.form);
        ASSERT_EQ(static_cast<int>(map.rows()), line.unknowns(use.degree));
        const Eigen::MatrixXd expected = dense_map(line, use);
        // Applied to the identity, which gives the matrix of the map.
        const RowMajor in = RowMajor::Identity(expected.cols(), expected.cols());
        RowMajor out = RowMajor::Constant(expected.rows(), expected.cols(), 7.0);
        const auto columns = static_cast<std::size_t>(expected.cols());
        map.apply(in.data(), columns, out.data(), columns, columns);
        EXPECT_LT(slow::largest(out - expected), 1e-13 * slow::largest(expected));
    }
}

TEST_P(Maps, KeepTheEndsOfOddFunctionsAtZero) {
    const auto [n, periodic] = GetParam();
    if (periodic) return;
    for (const int degree : {1, 2}) {
        const LineMap map({static_cast<std::size_t>(n), false}, degree, Symmetry::odd, {false, true});
        std::vector<double> in(static_cast<std::size_t>(2 * n + 1)), out(map.rows());
        for (std::size_t i = 0; i < in.size(); ++i) in[i] = std::exp(0.1 * static_cast<double>(i));
        map.apply(in.data(), 1, out.data(), 1, 1);
        EXPECT_EQ(out.front(), 0);
        EXPECT_EQ(out.back(), 0);
    }
}

TEST(LineMap, RejectsUnsupportedArguments) {
    EXPECT_THROW(LineMap({3, true}, 2, Symmetry::even, {}), InternalError);
    EXPECT_THROW(LineMap({4, true}, 3, Symmetry::even, {}), InternalError);
}

} // namespace
} // namespace gaspard
