#include "core/base/error.hpp"
#include "core/linear/slow_line.hpp"
#include "core/linear/transpose.hpp"
#include "core/linear/tridiagonal.hpp"

#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

struct System {
    std::vector<double> diagonal, off;
    Eigen::MatrixXd matrix;
};

// Random and diagonally dominant, hence positive definite.
System random_system(int n, bool closed, std::mt19937& random) {
    std::uniform_real_distribution<double> coupling(-1, 1), excess(2.1, 4);
    System s{{}, {}, Eigen::MatrixXd::Zero(n, n)};
    for (int i = 0; i < n; ++i) s.diagonal.push_back(s.matrix(i, i) = excess(random));
    for (int i = 0; i < (closed ? n : n - 1); ++i) {
        s.off.push_back(coupling(random));
        s.matrix(i, (i + 1) % n) = s.matrix((i + 1) % n, i) = s.off.back();
    }
    return s;
}

// Several columns, with gaps between rows that must not be touched.
void expect_solves(int n, bool closed, int columns, int stride, std::mt19937& random) {
    SCOPED_TRACE(testing::Message() << "n " << n << (closed ? " closed" : " open") << " columns " << columns);
    const System s = random_system(n, closed, random);
    const TridiagonalSolver solver(s.diagonal, s.off, closed);
    EXPECT_EQ(solver.size(), static_cast<std::size_t>(n));
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    srand(static_cast<unsigned>(n));
    RowMajor b = RowMajor::Random(n, stride);
    const RowMajor before = b;
    solver.solve(b.data(), static_cast<std::size_t>(columns), static_cast<std::size_t>(stride));
    const Eigen::MatrixXd expected = slow::solve(s.matrix, before.leftCols(columns));
    EXPECT_LT(slow::largest(b.leftCols(columns) - expected), 1e-13);
    EXPECT_EQ(b.rightCols(stride - columns), before.rightCols(stride - columns));
}

TEST(TridiagonalSolver, SolvesOpenSystemsLikeADenseSolver) {
    std::mt19937 random(1);
    for (const int n : {1, 2, 3, 4, 5, 17, 60}) expect_solves(n, false, 3, 5, random);
}

TEST(TridiagonalSolver, SolvesCyclicSystemsLikeADenseSolver) {
    std::mt19937 random(2);
    for (const int n : {3, 4, 5, 17, 60}) expect_solves(n, true, 3, 5, random);
}

TEST(TridiagonalSolver, RejectsInconsistentSizes) {
    EXPECT_THROW(TridiagonalSolver({1, 1}, {0, 0}, true), InternalError); // cyclic with n = 2
    EXPECT_THROW(TridiagonalSolver({1, 1, 1}, {0, 0, 0}, false),
                 InternalError); // one off-diagonal entry too many
    EXPECT_THROW(TridiagonalSolver({}, {}, false), InternalError);
    EXPECT_THROW(TridiagonalSolver({1, 1, 1}, {2, 0}, false), InternalError); // indefinite
}

TEST(TridiagonalSolver, RejectsIndefiniteCyclicMatrices) {
    // 2 on the diagonal and -1 off it: singular if cyclic, definite if open.
    EXPECT_THROW(TridiagonalSolver({2, 2, 2, 1.5}, {-1, -1, -1, -1}, true), InternalError);
    EXPECT_NO_THROW(TridiagonalSolver({2, 2, 2, 2.5}, {-1, -1, -1, -1}, true));
}

TEST(Transpose, SwapsRowsAndColumns) {
    for (const auto& [rows, columns] :
         {std::pair<std::size_t, std::size_t>{1, 1}, {1, 7}, {16, 16}, {17, 33}}) {
        std::vector<double> in(rows * columns), out(rows * columns, -1);
        for (std::size_t i = 0; i < in.size(); ++i) in[i] = static_cast<double>(i);
        transpose(in.data(), columns, out.data(), rows, rows, columns);
        for (std::size_t r = 0; r < rows; ++r)
            for (std::size_t c = 0; c < columns; ++c)
                ASSERT_EQ(out[c * rows + r], in[r * columns + c]) << rows << " x " << columns;
    }
}

} // namespace
} // namespace gaspard
