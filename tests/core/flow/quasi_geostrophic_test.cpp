// Flow on the periodic square: against a slow computation, exact solutions, and what it conserves.
#include "core/base/error.hpp"
#include "core/flow/quasi_geostrophic.hpp"
#include "core/flow/slow_flow.hpp"
#include "core/flow/travelling.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

using std::numbers::pi;

std::vector<double> random_state(std::size_t n, std::uint64_t seed) {
    std::vector<double> q;
    for (std::uint64_t corner = 0; corner < 6; ++corner) {
        const auto values = noise_values(n, seed + corner);
        q.insert(q.end(), values.begin(), values.end());
    }
    return q;
}

QuasiGeostrophicFlow noise_flow(std::size_t n, std::uint64_t seed) {
    QuasiGeostrophicFlow flow({.cells = n});
    flow.set_state(continuous_state(n, noise_values(n, seed)));
    return flow;
}

// ---------------------------------------------------------------- against a slow computation

TEST(FlowSteps, AreThoseOfASlowComputation) {
    for (const FlowOptions& options : {FlowOptions{.cells = 3, .froude = 1},
                                       {.cells = 4, .froude = 3, .background = {0.3, -0.2}},
                                       {.cells = 5, .froude = 0.1, .background = {-1, 0.5}}}) {
        const std::size_t n = options.cells;
        std::vector<double> expected = random_state(n, n);
        QuasiGeostrophicFlow flow(options);
        flow.set_state(expected);
        const slow::Flow slow(options);
        const slow::Vector psi = slow.psi(expected);
        EXPECT_LT(largest_difference(flow.psi(), {psi.data(), n * n}), 1e-14);
        for (int step = 0; step < 3; ++step) {
            expected = slow.step(expected, 0.05);
            flow.step(0.05);
            EXPECT_LT(largest_difference(flow.q(), expected), 1e-13) << n << ", step " << step;
        }
        EXPECT_NEAR(flow.diagnostics().energy / slow.energy(expected), 1, 1e-12);
        std::vector<double> nodal(n * n);
        flow.project(nodal);
        const slow::Vector projection = slow.projection(expected);
        EXPECT_LT(largest_difference(nodal, {projection.data(), n * n}), 1e-13);
    }
}

TEST(FlowDiagnosticsOf, AreExactIntegrals) {
    // q = x on [0, 1) with a jump at the period, which a state may have.
    const std::size_t n = 4;
    std::vector<double> q(6 * n * n);
    for (std::size_t k = 0; k < 6; ++k)
        for (std::size_t i = 0; i < n * n; ++i)
            q[k * n * n + i] =
                (static_cast<double>(i % n) + (k == 1 || k == 2 || k == 4 ? 1 : 0)) / static_cast<double>(n);
    QuasiGeostrophicFlow flow({.cells = n});
    flow.set_state(q);
    const FlowDiagnostics found = flow.diagnostics();
    EXPECT_NEAR(found.mean, 0.5, 1e-15);
    EXPECT_NEAR(found.enstrophy, 1.0 / 6, 1e-15);
    EXPECT_EQ(found.low, 0);
    EXPECT_EQ(found.high, 1);
}

TEST(FlowProjection, KeepsContinuousFunctionsAndTheIntegral) {
    const std::size_t n = 12;
    const auto nodal = noise_values(n, 4);
    QuasiGeostrophicFlow flow({.cells = n});
    flow.set_state(continuous_state(n, nodal));
    std::vector<double> projected(n * n);
    flow.project(projected);
    EXPECT_LT(largest_difference(projected, nodal), 1e-14);
    flow.set_state(random_state(n, 5));
    flow.project(projected);
    double mean = 0;
    for (const double value : projected) mean += value / static_cast<double>(n * n);
    EXPECT_NEAR(mean, flow.diagnostics().mean, 1e-15);
}

// ---------------------------------------------------------------- exact solutions

TEST(FlowOrders, PsiIsOfSecondOrder) {
    const Travelling exact;
    std::vector<double> errors;
    for (const std::size_t n : {16, 32, 64}) {
        QuasiGeostrophicFlow flow = exact.flow(n);
        const auto psi = nodal_values(n, [&](double x, double y) { return exact.psi(x, y, 0); });
        errors.push_back(largest_difference(flow.psi(), psi) / exact.amplitude);
    }
    EXPECT_LT(errors[2], 3e-3);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(std::log2(errors[k] / errors[k + 1]), 2, 0.05);
}

TEST(FlowOrders, ATravellingStateIsOfSecondOrderInL2) {
    const Travelling exact;
    std::vector<double> errors;
    for (const std::size_t n : {24, 48, 96}) {
        QuasiGeostrophicFlow flow = exact.flow(n);
        flow.advance(0.5);
        errors.push_back(l2_error(flow, [&](double x, double y) { return exact.q(x, y, 0.5); }));
    }
    const double norm = -exact.factor * exact.amplitude / 2;
    EXPECT_LT(errors[2] / norm, 1.2e-3);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(std::log2(errors[k] / errors[k + 1]), 2.1, 0.15);
}

