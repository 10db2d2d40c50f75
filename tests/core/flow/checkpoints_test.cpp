// States of computations in time: the same whatever was asked for before, within their memory.
#include "core/base/error.hpp"
#include "core/flow/checkpoints.hpp"
#include "core/flow/flow_history.hpp"
#include "core/flow/flow_starts.hpp"
#include "core/flow/quasi_geostrophic.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <thread>

namespace gaspard {
namespace {

/// Depends on every step: on rounding, and on how far it is from where it was set.
class Wandering final : public Evolution {
  public:
    explicit Wandering(int* advances) : advances_(advances) {}
    void set(std::span<const double> state, double time) override {
        state_.assign(state.begin(), state.end());
        time_ = time, since_ = 0;
    }
    void advance(double duration, const std::stop_token& stop) override {
        if (stop.stop_requested()) throw Interrupted();
        if (advances_) ++*advances_;
        for (double& value : state_)
            value = 3.9 * value * (1 - value) + 1e-3 * std::sin(time_ + duration + since_);
        time_ += duration, ++since_;
    }
    std::span<const double> state() const override { return state_; }
    std::vector<double> values() override {
        std::vector<double> values = state_;
        values.push_back(time_);
        return values;
    }

  private:
    int* advances_;
    std::vector<double> state_;
    double time_ = 0;
    int since_ = 0; ///< advances since `set`
};

/// The interval is not a binary fraction, so that sums of times are rounded.
Checkpoints wandering(std::size_t states, int* advances = nullptr, double interval = 0.1) {
    return {[advances] { return std::make_unique<Wandering>(advances); },
            {0.3, 0.4},
            interval,
            states * 2 * sizeof(double)};
}

const std::vector<double> moments = {0, 3.1, 0.1, 12.6, 0.25, 3.1, 7, 12.5, 1e-3, 12.6, 0.5};

TEST(Checkpoints, GiveTheSameInEveryOrderAndMemory) {
    const Checkpoints many = wandering(1000);
    std::vector<std::vector<double>> expected;
    for (const double t : moments) {
        expected.push_back(wandering(1000).at(t)); // nothing was asked for before
        EXPECT_NEAR(expected.back().back(), t, 1e-12);
    }
    for (const std::size_t states : {0u, 2u, 3u, 7u, 1000u}) {
        const Checkpoints kept = wandering(states);
        for (std::size_t i = 0; i < moments.size(); ++i) EXPECT_EQ(kept.at(moments[i]), expected[i]);
        for (std::size_t i = moments.size(); i-- > 0;) EXPECT_EQ(kept.at(moments[i]), expected[i]);
    }
    EXPECT_NE(expected[1], expected[7]);
}

TEST(Checkpoints, KeepTheirMemoryAndStillSaveWork) {
    int advances = 0;
    const Checkpoints kept = wandering(8, &advances, 0.25);
    for (int i = 0; i <= 100; ++i) {
        kept.at(i);
        EXPECT_LE(kept.bytes(), kept.budget());
    }
    EXPECT_EQ(advances, 400) << "forwards, every interval once";
    advances = 0;
    kept.at(40);
    EXPECT_LE(advances, 64) << "not from the start";
    EXPECT_GT(advances, 0);
    advances = 0;
    kept.at(40.1);
    EXPECT_EQ(advances, 1) << "from the last";
}

TEST(Checkpoints, StopAndReportProgress) {
    const Checkpoints kept = wandering(8);
    std::vector<double> fractions;
    kept.at(2.05, [&](double done) { fractions.push_back(done); });
    ASSERT_EQ(fractions.size(), 20u);
    EXPECT_EQ(fractions.front(), 0);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LT(fractions.back(), 1);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(kept.at(1000, {}, stop.get_token()), Interrupted);
    EXPECT_EQ(kept.at(3.1), wandering(8).at(3.1)) << "what was interrupted leaves nothing behind";
}

TEST(Checkpoints, MayBeUsedFromSeveralThreads) {
    const Checkpoints kept = wandering(5);
    std::vector<std::vector<double>> found(4), expected;
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < found.size(); ++i)
            threads.emplace_back([&, i] {
                for (const double t : moments) kept.at(t);
                found[i] = kept.at(3.7 * static_cast<double>(i));
            });
    }
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(found[i], wandering(5).at(3.7 * static_cast<double>(i)));
}

// ---------------------------------------------------------------- flows

