#include "core/base/error.hpp"
#include "core/linear/line_spectrum.hpp"
#include "core/linear/slow_line.hpp"
#include "core/linear/tensor_poisson.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd, slow::largest;

class Spectrum : public testing::TestWithParam<std::tuple<int, bool>> {
  protected:
    int n() const { return std::get<0>(GetParam()); }
    bool periodic() const { return std::get<1>(GetParam()); }
    slow::Line line() const { return {n(), periodic()}; }
    LineSpectrum spectrum() const { return {static_cast<std::size_t>(n()), periodic()}; }
};

INSTANTIATE_TEST_SUITE_P(Lines, Spectrum,
                         testing::Combine(testing::Values(2, 3, 4, 5, 7, 8, 11, 30), testing::Bool()),
                         [](const auto& run) {
                             return std::to_string(std::get<0>(run.param)) +
                                    (std::get<1>(run.param) ? "periodic" : "walls");
                         });

constexpr auto lanes = static_cast<Eigen::Index>(LineSpectrum::lanes);
using Batch = Eigen::Matrix<double, Eigen::Dynamic, lanes, Eigen::RowMajor>; ///< eight interleaved lines

// The matrix of a linear map that is applied to eight vectors at a time.
template <class Apply>
MatrixXd matrix_of(std::size_t size, const Apply& apply) {
    const auto n = static_cast<Eigen::Index>(size);
    MatrixXd matrix(n, n);
    for (Eigen::Index i = 0; i < n; i += lanes) {
        const Eigen::Index count = std::min(lanes, n - i);
        Batch unit = Batch::Zero(n, lanes), result = Batch::Constant(n, lanes, 7.0);
        for (Eigen::Index l = 0; l < count; ++l) unit(i + l, l) = 1;
        apply(unit.data(), result.data());
        matrix.middleCols(i, count) = result.leftCols(count);
    }
    return matrix;
}

TEST_P(Spectrum, DiagonalisesMassAndStiffness) {
    const LineSpectrum s = spectrum();
    ASSERT_EQ(static_cast<int>(s.size()), line().unknowns(2));
    auto workspace = s.make_workspace();
    const MatrixXd vectors = matrix_of(
        s.size(), [&](const double* c, double* u) { s.synthesise(c, u, LineSpectrum::lanes, workspace); });
    const VectorXd lambda = VectorXd::Map(s.eigenvalues().data(), vectors.cols());
    const MatrixXd m = slow::mass(line(), 2), k = slow::stiffness(line(), 2);
    const MatrixXd one = MatrixXd::Identity(vectors.cols(), vectors.cols());
    EXPECT_LT(largest(vectors.transpose() * m * vectors - one), 1e-13);
    EXPECT_LT(largest(vectors.transpose() * k * vectors - MatrixXd(lambda.asDiagonal())),
              1e-13 * largest(lambda));
    EXPECT_LT(largest(k * vectors - m * vectors * lambda.asDiagonal()), 1e-13 * largest(k * vectors));
}

TEST_P(Spectrum, AnalysisIsTheTransposeOfSynthesis) {
    const LineSpectrum s = spectrum();
    auto workspace = s.make_workspace();
    const MatrixXd vectors = matrix_of(
        s.size(), [&](const double* c, double* u) { s.synthesise(c, u, LineSpectrum::lanes, workspace); });
    const MatrixXd transposed = matrix_of(
        s.size(), [&](const double* b, double* c) { s.analyse(b, LineSpectrum::lanes, c, workspace); });
    EXPECT_LT(largest(transposed - vectors.transpose()), 1e-13 * largest(vectors));
    const MatrixXd inverse =
        slow::solve(slow::mass(line(), 2), MatrixXd::Identity(vectors.cols(), vectors.cols()));
    EXPECT_LT(largest(vectors * transposed - inverse), 1e-13 * largest(inverse));
}