// U is larger than every other velocity, so that no edge changes its upwind side.
TEST(FlowOrders, StepsAreOfThirdOrder) {
    const Travelling exact{.amplitude = 0.01};
    const auto start = nodal_values(24, [&](double x, double y) {
        return exact.q(x, y, 0) + 0.3 * std::cos(4 * pi * y) + 0.2 * std::sin(2 * pi * x);
    });
    std::vector<std::vector<double>> ends;
    for (const int steps : {20, 40, 80}) {
        QuasiGeostrophicFlow flow({.cells = 24, .background = {exact.ux, exact.uy}});
        flow.set_state(continuous_state(24, start));
        for (int step = 0; step < steps; ++step) flow.step(0.1 / steps);
        ends.push_back(flow.q());
    }
    const double first = largest_difference(ends[0], ends[1]), second = largest_difference(ends[1], ends[2]);
    EXPECT_GT(second, 1e-10) << "above rounding";
    EXPECT_NEAR(std::log2(first / second), 3, 0.1);
}

// Modes that interact: the fine computation is closer to the finest one than the coarse one.
TEST(FlowOrders, CoarseAndFineComputationsAgree) {
    const auto end = [](std::size_t n) {
        QuasiGeostrophicFlow flow({.cells = n});
        flow.set_state(continuous_state(n, nodal_values(n, [](double x, double y) {
                                            return std::sin(2 * pi * x) * std::sin(2 * pi * y) +
                                                   0.6 * std::cos(4 * pi * x + 2 * pi * y) +
                                                   0.4 * std::sin(2 * pi * (y - 2 * x));
                                        })));
        flow.advance(2);
        std::vector<double> nodal(n * n), common;
        flow.project(nodal);
        for (std::size_t j = 0; j < n; j += n / 24)
            for (std::size_t i = 0; i < n; i += n / 24) common.push_back(nodal[j * n + i]);
        return common;
    };
    const auto coarse = end(24), fine = end(48), finest = end(96);
    EXPECT_LT(largest_difference(fine, finest), 0.02); // until then q has changed by up to 0.9
    EXPECT_LT(largest_difference(fine, finest), 0.3 * largest_difference(coarse, fine));
}

// ---------------------------------------------------------------- what is conserved

TEST(FlowConservation, TheMeanStaysToRounding) {
    QuasiGeostrophicFlow flow = noise_flow(20, 2);
    const double mean = flow.diagnostics().mean;
    EXPECT_GT(std::abs(mean), 1e-3);
    for (int step = 0; step < 2000; ++step) flow.step(0.2);
    EXPECT_NEAR(flow.diagnostics().mean, mean, 1e-16);
}

TEST(FlowConservation, EnstrophyNeverGrowsAndEnergyStays) {
    QuasiGeostrophicFlow flow = noise_flow(24, 3);
    const FlowDiagnostics start = flow.diagnostics();
    double before = start.enstrophy;
    for (int step = 0; step < 500; ++step) {
        flow.step(flow.stable_step());
        const FlowDiagnostics now = flow.diagnostics();
        ASSERT_LT(now.enstrophy, before) << step;
        ASSERT_NEAR(now.energy / start.energy, 1, 1e-4);
        before = now.enstrophy;
    }
    EXPECT_LT(before, 0.5 * start.enstrophy);
}

// In space alone the discrete equations conserve energy: what is lost falls with the cube of the step.
TEST(FlowConservation, EnergyIsLostToTheStepsAlone) {
    std::vector<double> lost;
    for (const int steps : {40, 80}) {
        QuasiGeostrophicFlow flow = noise_flow(24, 3);
        const double start = flow.diagnostics().energy;
        for (int step = 0; step < steps; ++step) flow.step(8.0 / steps);
        lost.push_back(1 - flow.diagnostics().energy / start);
    }
    EXPECT_GT(lost[0], 0);
    EXPECT_NEAR(std::log2(lost[0] / lost[1]), 3, 0.3);
}

TEST(FlowConservation, AConstantStays) {
    QuasiGeostrophicFlow flow({.cells = 10, .background = {0.4, -0.3}});
    flow.set_state(std::vector<double>(600, 0.7));
    flow.advance(2);
    EXPECT_LT(largest_difference(flow.q(), std::vector<double>(600, 0.7)), 1e-14);
}

TEST(FlowSymmetry, AShiftedStateIsShiftedForEver) {
    const std::size_t n = 18, across = 5, up = 1;
    const auto shifted = [&](const std::vector<double>& q) {
        std::vector<double> result(q.size());
        for (std::size_t k = 0; k < q.size() / (n * n); ++k)
            for (std::size_t j = 0; j < n; ++j)
                for (std::size_t i = 0; i < n; ++i)
                    result[k * n * n + (j + up) % n * n + (i + across) % n] = q[k * n * n + j * n + i];
        return result;
    };
    QuasiGeostrophicFlow flow = noise_flow(n, 6), other({.cells = n});
    other.set_state(shifted(flow.q()));
    for (int step = 0; step < 50; ++step) flow.step(0.3), other.step(0.3);
    EXPECT_LT(largest_difference(other.q(), shifted(flow.q())), 1e-12);
}

