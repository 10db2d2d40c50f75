// Meshes of an interval that solve the discrete mesh PDE to rounding.
#include "core/base/error.hpp"
#include "core/layer/interval_mesh.hpp"
#include "core/layer/interval_shooting.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class Density : public Monitor {
  public:
    explicit Density(std::function<double(double)> rho) : rho_(std::move(rho)) {}
    void values(const Points& x, std::span<double> rho) const override {
        for (std::size_t i = 0; i < rho.size(); ++i) rho[i] = rho_(x.x[i]);
    }

  private:
    std::function<double(double)> rho_;
};

/// (18) with the paper's constants.
Density layer(double eps) {
    return Density(
        [=](double x) { return std::max(1.0, 0.4 * 0.99 / eps * std::exp(-0.99 * x / (2.5 * eps))); });
}
/// (27) with the paper's constants and eps1 = 1e-8.
Density two_layers(double eps2) {
    return Density([=](double x) {
        double rho = 1;
        for (const double eps : {1e-8, eps2})
            rho += 0.1 * 0.99 / eps *
                   (std::exp(-0.99 * x / (2.5 * eps)) + std::exp(-0.99 * (1 - x) / (2.5 * eps)));
        return rho;
    });
}

/// Whether the mesh grows and its shares are equal, by evaluation here.
void expect_solution(const Density& rho, const std::vector<double>& x, double tolerance,
                     const std::string& what) {
    const auto densities = cell_densities(rho, x);
    double least = 1e300, most = 0;
    for (std::size_t i = 0; i < densities.size(); ++i) {
        EXPECT_LT(x[i], x[i + 1]) << what;
        const double share = densities[i] * (x[i + 1] - x[i]);
        least = std::min(least, share), most = std::max(most, share);
    }
    EXPECT_LE(most / least - 1, tolerance) << what;
    EXPECT_EQ(x.front(), 0) << what;
    EXPECT_EQ(x.back(), 1) << what;
}

TEST(IntervalShooting, SolvesForALayerOfAnyWidth) {
    for (const double eps : {1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12})
        for (const int cells : {4, 16, 64, 256}) {
            const Density rho = layer(eps);
            const std::string what = std::to_string(eps) + ' ' + std::to_string(cells);
            const auto uniform = shoot_interval(rho, uniform_interval({}, cells));
            EXPECT_TRUE(uniform.converged) << what;
            EXPECT_LE(uniform.shots, 20) << what;
            expect_solution(rho, uniform.x, 4e-12, what);
            const auto refined =
                shoot_interval(rho, mesh_pde_interval(rho, {}, cells, {.max_iterations = 20}).x);
            EXPECT_TRUE(refined.converged) << what;
            EXPECT_LE(refined.shots, 16) << what;
            expect_solution(rho, refined.x, 4e-12, what);
        }
}

// Next to x = 1 numbers have 16 digits, but distances from the end of the interval do not.
TEST(IntervalShooting, SolvesForOverlappingLayersToRounding) {
    for (const double eps : {1.0, 1e-2, 1e-4, 1e-6, 1e-8})
        for (const int cells : {4, 16, 64, 256}) {
            const Density rho = two_layers(eps);
            const std::string what = std::to_string(eps) + ' ' + std::to_string(cells);
            const auto result = shoot_interval(rho, uniform_interval({}, cells));
            EXPECT_TRUE(result.converged) << what << ' ' << result.deviation << ' ' << result.rounding;
            EXPECT_LT(result.rounding, 1e-6) << what;
            expect_solution(rho, result.x, 1e-12 + 3e-8 * cells, what);
        }
}

Density spike(double width) {
    return Density([=](double x) { return 1 + 1 / width * std::exp(-std::pow((x - 0.37) / width, 2)); });
}

TEST(IntervalShooting, SolvesForASpikeThatTheStartHasSeen) {
    for (const double width : {1e-2, 1e-3})
        for (const int cells : {128, 256, 512}) {
            const Density rho = spike(width);
            const auto start = mesh_pde_interval(rho, {}, cells, {.max_iterations = 20}).x;
            const auto result = shoot_interval(rho, start);
            EXPECT_TRUE(result.converged) << width << ' ' << cells;
            EXPECT_LT(result.rounding, 1e-14 * cells / width) << width << ' ' << cells;
            expect_solution(rho, result.x, 2.1 * (1e-12 + 8 * result.rounding), std::to_string(width));
        }
}

// Algorithm 2 misses thinner ones: none of its nodes comes near.
TEST(IntervalShooting, SolvesForThinSpikesFromAMeshThatHasThem) {
    for (const double width : {1e-4, 1e-8})
        for (const int cells : {64, 256}) {
            const Density bumps([=](double x) {
                double rho = 1;
                for (const double at : {0.07, 0.11, 0.5, 0.83})
                    rho += (1 + at) / width * std::exp(-std::abs(x - at) / (width * (1 + 3 * at)));
                return rho;
            });
            for (const Density& rho : {spike(width), bumps}) {
                const auto result = shoot_interval(rho, equidistributed_interval(rho, {}, cells));
                EXPECT_TRUE(result.converged) << width << ' ' << cells << ' ' << result.deviation;
                EXPECT_LT(result.rounding, 1e-14 * cells / width) << width << ' ' << cells;
                expect_solution(rho, result.x, 2.1 * (1e-12 + 8 * result.rounding), std::to_string(width));
            }
        }
}

// Simpson's rule is of order 4, but cells that end a spike are as wide as it: order 2.
TEST(IntervalShooting, ApproachesExactEquidistribution) {
    const Density rho = spike(1e-2);
    double before = 0.02;
    for (const int cells : {128, 256, 512}) {
        const auto x = shoot_interval(rho, mesh_pde_interval(rho, {}, cells, {.max_iterations = 20}).x).x;
        const auto exact = equidistributed_interval(rho, {}, cells);
        double most = 0;
        for (std::size_t i = 0; i < exact.size(); ++i) most = std::max(most, std::abs(x[i] - exact[i]));
        EXPECT_LT(most, before / 3.5) << cells;
        before = most;
    }
}

TEST(IntervalShooting, IsThereAtOnceOnASolution) {
    const Density rho = layer(1e-6);
    const auto x = shoot_interval(rho, uniform_interval({}, 64)).x;
    IntervalShooting shooting(x);
    shooting.step(rho);
    EXPECT_TRUE(shooting.converged(1e-9)) << shooting.deviation();
    for (std::size_t i = 1; i < x.size(); ++i) EXPECT_NEAR(shooting.mesh()[i] / x[i], 1, 1e-9);
}

TEST(IntervalShooting, SaysWhatIsWrong) {
    EXPECT_THROW(IntervalShooting({0.5}), InputError);
    EXPECT_THROW(IntervalShooting({0, 0.5, 0.5, 1}), InputError);
    EXPECT_THROW(shoot_interval(Density([](double x) { return x - 0.5; }), uniform_interval({}, 8)),
                 InputError);
}

// Four cells and a spike that either falls between the nodes or takes all of them: T(C) jumps over N.
TEST(IntervalShooting, SaysThatItIsStuck) {
    const Density rho([](double x) { return 1 + 100 * std::exp(-std::pow((x - 0.37) / 1e-2, 2)); });
    const auto result = shoot_interval(rho, uniform_interval({}, 4), 1e-12, 200);
    EXPECT_FALSE(result.converged);
    EXPECT_LT(result.shots, 200);
}

} // namespace
} // namespace gaspard
