#include "core/base/error.hpp"
#include "core/fem/ellipticity.hpp"
#include "support/polynomials.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(Ellipticity, MatchesTheEigenvaluesAtTheVertices) {
    for (const bool periodic : {true, false})
        for (const std::size_t n : {4, 9, 16}) {
            const LineGrid grid{n, periodic};
            const std::size_t size = grid.size(2), v = grid.vertices();
            const auto monitor = slow::random_values((n + 1) * (n + 1), 0.5, 4, 1);
            WeakHessian sigma{slow::random_values(size * size, -0.5, 2, 2),
                              slow::random_values(size * size, -0.5, 2, 3),
                              slow::random_values(size * size, -0.7, 0.7, 4)};
            double convexity = 1e9, slowest = 1e9, fastest = -1e9;
            for (std::size_t j = 0; j < v; ++j)
                for (std::size_t i = 0; i < v; ++i) {
                    const std::size_t k = 2 * j * size + 2 * i;
                    Eigen::Matrix2d hessian;
                    hessian << 1 + sigma.xx[k], sigma.xy[k], sigma.xy[k], 1 + sigma.yy[k];
                    const Eigen::Vector2d lambda =
                        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(hessian).eigenvalues();
                    const double m = monitor[j * (n + 1) + i];
                    convexity = std::min(convexity, lambda[0]);
                    slowest = std::min(slowest, m * lambda[0]);
                    fastest = std::max(fastest, m * lambda[1]);
                }
            const Ellipticity e = ellipticity(grid, monitor, sigma);
            EXPECT_NEAR(e.convexity, convexity, 1e-14);
            EXPECT_NEAR(e.slowest, slowest, 1e-14);
            EXPECT_NEAR(e.fastest, fastest, 1e-13);
        }
}

TEST(Ellipticity, ChecksItsArrays) {
    EXPECT_THROW(ellipticity({4, true}, std::vector<double>(24), {}), InternalError);
}

} // namespace
} // namespace gaspard
