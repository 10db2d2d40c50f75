// A mesh that follows a monitor of the caller's own.
#include "core/base/error.hpp"
#include "core/io/run_files.hpp"
#include "core/monitor/function.hpp"
#include "core/monitor/own_problem.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/built_in.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

namespace gaspard {
namespace {

const Space torus{SpaceKind::periodic_square};

class Follow : public testing::Test {
  protected:
    gaspard::Run make(const std::vector<std::string>& settings = {}) {
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, scenario,
                       {"domain.cells=24", "method.type=accelerated", "method.tolerance=1e-6"});
        apply_settings(*catalogue, scenario, settings);
        return gaspard::Run(catalogue, scenario);
    }
    static std::shared_ptr<const Monitor> spot(double x, double height = 5) {
        return function_monitor([x, height](Vec3 p) {
            const Vec3 d = displacement(torus, {x, 0.5, 0}, p);
            return 1 + height * std::exp(-60 * dot(d, d));
        });
    }
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(Follow, AFunctionMovesTheMeshAsTheBuiltInMonitorOfTheSameFormula) {
    gaspard::Run built_in = make(), own = make();
    const auto ring = make_monitor("ring", torus);
    own.follow(function_monitor([&](Vec3 p) {
        Points one(1);
        one.set(0, p);
        double value = 0;
        ring->values(one, {&value, 1});
        return value;
    }));
    EXPECT_EQ(own.solve().status, RunStatus::converged);
    EXPECT_EQ(built_in.solve().iteration, own.history().back().iteration);
    const Points x = built_in.snapshot()->x, y = own.snapshot()->x;
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_LT(norm(x[i] - y[i]), 1e-10);
}

TEST_F(Follow, WhatAMonitorSaysStandsInSnapshotAndSummary) {
    class Talking final : public Monitor {
        void values(const Points&, std::span<double> values) const override {
            std::fill(values.begin(), values.end(), 1.0);
        }
        MonitorReport report() const override { return {.notes = {"3 of 5 values are missing"}}; }
    };
    gaspard::Run run = make();
    EXPECT_EQ(summary_json(run).find("monitor_notes"), std::string::npos);
    run.follow(std::make_shared<Talking>());
    ASSERT_NE(run.snapshot()->monitor_report, nullptr);
    EXPECT_EQ(run.snapshot()->monitor_report->notes.at(0), "3 of 5 values are missing");
    EXPECT_NE(summary_json(run).find("\"monitor_notes\": [\n    \"3 of 5 values are missing\""),
              std::string::npos);
}

TEST_F(Follow, TheMapIsTheStartAndTheHistoryNew) {
    gaspard::Run run = make();
    run.follow(spot(0.5));
    const int cold = run.solve().iteration;
    const Points before = run.snapshot()->x;
    const int epoch = run.epoch();
    run.follow(spot(0.51));
    EXPECT_EQ(run.epoch(), epoch + 1);
    EXPECT_EQ(run.history().size(), 1u);
    EXPECT_EQ(run.status(), RunStatus::running);
    EXPECT_EQ(run.snapshot()->x, before);
    EXPECT_EQ(run.solve().status, RunStatus::converged);
    EXPECT_GT(run.history().back().iteration, 0);
    EXPECT_LT(run.history().back().iteration, cold);
    // The densest place has moved along: the mesh is the first one, shifted.
    gaspard::Run anew = make();
    anew.follow(spot(0.51));
    anew.solve();
    const Points x = run.snapshot()->x, y = anew.snapshot()->x;
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_LT(norm(x[i] - y[i]), 1e-5);
}

TEST_F(Follow, WhatIsTriedAfterwardsKeepsTheMonitor) {
    gaspard::Run run = make();
    run.follow(spot(0.5));
    run.solve();
    EXPECT_EQ(run.scenario().monitor.type, own_monitor);
    EXPECT_NE(summary_json(run).find("\"type\": \"own\""), std::string::npos);
    const double equidistribution = *run.history().back().value("equidistribution");
    Scenario finer = run.scenario();
    apply_settings(*catalogue, finer, {"domain.cells=48"});
    EXPECT_EQ(run.change(finer), "");
    EXPECT_EQ(run.solve().status, RunStatus::converged);
    EXPECT_LT(*run.history().back().value("equidistribution"), 0.5 * equidistribution);
}

TEST_F(Follow, ABadMonitorIsOneSentenceAndTheRunGoesOn) {
    gaspard::Run run = make();
    run.follow(spot(0.5));
    run.solve();
    const State state = run.state();
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
        try {
            run.follow(function_monitor([bad](Vec3 p) { return p.x > 0.5 ? bad : 1; }));
            FAIL() << bad;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("must be positive and finite, but is"),
                      std::string::npos);
        }
        EXPECT_EQ(run.state(), state);
        EXPECT_EQ(run.status(), RunStatus::converged);
    }
    EXPECT_THROW(run.follow(nullptr), InputError);
    EXPECT_THROW(function_monitor({}), InputError);
    run.follow(spot(0.52));
    EXPECT_EQ(run.solve().status, RunStatus::converged);
}

