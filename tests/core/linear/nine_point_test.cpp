// Nine-point systems of any size beside a dense solution, also where grids cannot be halved.
#include "core/linear/nine_point.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

/// Bilinear elements with a coefficient per quadrilateral, a thousand times stronger along x.
std::vector<CornerMatrix> random_matrices(int n) {
    std::mt19937 random(7);
    std::vector<CornerMatrix> matrices;
    for (int q = 0; q < n * n; ++q) {
        const double k = std::exp(std::uniform_real_distribution<>(-5, 5)(random)), x = k * 1e3 / 6,
                     y = k / 6;
        matrices.push_back({2 * x + 2 * y, -2 * x + y, 2 * x + 2 * y, x - 2 * y, -x - y, 2 * x + 2 * y,
                            -x - y, x - 2 * y, -2 * x + y, 2 * x + 2 * y});
    }
    return matrices;
}

TEST(NinePointSolver, SolvesOnGridsOfAnySize) {
    for (const int n : {1, 2, 3, 7, 12, 13, 20}) {
        std::vector<std::uint8_t> fixed;
        std::vector<double> u;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                fixed.push_back(i == 0 || i == n ? 1 : 0);
                u.push_back(i == n ? 1 + 0.1 * j : 0);
            }
        const auto matrices = random_matrices(n);
        const auto size = static_cast<Eigen::Index>(u.size());
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const int p = j * (n + 1) + i, corner[4] = {p, p + 1, p + n + 1, p + n + 2};
                std::size_t at = 0;
                for (int k = 0; k < 4; ++k)
                    for (int l = 0; l <= k; ++l, ++at) {
                        const double value = matrices[static_cast<std::size_t>(j * n + i)][at];
                        a(corner[k], corner[l]) += value;
                        if (k != l) a(corner[l], corner[k]) += value;
                    }
            }
        Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
        for (Eigen::Index p = 0; p < size; ++p)
            if (fixed[static_cast<std::size_t>(p)] != 0)
                a.row(p).setZero(), a(p, p) = 1, b(p) = u[static_cast<std::size_t>(p)];
        const Eigen::VectorXd expected = a.partialPivLu().solve(b);
        NinePointSolver solver(n);
        std::copy(matrices.begin(), matrices.end(), solver.matrices().begin());
        solver.factorise(fixed);
        EXPECT_LT(solver.solve(u, 1e-12), 40) << n;
        for (Eigen::Index p = 0; p < size; ++p)
            EXPECT_NEAR(u[static_cast<std::size_t>(p)], expected(p), 1e-9) << n << ' ' << p;
    }
}

} // namespace
} // namespace gaspard
