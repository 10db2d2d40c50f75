#include "core/linear/dense.hpp"
#include "core/linear/gmres.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using In = std::span<const double>;
using Out = std::span<double>;

Eigen::Map<const VectorXd> view(In v) { return {v.data(), static_cast<Eigen::Index>(v.size())}; }
Eigen::Map<VectorXd> view(Out v) { return {v.data(), static_cast<Eigen::Index>(v.size())}; }
In span_of(const VectorXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

struct Problem {
    explicit Problem(Eigen::Index n) : a(MatrixXd::Random(n, n)), p(MatrixXd::Random(n, n)), b(n), x(n) {
        a += 0.7 * std::sqrt(static_cast<double>(n)) * MatrixXd::Identity(n, n); // far from symmetric
        p = 0.1 * p + MatrixXd::Identity(n, n);
        b.setRandom();
        x.setRandom(); // overwritten: not an initial guess
    }
    Gmres::Result solve(std::size_t memory, Gmres::Limits limits, std::stop_token stop = {}) {
        Gmres gmres(static_cast<std::size_t>(b.size()), memory);
        return gmres.solve([&](In v, Out out) { view(out) = a * view(v), ++applied; },
                           [&](In v, Out out) { view(out) = p * view(v); }, span_of(b),
                           {x.data(), static_cast<std::size_t>(x.size())}, limits, stop);
    }
    double residual() const { return (b - a * x).norm() / b.norm(); }

    MatrixXd a, p;
    VectorXd b, x;
    int applied = 0;
};

TEST(Gmres, AgreesWithDenseSolvers) {
    srand(1);
    Problem problem(40);
    const auto result = problem.solve(40, {.tolerance = 1e-12, .iterations = 100});
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.iterations, 40);
    const VectorXd expected = slow::solve(problem.a, problem.b);
    EXPECT_LT((problem.x - expected).norm(), 1e-10 * expected.norm());
    EXPECT_NEAR(result.residual, problem.residual(), 1e-13);
}

TEST(Gmres, MinimisesTheResidualOverTheKrylovSpace) {
    srand(2);
    for (const int k : {1, 3, 7}) {
        Problem problem(20);
        const auto result = problem.solve(20, {.tolerance = 0, .iterations = k});
        EXPECT_EQ(result.iterations, k);
        EXPECT_EQ(problem.applied, k);
        MatrixXd images(20, k); // A P^-1 applied to b once, twice, ...
        VectorXd v = problem.b;
        for (int c = 0; c < k; ++c) v = images.col(c) = (problem.a * problem.p * v).normalized();
        const VectorXd best = slow::least_squares(images, problem.b);
        const double expected = (problem.b - images * best).norm() / problem.b.norm();
        EXPECT_NEAR(problem.residual(), expected, 1e-10);
        EXPECT_NEAR(result.residual, expected, 1e-10);
    }
}

TEST(Gmres, RestartsWhenItsMemoryIsFull) {
    srand(3);
    Problem problem(60);
    problem.a += 10 * MatrixXd::Identity(60, 60);
    const auto result = problem.solve(5, {.tolerance = 1e-10, .iterations = 500});
    EXPECT_TRUE(result.converged);
    EXPECT_GT(result.iterations, 5);
    EXPECT_LT(problem.residual(), 2e-10);
}

TEST(Gmres, ReportsWhenItDoesNotConverge) {
    srand(4);
    Problem problem(30);
    const auto few = problem.solve(30, {.tolerance = 1e-12, .iterations = 4});
    EXPECT_FALSE(few.converged);
    EXPECT_EQ(few.iterations, 4);
    problem.a.setZero();
    const auto singular = problem.solve(30, {});
    EXPECT_FALSE(singular.converged);
    EXPECT_TRUE(problem.x.allFinite());
    problem.a(3, 3) = std::numeric_limits<double>::quiet_NaN();
    const auto poisoned = problem.solve(30, {});
    EXPECT_FALSE(poisoned.converged);
    EXPECT_EQ(poisoned.iterations, 1);
}

TEST(Gmres, SolvesAConsistentSingularSystem) {
    srand(5);
    Problem problem(30);
    const MatrixXd out = MatrixXd::Identity(30, 30) - MatrixXd::Constant(30, 30, 1.0 / 30);
    problem.a = out * problem.a * out; // its kernel contains the constants
    problem.b = out * problem.b;
    EXPECT_TRUE(problem.solve(30, {.tolerance = 1e-10, .iterations = 60}).converged);
    EXPECT_LT(problem.residual(), 2e-10);
}

TEST(Gmres, TakesNoIterationForZero) {
    Problem problem(5);
    problem.b.setZero();
    EXPECT_TRUE(problem.solve(5, {}).converged);
    EXPECT_EQ(problem.applied, 0);
    EXPECT_EQ(problem.x.norm(), 0);
}

TEST(Gmres, StopsOnRequest) {
    srand(6);
    Problem problem(30);
    std::stop_source source;
    source.request_stop();
    EXPECT_FALSE(problem.solve(30, {}, source.get_token()).converged);
    EXPECT_EQ(problem.applied, 0);
}

} // namespace
} // namespace gaspard