TEST_P(Spectrum, MatchesTheEigenvaluesOfTheDensePencil) {
    const LineSpectrum s = spectrum();
    std::vector<double> lambda = s.eigenvalues();
    EXPECT_EQ(lambda[0], 0.0);
    std::sort(lambda.begin(), lambda.end());
    const VectorXd dense = slow::eigenvalues(slow::stiffness(line(), 2), slow::mass(line(), 2));
    for (std::size_t i = 0; i < lambda.size(); ++i)
        EXPECT_NEAR(lambda[i], dense[static_cast<Eigen::Index>(i)], 1e-12 * lambda.back()) << i;
}

TEST_P(Spectrum, PutsTheConstantFirst) {
    const LineSpectrum s = spectrum();
    auto workspace = s.make_workspace();
    Batch c = Batch::Zero(static_cast<Eigen::Index>(s.size()), lanes), u = c;
    c.row(0).setOnes();
    s.synthesise(c.data(), u.data(), LineSpectrum::lanes, workspace);
    EXPECT_LT(largest(u.cwiseAbs() - Batch::Ones(u.rows(), lanes)), 1e-14); // unit mass on [0,1]
    EXPECT_LT(largest(u - Batch::Constant(u.rows(), lanes, u(0, 0))), 1e-14);
}

TEST_P(Spectrum, WorksInPlaceAndInAWiderArray) {
    const LineSpectrum s = spectrum();
    auto workspace = s.make_workspace();
    const Batch start = Batch::Random(static_cast<Eigen::Index>(s.size()), lanes);
    Batch apart(start.rows(), lanes), same = start;
    s.analyse(start.data(), LineSpectrum::lanes, apart.data(), workspace);
    s.analyse(same.data(), LineSpectrum::lanes, same.data(), workspace);
    EXPECT_EQ(same, apart);
    using Wide = Eigen::Matrix<double, Eigen::Dynamic, lanes + 3, Eigen::RowMajor>;
    Wide wide = Wide::Constant(start.rows(), lanes + 3, 5.0);
    wide.middleCols(2, lanes) = start;
    s.analyse(wide.data() + 2, lanes + 3, apart.data(), workspace);
    EXPECT_EQ(same, apart);
    s.synthesise(apart.data(), apart.data(), LineSpectrum::lanes, workspace);
    s.synthesise(same.data(), wide.data() + 2, lanes + 3, workspace);
    EXPECT_EQ(apart, Batch(wide.middleCols(2, lanes)));
    EXPECT_TRUE((wide.leftCols(2).array() == 5).all() && (wide.rightCols(1).array() == 5).all());
}

TEST(LineSpectrum, InvertsTheMassMatrixOfTheLongestLines) {
    for (const bool periodic : {true, false})
        for (const int n : {479, 480}) { // a prime, and a product of small factors
            const LineSpectrum s(static_cast<std::size_t>(n), periodic);
            auto workspace = s.make_workspace();
            srand(6);
            const Batch u = Batch::Random(static_cast<Eigen::Index>(s.size()), lanes);
            Batch b = slow::mass({n, periodic}, 2) * u;
            s.analyse(b.data(), LineSpectrum::lanes, b.data(), workspace);
            s.synthesise(b.data(), b.data(), LineSpectrum::lanes, workspace);
            EXPECT_LT(largest(b - u), 1e-12) << n;
        }
}

TEST(LineSpectrum, RejectsASingleCell) { EXPECT_THROW(LineSpectrum(1, true), InternalError); }

// (K x M + M x K) with a Lagrange multiplier for the mean of u, which absorbs the
// mean of b.
VectorXd solve_sparse(slow::Line line, const VectorXd& b) {
    const MatrixXd m = slow::mass(line, 2), k = slow::stiffness(line, 2);
    const Eigen::Index n = m.rows(), all = n * n;
    const VectorXd weights = m * VectorXd::Ones(n);
    MatrixXd matrix = MatrixXd::Zero(all + 1, all + 1);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index l = 0; l < n; ++l)
                for (Eigen::Index o = 0; o < n; ++o)
                    matrix(j * n + i, l * n + o) = k(j, l) * m(i, o) + m(j, l) * k(i, o);
            matrix(j * n + i, all) = matrix(all, j * n + i) = weights[j] * weights[i];
        }
    VectorXd right(all + 1);
    right << b, 0;
    return slow::solve_sparse(matrix, right).topRows(all);
}

