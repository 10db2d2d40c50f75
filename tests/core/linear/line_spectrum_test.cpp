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

// The matrix of what a member function does to a vector.
template <class Apply>
MatrixXd matrix_of(std::size_t size, const Apply& apply) {
    const auto n = static_cast<Eigen::Index>(size);
    MatrixXd matrix(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const VectorXd unit = VectorXd::Unit(n, i);
        VectorXd result = VectorXd::Constant(n, 7.0);
        apply(unit.data(), result.data());
        matrix.col(i) = result;
    }
    return matrix;
}

TEST_P(Spectrum, DiagonalisesMassAndStiffness) {
    const LineSpectrum s = spectrum();
    ASSERT_EQ(static_cast<int>(s.size()), line().unknowns(2));
    auto room = s.make_room();
    const MatrixXd vectors =
        matrix_of(s.size(), [&](const double* c, double* u) { s.synthesise(c, u, room); });
    const VectorXd lambda = VectorXd::Map(s.eigenvalues().data(), vectors.cols());
    const MatrixXd m = slow::mass(line(), 2), k = slow::stiffness(line(), 2);
    const MatrixXd one = MatrixXd::Identity(vectors.cols(), vectors.cols());
    EXPECT_LT(largest(vectors.transpose() * m * vectors - one), 1e-13);
    EXPECT_LT(largest(vectors.transpose() * k * vectors - MatrixXd(lambda.asDiagonal())),
              1e-13 * largest(lambda));
    EXPECT_LT(largest(k * vectors - m * vectors * lambda.asDiagonal()), 1e-13 * largest(k * vectors));
}

TEST_P(Spectrum, AnalysesByTheTransposeOfWhatItSynthesises) {
    const LineSpectrum s = spectrum();
    auto room = s.make_room();
    const MatrixXd vectors =
        matrix_of(s.size(), [&](const double* c, double* u) { s.synthesise(c, u, room); });
    const MatrixXd transposed =
        matrix_of(s.size(), [&](const double* b, double* c) { s.analyse(b, c, room); });
    EXPECT_LT(largest(transposed - vectors.transpose()), 1e-13 * largest(vectors));
    const MatrixXd inverse = slow::mass(line(), 2).inverse();
    EXPECT_LT(largest(vectors * transposed - inverse), 1e-13 * largest(inverse));
}

TEST_P(Spectrum, HasTheEigenvaluesOfTheDensePencil) {
    const LineSpectrum s = spectrum();
    std::vector<double> lambda = s.eigenvalues();
    EXPECT_EQ(lambda[0], 0.0);
    std::sort(lambda.begin(), lambda.end());
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> dense(slow::stiffness(line(), 2),
                                                                   slow::mass(line(), 2));
    for (std::size_t i = 0; i < lambda.size(); ++i)
        EXPECT_NEAR(lambda[i], dense.eigenvalues()[static_cast<Eigen::Index>(i)], 1e-12 * lambda.back()) << i;
}

TEST_P(Spectrum, PutsTheConstantFirst) {
    const LineSpectrum s = spectrum();
    auto room = s.make_room();
    std::vector<double> c(s.size(), 0.0), u(s.size());
    c[0] = 1;
    s.synthesise(c.data(), u.data(), room);
    for (const double value : u) EXPECT_NEAR(std::abs(value), 1, 1e-14); // unit mass on [0,1]
    for (const double value : u) EXPECT_NEAR(value, u[0], 1e-14);
}

TEST_P(Spectrum, WorksInPlace) {
    const LineSpectrum s = spectrum();
    auto room = s.make_room();
    const VectorXd start = VectorXd::Random(static_cast<Eigen::Index>(s.size()));
    VectorXd apart(start.size()), same = start;
    s.analyse(start.data(), apart.data(), room);
    s.analyse(same.data(), same.data(), room);
    EXPECT_EQ(same, apart);
    s.synthesise(apart.data(), apart.data(), room);
    VectorXd back(start.size());
    s.synthesise(same.data(), back.data(), room);
    EXPECT_EQ(apart, back);
}

TEST(LineSpectrum, InvertsTheMassOfTheLongestLinesToo) {
    for (const bool periodic : {true, false})
        for (const int n : {479, 480}) { // a prime, and many small factors
            const LineSpectrum s(static_cast<std::size_t>(n), periodic);
            auto room = s.make_room();
            srand(6);
            const VectorXd u = VectorXd::Random(static_cast<Eigen::Index>(s.size()));
            VectorXd b = slow::mass({n, periodic}, 2) * u;
            s.analyse(b.data(), b.data(), room);
            s.synthesise(b.data(), b.data(), room);
            EXPECT_LT(largest(b - u), 1e-12) << n;
        }
}

TEST(LineSpectrum, RefusesASingleCell) { EXPECT_THROW(LineSpectrum(1, true), InternalError); }

// (K x M + M x K) with a Lagrange multiplier for the mean of u: what is left of b is what the multiplier
// takes.
VectorXd solve_sparse(slow::Line line, const VectorXd& b) {
    const MatrixXd m = slow::mass(line, 2), k = slow::stiffness(line, 2);
    const Eigen::Index n = m.rows(), all = n * n;
    std::vector<Eigen::Triplet<double>> entries;
    VectorXd ones = VectorXd::Ones(n), weights = m * ones;
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index l = 0; l < n; ++l)
                for (Eigen::Index o = 0; o < n; ++o) {
                    const double entry = k(j, l) * m(i, o) + m(j, l) * k(i, o);
                    if (entry != 0) entries.emplace_back(j * n + i, l * n + o, entry);
                }
            entries.emplace_back(j * n + i, all, weights[j] * weights[i]);
            entries.emplace_back(all, j * n + i, weights[j] * weights[i]);
        }
    Eigen::SparseMatrix<double> matrix(all + 1, all + 1);
    matrix.setFromTriplets(entries.begin(), entries.end());
    VectorXd right(all + 1);
    right << b, 0;
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
    return lu.solve(right).head(all);
}

class Poisson : public Spectrum {};
INSTANTIATE_TEST_SUITE_P(Squares, Poisson, testing::Combine(testing::Values(4, 5, 7, 8), testing::Bool()));

TEST_P(Poisson, AgreesWithSparseEliminationForAnyMean) {
    const TensorPoisson poisson(spectrum());
    auto room = poisson.make_room();
    const Eigen::Index all = line().unknowns(2) * line().unknowns(2);
    srand(5);
    for (const double mean : {0.0, 3.0}) {
        VectorXd b = VectorXd::Random(all);
        b.array() += mean - b.mean();
        VectorXd u = VectorXd::Constant(all, 9.0);
        poisson.solve(b.data(), u.data(), room);
        const VectorXd expected = solve_sparse(line(), b);
        EXPECT_LT(largest(u - expected), 1e-12 * largest(expected)) << "mean of b " << mean;
    }
}

TEST_P(Poisson, SolvesInPlace) {
    const TensorPoisson poisson(spectrum());
    auto room = poisson.make_room();
    VectorXd b = VectorXd::Random(line().unknowns(2) * line().unknowns(2)), u(b.size());
    poisson.solve(b.data(), u.data(), room);
    poisson.solve(b.data(), b.data(), room);
    EXPECT_EQ(b, u);
}

} // namespace
} // namespace gaspard