TEST(FlowHistory, IsTheFlowAdvancedByHand) {
    const std::size_t n = 24;
    const auto start = vortex_values(n, scattered_vortices(4, 1), 0.1);
    std::vector<double> strong = start;
    for (double& value : strong) value *= 8;
    const auto history = flow_history({.cells = n}, strong);
    const double interval = history->interval(), t = 2.5 * interval;
    QuasiGeostrophicFlow flow({.cells = n});
    flow.set_state(continuous_state(n, strong));
    EXPECT_NEAR(interval, 10 * flow.stable_step(), 1e-15);
    QuasiGeostrophicFlow at_once = flow;
    for (int k = 0; k < 2; ++k) {
        flow.advance(interval);
        flow.set_state(std::vector<double>(flow.q()), (k + 1) * interval);
    }
    flow.advance(t - 2 * interval);
    std::vector<double> expected(n * n);
    flow.project(expected);
    EXPECT_EQ(history->at(t), expected);
    at_once.advance(t);
    at_once.project(expected);
    double difference = 0, size = 0;
    const auto found = history->at(t);
    for (std::size_t i = 0; i < found.size(); ++i) {
        difference = std::max(difference, std::abs(found[i] - expected[i]));
        size = std::max(size, std::abs(found[i] - strong[i]));
    }
    EXPECT_GT(size, 0.1) << "the vortices move";
    EXPECT_LT(difference, 1e-4 * size) << "up to the steps in time";
}

TEST(FlowHistory, TakesTheMeanAwayWithoutFroudeNumber) {
    const std::size_t n = 16;
    const auto start = vortex_values(n, {{{0.5, 0.5}, 1}}, 0.1);
    const auto mean_of = [](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    };
    EXPECT_NEAR(mean_of(flow_history({.cells = n, .froude = 0}, start)->at(0.5)), 0, 1e-15);
    EXPECT_NEAR(mean_of(flow_history({.cells = n}, start)->at(0.5)), mean_of(start), 1e-15);
    EXPECT_GT(mean_of(start), 0.03);
}

TEST(FlowStarts, ArePeriodicVorticesOfBothSigns) {
    const auto vortices = scattered_vortices(6, 3);
    ASSERT_EQ(vortices.size(), 6u);
    for (std::size_t k = 0; k < vortices.size(); ++k) {
        EXPECT_EQ(vortices[k].strength > 0, k % 2 == 0);
        EXPECT_GE(std::abs(vortices[k].strength), 0.6);
        EXPECT_LE(std::abs(vortices[k].strength), 1);
    }
    EXPECT_NE(scattered_vortices(6, 4)[0].centre, vortices[0].centre);
    const std::size_t n = 40;
    const auto q = vortex_values(n, {{{0, 0.25}, 2}}, 0.1);
    EXPECT_NEAR(q[10 * n], 2, 1e-12);
    EXPECT_NEAR(q[10 * n + 4], 2 * std::exp(-1), 1e-12) << "one radius to the right";
    EXPECT_NEAR(q[10 * n + 36], 2 * std::exp(-1), 1e-12) << "and to the left, across the side";
}

/// Of the nodes where q is above a part of its largest value: how many connected sets on the torus.
int summits(const std::vector<double>& q, std::size_t n, double part) {
    const double level = part * *std::max_element(q.begin(), q.end());
    std::vector<char> seen(q.size());
    int count = 0;
    for (std::size_t first = 0; first < q.size(); ++first) {
        if (seen[first] || q[first] <= level) continue;
        ++count;
        std::vector<std::size_t> open = {first};
        while (!open.empty()) {
            const std::size_t at = open.back(), i = at % n, j = at / n;
            open.pop_back();
            if (seen[at] || q[at] <= level) continue;
            seen[at] = 1;
            for (const std::size_t step : {std::size_t{1}, n - 1}) {
                open.push_back(j * n + (i + step) % n);
                open.push_back((j + step) % n * n + i);
            }
        }
    }
    return count;
}

TEST(FlowHistory, MergesVorticesAndKeepsTheEnergy) {
    const std::size_t n = 64;
    const double strength = 20, half = 0.1, radius = 0.08;
    const auto start =
        vortex_values(n, {{{0.5 - half, 0.5}, strength}, {{0.5 + half, 0.5}, strength}}, radius);
    const auto history = flow_history({.cells = n}, start);
    EXPECT_EQ(summits(history->at(0), n, 0.9), 2);
    EXPECT_EQ(summits(history->at(4), n, 0.9), 1);
    const auto apart =
        flow_history({.cells = n}, vortex_values(n, {{{0.3, 0.5}, 20}, {{0.7, 0.5}, 20}}, 0.06));
    EXPECT_EQ(summits(apart->at(4), n, 0.7), 2) << "too far from each other";
    QuasiGeostrophicFlow flow({.cells = n});
    flow.set_state(continuous_state(n, start));
    const FlowDiagnostics before = flow.diagnostics();
    flow.advance(4);
    EXPECT_NEAR(flow.diagnostics().energy / before.energy, 1, 1e-6);
    EXPECT_LT(flow.diagnostics().enstrophy, 0.95 * before.enstrophy) << "filaments are dissipated";
}

} // namespace
} // namespace gaspard
