#include "core/base/error.hpp"
#include "core/linear/cell_cholesky.hpp"
#include "core/linear/dense.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <set>

namespace gaspard {
namespace {

/// n x m biquadratic squares, nine unknowns per cell; and the centres of the cells.
struct Squares {
    CellUnknowns unknowns;
    Points middles;
};
Squares squares(std::int32_t n, std::int32_t m) {
    const std::int32_t side = 2 * n + 1;
    Squares result{{static_cast<std::size_t>(side * (2 * m + 1)), 9, {}},
                   Points(static_cast<std::size_t>(n * m))};
    for (std::int32_t j = 0; j < m; ++j)
        for (std::int32_t i = 0; i < n; ++i) {
            for (std::int32_t b = 0; b < 3; ++b)
                for (std::int32_t a = 0; a < 3; ++a)
                    result.unknowns.numbers.push_back((2 * j + b) * side + 2 * i + a);
            result.middles.set(static_cast<std::size_t>(j * n + i), {i + 0.5, j + 0.5, 0});
        }
    return result;
}

/// A positive definite matrix for every cell, different for each.
std::vector<Eigen::MatrixXd> random_matrices(const CellUnknowns& unknowns) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> entry(-1, 1);
    std::vector<Eigen::MatrixXd> matrices;
    const auto n = static_cast<Eigen::Index>(unknowns.per_cell);
    for (std::size_t c = 0; c < unknowns.cells(); ++c) {
        const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return entry(random); });
        matrices.push_back(a * a.transpose() + Eigen::MatrixXd::Identity(n, n));
    }
    return matrices;
}

CellCholesky::CellMatrix giving(const std::vector<Eigen::MatrixXd>& matrices) {
    return [&](std::size_t cell, std::span<double> to) {
        std::copy_n(matrices[cell].data(), to.size(), to.data()); // symmetric
    };
}

Eigen::MatrixXd assembled(const CellUnknowns& unknowns, const std::vector<Eigen::MatrixXd>& matrices) {
    const auto n = static_cast<Eigen::Index>(unknowns.count);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t c = 0; c < unknowns.cells(); ++c)
        for (std::size_t a = 0; a < unknowns.per_cell; ++a)
            for (std::size_t b = 0; b < unknowns.per_cell; ++b)
                sum(unknowns.of(c)[a], unknowns.of(c)[b]) +=
                    matrices[c](static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    return sum;
}

template <int columns>
void expect_solves(const CellCholesky& factor, const Dissection& dissection, const Eigen::MatrixXd& dense) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> entry(-1, 1);
    const Eigen::MatrixXd b =
        Eigen::MatrixXd::NullaryExpr(dense.rows(), columns, [&] { return entry(random); });
    const Eigen::MatrixXd expected = slow::solve(dense, b);
    std::vector<double> rows(factor.size() * columns);
    const auto row = [&](Eigen::Index i) {
        return &rows[static_cast<std::size_t>(dissection.permutation[static_cast<std::size_t>(i)]) * columns];
    };
    for (Eigen::Index i = 0; i < dense.rows(); ++i)
        for (int c = 0; c < columns; ++c) row(i)[c] = b(i, c);
    factor.solve<columns>(rows);
    for (Eigen::Index i = 0; i < dense.rows(); ++i)
        for (int c = 0; c < columns; ++c) ASSERT_NEAR(row(i)[c], expected(i, c), 1e-12);
}

TEST(Dissection, OrdersEveryUnknownOnceAndChildrenBeforeParents) {
    const Squares grid = squares(9, 5);
    const Dissection d = dissect(grid.unknowns, grid.middles);
    std::set<std::int32_t> places(d.permutation.begin(), d.permutation.end());
    std::set<std::int32_t> cells(d.cells.begin(), d.cells.end());
    EXPECT_EQ(places.size(), grid.unknowns.count);
    EXPECT_EQ(*places.begin(), 0);
    EXPECT_EQ(cells.size(), grid.unknowns.cells());
    std::int32_t next = 0;
    for (std::size_t p = 0; p < d.parts.size(); ++p) {
        EXPECT_EQ(d.parts[p].begin, next);
        next = d.parts[p].end;
        for (const auto child : d.parts[p].children) EXPECT_LT(child, static_cast<std::int32_t>(p));
        for (const auto unknown : d.parts[p].border) EXPECT_GE(unknown, d.parts[p].end);
    }
    EXPECT_EQ(static_cast<std::size_t>(next), grid.unknowns.count);
    EXPECT_TRUE(d.parts.back().border.empty());
}

TEST(Dissection, BisectsTheLongSide) {
    const Squares grid = squares(32, 4);
    const Dissection d = dissect(grid.unknowns, grid.middles);
    EXPECT_EQ(d.parts.back().end - d.parts.back().begin, 9); // one line of nodes
}

TEST(CellCholesky, AgreesWithDenseElimination) {
    for (const auto& [n, m] : {std::pair{1, 1}, {2, 1}, {3, 3}, {6, 5}, {8, 8}}) {
        const Squares grid = squares(n, m);
        const auto matrices = random_matrices(grid.unknowns);
        const auto dissection = std::make_shared<const Dissection>(dissect(grid.unknowns, grid.middles));
        const CellCholesky factor(grid.unknowns, dissection, giving(matrices));
        const Eigen::MatrixXd dense = assembled(grid.unknowns, matrices);
        expect_solves<1>(factor, *dissection, dense);
        expect_solves<4>(factor, *dissection, dense);
        expect_solves<12>(factor, *dissection, dense);
    }
}

TEST(CellCholesky, HasLittleFillIn) {
    // A band factorisation has about n^(3/2) entries, nested dissection n log n.
    const Squares grid = squares(32, 32);
    const auto matrices = random_matrices(grid.unknowns);
    const auto dissection = std::make_shared<const Dissection>(dissect(grid.unknowns, grid.middles));
    const CellCholesky factor(grid.unknowns, dissection, giving(matrices));
    EXPECT_LT(factor.entries(), 55 * grid.unknowns.count);
}

TEST(CellCholesky, ReportsProgressAndStops) {
    const Squares grid = squares(8, 8);
    const auto matrices = random_matrices(grid.unknowns);
    const auto dissection = std::make_shared<const Dissection>(dissect(grid.unknowns, grid.middles));
    std::vector<double> told;
    std::stop_source source;
    const CellCholesky::Advance note = [&](double part) { told.push_back(part); };
    const CellCholesky factor(grid.unknowns, dissection, giving(matrices), note, source.get_token());
    EXPECT_GT(told.size(), 10u);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1);
    source.request_stop();
    EXPECT_THROW(CellCholesky(grid.unknowns, dissection, giving(matrices), {}, source.get_token()),
                 Interrupted);
}

TEST(CellCholesky, RejectsIndefiniteMatrices) {
    const Squares grid = squares(2, 2);
    auto matrices = random_matrices(grid.unknowns);
    matrices[1] = -10 * matrices[1];
    const auto dissection = std::make_shared<const Dissection>(dissect(grid.unknowns, grid.middles));
    EXPECT_THROW(CellCholesky(grid.unknowns, dissection, giving(matrices)), InternalError);
}

} // namespace
} // namespace gaspard