class Poisson : public Spectrum {};
INSTANTIATE_TEST_SUITE_P(Squares, Poisson, testing::Combine(testing::Values(4, 5, 7, 8), testing::Bool()));

TEST_P(Poisson, AgreesWithSparseEliminationForAnyMean) {
    const TensorPoisson poisson(spectrum());
    auto workspace = poisson.make_workspace();
    Team alone;
    const Eigen::Index all = line().unknowns(2) * line().unknowns(2);
    srand(5);
    for (const double mean : {0.0, 3.0}) {
        VectorXd b = VectorXd::Random(all);
        b.array() += mean - b.mean();
        VectorXd u = VectorXd::Constant(all, 9.0);
        poisson.solve(b.data(), u.data(), workspace, alone);
        const VectorXd expected = solve_sparse(line(), b);
        EXPECT_LT(largest(u - expected), 1e-12 * largest(expected)) << "mean of b " << mean;
    }
}

TEST_P(Poisson, SolvesInPlace) {
    const TensorPoisson poisson(spectrum());
    auto workspace = poisson.make_workspace();
    Team alone;
    VectorXd b = VectorXd::Random(line().unknowns(2) * line().unknowns(2)), u(b.size());
    poisson.solve(b.data(), u.data(), workspace, alone);
    poisson.solve(b.data(), b.data(), workspace, alone);
    EXPECT_EQ(b, u);
}

TEST_P(Poisson, DoesNotDependOnTheNumberOfThreads) {
    const TensorPoisson poisson(spectrum());
    const VectorXd b = VectorXd::Random(line().unknowns(2) * line().unknowns(2));
    VectorXd first(b.size()), u(b.size());
    for (const std::size_t workers : {1, 2, 3, 7}) {
        auto workspace = poisson.make_workspace(workers);
        Team team(workers);
        poisson.solve(b.data(), u.data(), workspace, team);
        if (workers == 1) first = u;
        EXPECT_EQ(u, first) << workers;
    }
}

// (K + lambda M) u = b for lambdas over many decades, on both sides of the sign change of the recurrence.
TEST(ModalLines, AgreeWithDenseElimination) {
    std::vector<double> lambdas;
    for (double lambda = 3; lambda < 1e7; lambda *= 1.2) lambdas.push_back(lambda);
    const auto columns = static_cast<Eigen::Index>(lambdas.size());
    ASSERT_GT(columns, 64); // more columns than are processed together
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    for (const bool periodic : {true, false})
        for (const int n : {2, 3, 4, 9, 60}) {
            const slow::Line line{n, periodic};
            if (periodic && n == 2) continue; // both neighbours of a vertex coincide
            const ModalLines lines(static_cast<std::size_t>(n), periodic, lambdas);
            const RowMajor b = RowMajor::Random(line.unknowns(2), columns + 2);
            RowMajor u = b;
            auto workspace = ModalLines::make_workspace();
            lines.solve(u.data(), static_cast<std::size_t>(columns + 2), 0, 20, workspace);
            lines.solve(u.data(), static_cast<std::size_t>(columns + 2), 20, lambdas.size(), workspace);
            EXPECT_EQ(u.rightCols(2), b.rightCols(2));
            for (Eigen::Index c = 0; c < columns; ++c) {
                const MatrixXd matrix =
                    slow::stiffness(line, 2) + lambdas[static_cast<std::size_t>(c)] * slow::mass(line, 2);
                const VectorXd expected = slow::solve(matrix, b.col(c));
                EXPECT_LT(largest(u.col(c) - expected), 1e-10 * largest(expected)) << n << ", column " << c;
            }
        }
}

} // namespace
} // namespace gaspard