TEST(FlowSteps, AreStableUpToTheirCourantNumberInEveryDirection) {
    for (int direction = 0; direction < 12; ++direction) {
        const double angle = 0.05 + 2 * pi * direction / 12;
        FlowOptions options{.cells = 8, .background = {std::cos(angle), std::sin(angle)}, .courant = 0.5};
        QuasiGeostrophicFlow flow(options);
        flow.set_state(continuous_state(8, noise_values(8, 1)));
        const double start = flow.diagnostics().enstrophy;
        const auto [ux, uy] = options.background;
        const double outflow = std::max({std::abs(ux), std::abs(uy), std::abs(ux - uy)});
        EXPECT_NEAR(flow.stable_step(), 0.5 / (2 * 8 * outflow), 0.2 / (2 * 8 * outflow));
        for (int step = 0; step < 500; ++step) flow.step(flow.stable_step());
        EXPECT_LT(flow.diagnostics().enstrophy, start) << direction;
    }
}

// ---------------------------------------------------------------- the class as a clock drives it

TEST(FlowClock, AdvancesByTheDurationInEqualSteps) {
    QuasiGeostrophicFlow flow = noise_flow(16, 1);
    const double step = flow.stable_step();
    EXPECT_EQ(flow.advance(0.4 * step), 1u);
    EXPECT_EQ(flow.time(), 0.4 * step);
    EXPECT_EQ(flow.advance(0), 0u);
    EXPECT_GE(flow.advance(20 - flow.time()), static_cast<std::size_t>(15 / step));
    EXPECT_EQ(flow.time(), 20);
    QuasiGeostrophicFlow still({.cells = 16});
    EXPECT_EQ(still.stable_step(), std::numeric_limits<double>::infinity());
    EXPECT_EQ(still.advance(3), 1u);
    EXPECT_EQ(still.time(), 3);
}

TEST(FlowClock, AStateThatIsPutBackGoesOnWithTheSameBits) {
    QuasiGeostrophicFlow flow = noise_flow(16, 1);
    flow.advance(5);
    QuasiGeostrophicFlow other(flow.options());
    other.set_state(flow.q(), flow.time());
    flow.diagnostics();
    flow.advance(2), other.advance(2);
    EXPECT_EQ(flow.q(), other.q());
    EXPECT_EQ(flow.time(), other.time());
}

template <class Work>
std::string refusal(const Work& work) {
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(FlowInput, IsRefusedWithOneSentence) {
    const auto made = [](const FlowOptions& options) {
        return refusal([&] { QuasiGeostrophicFlow flow(options); });
    };
    EXPECT_EQ(made({.cells = 2}), "a flow has 3 to 4096 cells per side, not 2");
    EXPECT_EQ(made({.froude = -1}), "the Froude number of a flow must be at least 0 and finite");
    EXPECT_EQ(made({.courant = 0}), "the Courant number of a flow must be positive and at most 0.5");
    EXPECT_EQ(made({.courant = 0.6}), "the Courant number of a flow must be positive and at most 0.5");
    EXPECT_EQ(made({.background = {0, std::nan("")}}), "the background velocity of a flow must be finite");
    QuasiGeostrophicFlow flow({.cells = 4, .most_steps = 10});
    EXPECT_EQ(refusal([&] { flow.set_state(std::vector<double>(95)); }),
              "the state of a flow with 4 cells per side has 96 values, not 95");
    std::vector<double> q(96);
    q[7] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal([&] { flow.set_state(q); }), "the state of a flow has values that are not finite");
    flow.set_state(random_state(4, 1));
    EXPECT_EQ(refusal([&] { flow.advance(1e6); }), "the flow would need more than 10 steps until time 10⁶");
    QuasiGeostrophicFlow without({.cells = 4, .froude = 0});
    EXPECT_EQ(refusal([&] { without.set_state(std::vector<double>(96, 1)); }),
              "with the Froude number 0 the mean of q must be 0, but it is 1");
}

TEST(FlowNoise, IsTheSameOnEveryMachine) {
    const auto noise = noise_values(100, 1);
    ASSERT_EQ(noise.size(), 10000u);
    EXPECT_EQ(noise[0], -0.73224671197493474);
    EXPECT_EQ(noise[9999], 0.35974994549820494);
    double low = 0, high = 0, mean = 0;
    for (const double value : noise) {
        low = std::min(low, value), high = std::max(high, value), mean += value / 1e4;
    }
    EXPECT_GT(low, -1);
    EXPECT_LT(low, -0.999);
    EXPECT_LT(high, 1);
    EXPECT_GT(high, 0.999);
    EXPECT_NEAR(mean, 0.0045089524535680, 1e-15);
}

} // namespace
} // namespace gaspard
