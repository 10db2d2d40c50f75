// Systems of cell matrices that are not symmetric, by elimination of parts.
#include "core/base/error.hpp"
#include "core/linear/cell_lu.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

/// n x m squares with an unknown at each node, and their matrices.
struct LuSquares {
    CellUnknowns unknowns;
    Points middles;
    std::vector<double> matrices;

    LuSquares(std::int32_t n, std::int32_t m)
        : unknowns{static_cast<std::size_t>((n + 1) * (m + 1)), 4, {}},
          middles(static_cast<std::size_t>(n * m)) {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> entry(-1, 1);
        for (std::int32_t j = 0; j < m; ++j)
            for (std::int32_t i = 0; i < n; ++i) {
                const std::int32_t at = j * (n + 1) + i;
                unknowns.numbers.insert(unknowns.numbers.end(), {at, at + 1, at + n + 1, at + n + 2});
                middles.set(static_cast<std::size_t>(j * n + i), {i + 0.5, j + 0.5, 0});
                for (int k = 0; k < 16; ++k) matrices.push_back(entry(random) + (k % 5 == 0 ? 3 : 0));
            }
    }
    CellMatrixOf matrix() const {
        return [this](std::size_t cell, std::span<double> to) {
            for (std::size_t k = 0; k < 16; ++k) to[k] = matrices[16 * cell + k];
        };
    }
    std::vector<double> times(const std::vector<double>& u) const {
        std::vector<double> product(u.size());
        for (std::size_t c = 0; c < unknowns.cells(); ++c)
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t b = 0; b < 4; ++b)
                    product[static_cast<std::size_t>(unknowns.of(c)[a])] +=
                        matrices[16 * c + 4 * a + b] * u[static_cast<std::size_t>(unknowns.of(c)[b])];
        return product;
    }
};

TEST(CellLu, SolvesWhatTheCellsAddUpTo) {
    for (const auto& [n, m] : {std::pair{1, 1}, {1, 9}, {4, 3}, {17, 12}}) {
        const LuSquares grid(n, m);
        std::vector<double> expected;
        for (std::size_t i = 0; i < grid.unknowns.count; ++i)
            expected.push_back(std::sin(static_cast<double>(i)));
        const auto u = solve_by_parts(grid.unknowns, dissect(grid.unknowns, grid.middles), grid.matrix(),
                                      grid.times(expected));
        for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(u[i], expected[i], 1e-12) << n << ' ' << m;
    }
}

TEST(CellLu, ExchangesRowsOfAPart) {
    LuSquares one(1, 1);
    one.matrices = {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 2, 0, 0, 2, 0};
    const std::vector<double> b{1, 2, 6, 8};
    EXPECT_EQ(solve_by_parts(one.unknowns, dissect(one.unknowns, one.middles), one.matrix(), b),
              (std::vector<double>{2, 1, 4, 3}));
}

TEST(CellLu, ASingularMatrixHasNoFiniteSolution) {
    LuSquares one(1, 1);
    one.matrices.assign(16, 0.0);
    const std::vector<double> b(4, 1.0);
    for (const double u : solve_by_parts(one.unknowns, dissect(one.unknowns, one.middles), one.matrix(), b))
        EXPECT_FALSE(std::isfinite(u));
}

TEST(CellLu, IsStoppedBetweenParts) {
    const LuSquares grid(16, 16);
    std::stop_source source;
    std::size_t asked = 0;
    const CellMatrixOf matrix = [&](std::size_t cell, std::span<double> to) {
        grid.matrix()(cell, to);
        if (++asked == 20) source.request_stop();
    };
    const std::vector<double> b(grid.unknowns.count, 1.0);
    EXPECT_THROW(
        solve_by_parts(grid.unknowns, dissect(grid.unknowns, grid.middles), matrix, b, source.get_token()),
        Interrupted);
    EXPECT_LT(asked, 25U) << "at the end of the part";
}

} // namespace
} // namespace gaspard
