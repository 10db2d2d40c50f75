#include "core/linear/dense.hpp"
#include "core/method/anderson.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

std::span<const double> view(const VectorXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

MatrixXd random_definite(Eigen::Index n) {
    const MatrixXd a = MatrixXd::Random(n, n);
    return a * a.transpose() + 0.1 * MatrixXd::Identity(n, n);
}

// Any sequence of iterates: the proposal is that of a dense least-squares problem in the norm u . P u = u .
// r.
TEST(Anderson, ProposesWhatLeastSquaresDo) {
    srand(3);
    const Eigen::Index n = 30;
    const std::size_t memory = 4;
    const MatrixXd product = random_definite(n);
    const MatrixXd root = slow::cholesky(product);
    Anderson anderson(static_cast<std::size_t>(n), memory);
    std::vector<VectorXd> phis, us;
    VectorXd next(n);
    for (int k = 0; k < 9; ++k) {
        phis.push_back(VectorXd::Random(n));
        us.push_back(VectorXd::Random(n));
        const double beta = 0.1 + 0.05 * k;
        const VectorXd r = product * us.back();
        anderson.propose(view(phis.back()), view(us.back()), view(r), beta,
                         {next.data(), static_cast<std::size_t>(n)});
        const auto columns = std::min<std::size_t>(memory, static_cast<std::size_t>(k));
        EXPECT_EQ(anderson.count(), columns);
        MatrixXd dphi(n, columns), du(n, columns);
        for (std::size_t c = 0; c < columns; ++c) {
            const std::size_t at = phis.size() - 1 - c;
            dphi.col(static_cast<Eigen::Index>(c)) = phis[at] - phis[at - 1];
            du.col(static_cast<Eigen::Index>(c)) = us[at] - us[at - 1];
        }
        VectorXd expected = phis.back() + beta * us.back();
        if (columns > 0) expected -= (dphi + beta * du) * slow::least_squares(root * du, root * us.back());
        EXPECT_LT((next - expected).cwiseAbs().maxCoeff(), 1e-11) << k;
    }
}

TEST(Anderson, SolvesALinearProblemInAsManyStepsAsItHasUnknowns) {
    srand(4);
    const Eigen::Index n = 8;
    const MatrixXd a = random_definite(n);
    const VectorXd b = VectorXd::Random(n);
    Anderson anderson(static_cast<std::size_t>(n), static_cast<std::size_t>(n));
    VectorXd phi = VectorXd::Zero(n), next(n);
    for (Eigen::Index k = 0; k <= n + 1; ++k) {
        const VectorXd u = b - a * phi;
        anderson.propose(view(phi), view(u), view(u), 0.1, {next.data(), static_cast<std::size_t>(n)});
        phi = next;
    }
    EXPECT_LT((a * phi - b).norm(), 1e-8 * b.norm());
}

TEST(Anderson, LeavesOutWhatItKnowsAlready) {
    Anderson anderson(2, 3);
    std::vector<double> next(2);
    const auto propose = [&](std::vector<double> phi, std::vector<double> u) {
        anderson.propose(phi, u, u, 0.5, next);
        for (const double value : next) EXPECT_TRUE(std::isfinite(value));
    };
    propose({0, 0}, {1, 0});
    propose({0, 0}, {1, 0}); // no difference at all
    propose({1, 0}, {0.5, 0});
    propose({2, 0}, {0, 0}); // the same difference once more
    EXPECT_NEAR(next[0], 2, 1e-12);
}

TEST(Anderson, ForgetsDifferencesButNotTheLastIterate) {
    Anderson anderson(1, 3);
    std::vector<double> next(1);
    const auto propose = [&](double phi, double u) {
        anderson.propose(std::vector{phi}, std::vector{u}, std::vector{u}, 0.5, next);
        return next[0];
    };
    propose(0, 3);
    propose(1, 2);
    anderson.forget_differences();
    EXPECT_EQ(anderson.count(), 0u);
    EXPECT_NEAR(propose(2, 0.5), 2 + 0.5 / 1.5, 1e-12); // the secant through the last two
    EXPECT_EQ(anderson.count(), 1u);
}

} // namespace
} // namespace gaspard