TEST_F(Follow, AFunctionOfAnotherSpaceIsRefused) {
    Scenario scenario = find_scenario(*catalogue, "sphere-x2");
    apply_settings(*catalogue, scenario, {"domain.cells=6", "method.type=accelerated"});
    gaspard::Run run(catalogue, scenario);
    try {
        run.follow(spot(0.5));
        FAIL() << "a function of the periodic square";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "the monitor is a function on a periodic square, but domain 'cubed-sphere' is not");
    }
    EXPECT_EQ(run.scenario().monitor.type, "x-n") << "the run is as it was";
    run.follow(function_monitor([](Vec3 p) { return 2 + p.z; }, run.space()));
    EXPECT_EQ(run.solve().status, RunStatus::converged);
    EXPECT_LT(*run.history().back().value("equidistribution"), 0.05);
}

TEST_F(Follow, AnotherDomainCanBeChosenAfterwards) {
    gaspard::Run run = make();
    run.follow(function_monitor([](Vec3 p) { return 2 + std::sin(p.x); }, Space{SpaceKind::periodic_square}));
    Scenario sphere = run.scenario();
    apply_settings(*catalogue, sphere, {"domain.type=cubed-sphere"});
    EXPECT_THROW(run.change(sphere), InputError) << "the function is of the square";
    EXPECT_THROW(apply_settings(*catalogue, sphere, {"monitor.amplitude=3"}), InputError);
    apply_settings(*catalogue, sphere, {"domain.type=plane", "domain.cells=30"});
    EXPECT_EQ(run.change(sphere), "");
    EXPECT_EQ(run.solve().status, RunStatus::converged);
}

TEST_F(Follow, WhatTheMonitorThrowsInAStepLeavesTheIterate) {
    for (const char* method : {"method.type=accelerated", "method.type=relaxation"}) {
        gaspard::Run run = make({method});
        auto fails = std::make_shared<bool>(false);
        run.follow(function_monitor([fails](Vec3 p) {
            if (*fails) throw std::runtime_error("the simulation has gone");
            return 1 + 5 * std::pow(std::sin(3.14159265358979 * p.x), 4);
        }));
        run.step();
        const State state = run.state();
        *fails = true;
        EXPECT_THROW(run.step(), std::runtime_error);
        EXPECT_EQ(run.state(), state);
        EXPECT_EQ(run.history().size(), 2u);
        run.follow(spot(0.5));
        EXPECT_EQ(run.solve().status, RunStatus::converged);
    }
}

TEST_F(Follow, SolvingStopsWhenAsked) {
    gaspard::Run run = make();
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(run.solve(stop.get_token()).status, RunStatus::interrupted);
    EXPECT_TRUE(run.history().back().value("equidistribution"));
}

TEST(FunctionMonitor, AsksWithinTheSquareAndKnowsSlopes) {
    const DomainExtent square{.space = torus};
    const auto monitor = function_monitor([](Vec3 p) {
        EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << p.x << ", " << p.y;
        return 2 + std::sin(2 * 3.14159265358979 * p.x) + p.y * p.y * (1 - p.y) * (1 - p.y);
    });
    Points x(3), gradients;
    x.set(0, {-0.2, 0.3, 0});
    x.set(1, {1.4, -2.5, 0});
    x.set(2, {0.1, -1e-20, 0});
    std::vector<double> values(3);
    monitor->values(x, values);
    difference_gradients(*monitor, square, x, gradients);
    for (std::size_t i = 0; i < 3; ++i) {
        const double y = x.y[i] - std::floor(x.y[i]), angle = 2 * 3.14159265358979 * x.x[i];
        EXPECT_NEAR(values[i], 2 + std::sin(angle) + y * y * (1 - y) * (1 - y), 1e-12);
        EXPECT_NEAR(gradients.x[i], 2 * 3.14159265358979 * std::cos(angle), 1e-8);
        EXPECT_NEAR(gradients.y[i], 2 * y * (1 - y) * (1 - 2 * y), 1e-8);
        EXPECT_EQ(gradients.z[i], 0);
    }
    const auto in_space = function_monitor([](Vec3 p) { return 1 + p.z * p.z; }, Space{});
    difference_gradients(*in_space, {}, x = Points(1), gradients);
    EXPECT_NEAR(gradients.z[0], 0, 1e-12);

    const auto on_sphere = function_monitor(
        [](Vec3 p) {
            EXPECT_NEAR(norm(p), 3, 1e-14);
            return 5 + p.z;
        },
        Space{SpaceKind::sphere});
    x.set(0, {0, 3 * std::sqrt(0.5), 3 * std::sqrt(0.5)});
    difference_gradients(*on_sphere, {.space = {SpaceKind::sphere}, .radius = 3, .size = 3}, x, gradients);
    EXPECT_NEAR(gradients.y[0], -0.5, 1e-9) << "grad z less its part along the radius";
    EXPECT_NEAR(gradients.z[0], 0.5, 1e-9);
}

TEST(FunctionMonitor, SlopesAtWallsAreTakenWithin) {
    const auto monitor = function_monitor(
        [](Vec3 p) {
            EXPECT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1 && p.z == 0);
            return 2 + p.x * p.x + std::exp(p.y);
        },
        Space{});
    const DomainExtent box{.dimension = 2, .box = true, .high = {1, 1, 0}};
    Points x(2), gradients;
    x.set(0, {1, 0, 0});
    x.set(1, {0.5, 1, 0});
    difference_gradients(*monitor, box, x, gradients);
    EXPECT_NEAR(gradients.x[0], 2, 1e-8);
    EXPECT_NEAR(gradients.y[0], 1, 1e-8);
    EXPECT_NEAR(gradients.x[1], 1, 1e-8);
    EXPECT_NEAR(gradients.y[1], std::exp(1.0), 1e-8);
    EXPECT_EQ(gradients.z[1], 0);
}

} // namespace
} // namespace gaspard
