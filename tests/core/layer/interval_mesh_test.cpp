// Meshes of an interval beside Hill, Madden (2021) and beside formulas.
#include "core/base/error.hpp"
#include "core/layer/interval_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

constexpr std::array<double, 5> all_eps = {1, 1e-2, 1e-4, 1e-6, 1e-8};

/// (18) with the paper's constants.
class Layer : public Monitor {
  public:
    explicit Layer(double eps) : eps_(eps) {}
    void values(const Points& x, std::span<double> rho) const override {
        for (std::size_t i = 0; i < rho.size(); ++i)
            rho[i] = std::max(1.0, 0.4 * 0.99 / eps_ * std::exp(-0.99 * x.x[i] / (2.5 * eps_)));
    }

  private:
    double eps_;
};

/// (27) with the paper's constants and eps1 = 1e-8.
class TwoLayers : public Monitor {
  public:
    explicit TwoLayers(double eps2) : eps_{1e-8, eps2} {}
    void values(const Points& x, std::span<double> rho) const override {
        for (std::size_t i = 0; i < rho.size(); ++i) {
            rho[i] = 1;
            for (const double eps : eps_)
                rho[i] +=
                    0.1 * 0.99 / eps *
                    (std::exp(-0.99 * x.x[i] / (2.5 * eps)) + std::exp(-0.99 * (1 - x.x[i]) / (2.5 * eps)));
        }
    }

  private:
    std::array<double, 2> eps_;
};

TEST(MeshPdeInterval, NeedsTheIterationsOfTable1) {
    const int expected[5][6] = {{1, 1, 1, 1, 1, 1},
                                {15, 14, 15, 15, 14, 13},
                                {21, 37, 69, 132, 256, 343},
                                {21, 37, 69, 133, 261, 517},
                                {21, 37, 69, 133, 261, 517}};
    for (std::size_t row = 0; row < 5; ++row)
        for (int column = 0, n = 32; column < 6; ++column, n *= 2)
            EXPECT_EQ(mesh_pde_interval(Layer(all_eps[row]), {}, n, {n, 0, 0.02, n / 2 + 5}).iterations,
                      expected[row][column])
                << all_eps[row] << ' ' << n;
}

TEST(MeshPdeInterval, NeedsTheIterationsOfTable2) {
    const int expected[5][6] = {
        {1, 1, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1}, {3, 2, 2, 1, 1, 1}, {4, 4, 3, 3, 2, 1}, {4, 4, 4, 4, 3, 3}};
    for (std::size_t row = 0; row < 5; ++row)
        for (int column = 0, n = 32; column < 6; ++column, n *= 2)
            EXPECT_EQ(mesh_pde_interval(Layer(all_eps[row]), {}, n, {}).iterations, expected[row][column])
                << all_eps[row] << ' ' << n;
}

TEST(MeshPdeInterval, NeedsTheIterationsOfTable4) {
    const int expected[5][6] = {
        {1, 4, 1, 1, 1, 2}, {3, 2, 2, 1, 1, 1}, {3, 2, 1, 1, 1, 1}, {3, 3, 3, 2, 1, 1}, {4, 2, 2, 2, 2, 1}};
    for (std::size_t row = 0; row < 5; ++row)
        for (int column = 0, n = 32; column < 6; ++column, n *= 2)
            EXPECT_EQ(
                mesh_pde_interval(TwoLayers(all_eps[row]), {}, n, {.inner = 5, .tolerance = 0.5}).iterations,
                expected[row][column])
                << all_eps[row] << ' ' << n;
}

TEST(MeshPdeInterval, SaysWhatNumbersOfCellsItTakes) {
    try {
        mesh_pde_interval(Layer(1e-2), {}, 36, {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "the number of cells, 36, must be 4 (the coarsest mesh) times a power of two");
    }
}

// The integral of (18) to x has a closed form, with a layer of any width.
TEST(Equidistribution, InvertsTheIntegral) {
    for (const double eps : {1e-2, 1e-4, 1e-8, 1e-12}) {
        const double kink = 2.5 * eps / 0.99 * std::log(0.4 * 0.99 / eps);
        const auto integral = [&](double x) {
            return -std::expm1(-0.99 * std::min(x, kink) / (2.5 * eps)) + std::max(0.0, x - kink);
        };
        const int cells = 64;
        const auto x = equidistributed_interval(Layer(eps), {}, cells);
        for (int i = 1; i < cells; ++i)
            EXPECT_NEAR(integral(x[static_cast<std::size_t>(i)]) / integral(1),
                        static_cast<double>(i) / cells, 1e-12)
                << eps;
    }
}

// For thinner layers the iteration goes on for ever at the transition point.
TEST(Equidistribution, IsWhatTheMeshPdeApproaches) {
    double before = 1;
    for (const int cells : {64, 256, 1024}) {
        const auto pde =
            mesh_pde_interval(Layer(1e-2), {}, cells, {.tolerance = 1e-12, .max_iterations = 100});
        ASSERT_TRUE(pde.converged) << pde.residual;
        const auto exact = equidistributed_interval(Layer(1e-2), {}, cells);
        double most = 0;
        for (std::size_t i = 1; i + 1 < exact.size(); ++i)
            most = std::max(most, std::abs(pde.x[i] - exact[i]) / exact[i]);
        EXPECT_LT(most, before / 8);
        before = most;
    }
    EXPECT_LT(before, 2e-5);
}

TEST(BakhvalovMesh, EndsWhereTheIntervalEnds) {
    for (const double eps : {1e-1, 1e-2, 1e-4, 1e-8, 1e-12}) {
        const BakhvalovMesh mesh = bakhvalov_mesh({.eps = eps}, {}, 64);
        EXPECT_GT(mesh.tau, 0);
        // (8) beyond tau, at t = 1, with 1 - tau / q from the transition point, which keeps its digits
        const double scale = 2.5 * eps / 0.99, s = std::exp(-mesh.transition / scale);
        EXPECT_NEAR(mesh.transition + (1 - mesh.tau) * scale / (0.5 * s), 1, 1e-12) << eps;
        EXPECT_NEAR(mesh.x[1] / (-scale * std::log1p(-1.0 / 32)), 1, 1e-14);
        for (std::size_t i = 1; i < mesh.x.size(); ++i) EXPECT_GT(mesh.x[i], mesh.x[i - 1]);
    }
    EXPECT_EQ(bakhvalov_mesh({.eps = 1}, {}, 4).x, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
}

TEST(ShishkinMesh, HasTwoUniformParts) {
    const auto x = shishkin_mesh({.eps = 1e-4}, {}, 64);
    const double width = 2.5e-4 / 0.99 * std::log(64);
    EXPECT_DOUBLE_EQ(x[32], width);
    EXPECT_NEAR(x[1], width / 32, 1e-18);
    EXPECT_NEAR(x[64] - x[63], (1 - width) / 32, 1e-14);
    EXPECT_THROW(shishkin_mesh({.q = 0.001}, {}, 64), InputError);
    EXPECT_THROW(shishkin_mesh({.eps = 0}, {}, 64), InputError);
    EXPECT_THROW(shishkin_mesh({.q = 1}, {}, 64), InputError);
}

} // namespace
} // namespace gaspard
