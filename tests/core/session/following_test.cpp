// Runs with time: meshes that follow a monitor, how far each step is solved, where it begins.
#include "core/base/error.hpp"
#include "core/monitor/function.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/extrapolation.hpp"
#include "core/session/run.hpp"
#include "core/session/step_tolerance.hpp"
#include "core/session/time_series.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

State state_of(std::vector<double> values) { return {"test", {{"u", std::move(values)}}}; }

TEST(Extrapolation, IsExactForPolynomials) {
    const auto at = [](double t) { return state_of({3 - t, 1 + 2 * t + t * t}); };
    Extrapolation maps;
    maps.begin(0, at(0));
    EXPECT_EQ(maps.at(5, {}), at(0));
    maps.add(1, at(1));
    maps.add(3, at(3));
    EXPECT_EQ(maps.at(4, 0), at(3));
    EXPECT_NEAR(maps.at(4, 1).arrays[0].values[0], -1, 1e-12);
    EXPECT_NEAR(maps.at(4, 1).arrays[0].values[1], 22, 1e-12) << "from 4 to 16 and on";
    EXPECT_NEAR(maps.at(4, 2).arrays[0].values[1], 25, 1e-12);
}

TEST(Extrapolation, TakesTheDegreeThatWasBest) {
    const auto best_for = [](const auto& f) {
        Extrapolation maps;
        maps.begin(0, state_of({f(0)}));
        for (int i = 1; i < 8; ++i) maps.add(i, state_of({f(i)}));
        return maps.best();
    };
    EXPECT_EQ(best_for([](int i) { return i * i * 1.0; }), 2);
    EXPECT_EQ(best_for([](int i) { return i % 2 * 1.0 + (i % 4 == 3 ? 2.0 : 0.0); }), 0) << "jumps";
    Extrapolation maps;
    maps.begin(0, state_of({1}));
    maps.add(1, {"other", {{"u", {1, 2}}}});
    EXPECT_EQ(maps.at(2, 2).layout, "other") << "of another layout it begins anew";
}

TEST(StepTolerance, AllowsWhatTheSamplesShow) {
    StepTolerance tolerance(1.05, 1e-8);
    EXPECT_TRUE(tolerance.learns()) << "the first step";
    tolerance.learn({{1e-1, 0.3}, {1e-2, 0.12}, {1e-9, 0.1}}); // |e - 0.1| <= 2 r
    EXPECT_NEAR(tolerance.value(), 0.05 * 0.1 / (4 * 2), 1e-12);
    EXPECT_FALSE(tolerance.learns());
    for (int i = 0; i < 8; ++i) tolerance.learn({});
    EXPECT_TRUE(tolerance.learns()) << "from time to time";
    tolerance.learn({{1e-1, 0.101}, {1e-9, 0.1}});
    EXPECT_NEAR(tolerance.value(), 0.05 * 0.1 / (4 * 1), 1e-12) << "half of what was seen before";
    EXPECT_FALSE(tolerance.learns());
    EXPECT_FALSE(tolerance.exceeded_by(0.1049));
    EXPECT_TRUE(tolerance.exceeded_by(0.106));
    tolerance.learn_anew();
    EXPECT_TRUE(tolerance.learns());
    const double before = tolerance.value();
    tolerance.learn({{1e-9, 0.1}});
    EXPECT_EQ(tolerance.value(), before) << "what is solved already tells nothing";
    tolerance.learn({{2e-7, 0.2}, {1e-7, 0.1}});
    EXPECT_EQ(tolerance.value(), before) << "nor does what is about as small as the last";
    tolerance.learn({{1e-9, 0.15}});
    EXPECT_FALSE(tolerance.exceeded_by(0.157)) << "but its mesh is solved";
    EXPECT_TRUE(tolerance.exceeded_by(0.158));
    StepTolerance flat(1.05, 1e-8);
    flat.learn({{1e-9, 0.1}});
    EXPECT_EQ(flat.value(), 1e-8);
    EXPECT_TRUE(flat.learns()) << "nothing is known, so the next one learns";
    flat.learn({{1e-3, 0.1}, {1e-9, 0.1}});
    EXPECT_NEAR(flat.value(), 1e-2, 1e-9) << "not far beyond what was seen";
}

TEST(StepTolerance, LearnsFromStepsThatAreSolvedMuchFarther) {
    StepTolerance tolerance(1.05, 1e-8);
    EXPECT_EQ(tolerance.aim(), 1e-8) << "nothing is known";
    tolerance.learn({{1e-1, 0.3}, {1e-2, 0.12}, {1e-9, 0.1}});
    const double enough = tolerance.value();
    EXPECT_EQ(tolerance.aim(), enough);
    for (int i = 0; i < 8; ++i) tolerance.learn({});
    EXPECT_EQ(tolerance.aim(), enough / 30);
    tolerance.learn({{1e-1, 0.3}, {1e-2, 0.12}, {enough / 40, 0.1}});
    EXPECT_EQ(tolerance.aim(), enough) << "the same samples";
    tolerance.learn_anew();
    EXPECT_EQ(tolerance.aim(), 1e-8) << "after a mesh that exceeds the factor";
    StepTolerance strict(1.05, 1e-3);
    strict.learn({{1e-1, 0.3}, {1e-3, 0.1}});
    strict.learn_anew();
    EXPECT_EQ(strict.aim(), 1e-3) << "never below method.tolerance";
}

class FollowingTest : public testing::Test {
  protected:
    Scenario scenario(std::vector<std::string> settings) {
        Scenario result = find_scenario(*catalogue, "plane-ring");
        settings.insert(settings.begin(), {"domain.cells=20", "method.type=newton", "time.end=0.2",
                                           "time.step=0.02", "time.monitor.center_x=center_x + 0.5*t",
                                           "monitor.sharpness=60", "method.diagnostics_every=1"});
        apply_settings(*catalogue, result, settings);
        return result;
    }
    gaspard::Run make(const std::vector<std::string>& settings = {}) {
        return gaspard::Run(catalogue, scenario(settings));
    }
    static double largest_distance(const Points& a, const Points& b) {
        double largest = 0;
        for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, norm(a[i] - b[i]));
        return largest;
    }
    static std::vector<StepReport> time_steps(const gaspard::Run& run) {
        std::vector<StepReport> steps;
        std::copy_if(run.history().begin(), run.history().end(), std::back_inserter(steps), is_time_step);
        return steps;
    }
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(FollowingTest, EveryStepIsTheMeshOfItsTime) {
    gaspard::Run run = make({"time.rule=tolerance"});
    EXPECT_EQ(run.time(), 0.0);
    while (!run.moves()) run.step();
    EXPECT_EQ(run.status(), RunStatus::running);
    const int first = run.history().back().iteration;
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_EQ(run.time(), 0.2);
    const auto steps = time_steps(run);
    ASSERT_EQ(steps.size(), 10u);
    EXPECT_EQ(steps.front().iteration, first + 1);
    for (const StepReport& step : steps) EXPECT_LT(step.residual, 1e-8);
    EXPECT_NEAR(*time_of(steps[3]), 0.08, 1e-15);
    gaspard::Run there(catalogue, scenario({"time.end=0", "monitor.center_x=0.6"}));
    there.solve();
    EXPECT_LT(largest_distance(run.snapshot()->x, there.snapshot()->x), 1e-7);
}

TEST_F(FollowingTest, AConstantMonitorMovesNothing) {
    Scenario still = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, still,
                   {"domain.cells=20", "monitor.type=constant", "time.end=0.1", "time.monitor.value=1 + t"});
    gaspard::Run run(catalogue, still);
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    const auto end = run.snapshot();
    EXPECT_LT(largest_distance(end->x, end->mesh->nodes), 1e-12);
    for (const double speed : end->field("mesh_speed")->values) EXPECT_EQ(speed, 0);
}

TEST_F(FollowingTest, EquidistributionStaysWithinTheFactor) {
    for (const char* method : {"newton", "accelerated", "relaxation", "quasi-newton"}) {
        const std::string type = std::string("method.type=") + method;
        gaspard::Run solved = make({type, "time.rule=tolerance", "time.iterations=2000", "time.end=0.6"});
        gaspard::Run run = make({type, "time.end=0.6"});
        solved.solve(), run.solve();
        const auto best = time_steps(solved), steps = time_steps(run);
        ASSERT_EQ(steps.size(), best.size()) << method;
        double iterations = 0, most = 0;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            EXPECT_LT(*steps[i].value("equidistribution"), 1.05 * *best[i].value("equidistribution"))
                << method << ", step " << i;
            EXPECT_EQ(steps[i].tangled_cells, 0u);
            iterations += *steps[i].value(time_names::iterations);
            most += *best[i].value(time_names::iterations);
        }
        EXPECT_LT(iterations, 0.75 * most) << method << ": that is what the rule is for";
    }
}

TEST_F(FollowingTest, RelaxationApproachesTheSolvedMeshWithItsTimeScale) {
    // After the first step the monitor stays where it is.
    gaspard::Run run = make({"time.monitor.center_x=center_x + min(t, 0.02)", "time.rule=relaxation",
                             "time.tau=0.05", "time.end=0.3"});
    gaspard::Run solved(catalogue, scenario({"time.end=0", "monitor.center_x=0.52"}));
    solved.solve();
    const Points there = solved.snapshot()->x;
    while (!run.moves()) run.step();
    run.step();
    double before = largest_distance(run.snapshot()->x, there);
    for (int i = 0; i < 8; ++i) {
        run.step();
        const double now = largest_distance(run.snapshot()->x, there);
        EXPECT_NEAR(now / before, std::exp(-0.02 / 0.05), 0.03) << i;
        before = now;
    }
}

TEST_F(FollowingTest, RelaxationMovesAlsoWhereTheMethodGoesToCoarserMeshes) {
    gaspard::Run run = make({"domain.cells=60", "monitor.sharpness=200", "time.rule=relaxation",
                             "time.tau=0.1", "time.monitor.center_x=center_x + 0.5*t", "time.end=0.3"});
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    for (const StepReport& step : time_steps(run)) {
        EXPECT_GT(*step.value(time_names::speed), 0.01) << *time_of(step);
        EXPECT_GT(step.step_size, 0);
    }
}

TEST_F(FollowingTest, AfterARestTheFactorStillHolds) {
    const std::vector<std::string> start{"time.monitor.center_x=center_x + 0.6*max(t - 0.2, 0)",
                                         "time.step=0.01", "time.end=0.26"};
    gaspard::Run run = make(start);
    auto strict = start;
    strict.emplace_back("time.rule=tolerance");
    gaspard::Run solved = make(strict);
    run.solve(), solved.solve();
    const auto steps = time_steps(run), best = time_steps(solved);
    for (std::size_t i = 0; i < steps.size(); ++i)
        EXPECT_LT(*steps[i].value("equidistribution"), 1.05 * *best[i].value("equidistribution")) << i;
}

TEST_F(FollowingTest, TheLastStepAfterAJumpIsSolved) {
    gaspard::Run run =
        make({"time.step=0.5", "time.end=1", "time.monitor.center_x=center_x + 0.3*(t > 0.7)"});
    gaspard::Run there(catalogue, scenario({"time.end=0", "monitor.center_x=0.8"}));
    run.solve(), there.solve();
    EXPECT_LT(*run.history().back().value("equidistribution"),
              1.05 * *there.history().back().value("equidistribution"));
}

TEST_F(FollowingTest, AStepThatExceedsTheFactorIsMadeAgain) {
    // The solved equidistribution grows, so that what was learnt is too little before it is due again.
    gaspard::Run run = make({"time.monitor.center_x=center_x + 0.1*t",
                             "time.monitor.amplitude=amplitude*(1 + 20*t)", "time.end=0.14"});
    run.solve();
    int solved = 0;
    for (const StepReport& step : time_steps(run)) solved += step.residual < 1e-8 ? 1 : 0;
    EXPECT_GT(solved, 1) << "not the first step alone";
    int made = 0; // with the attempts that did not suffice
    for (const StepReport& step : time_steps(run))
        made += static_cast<int>(*step.value(time_names::iterations));
    const StepReport& start =
        *std::ranges::find_if_not(run.history().rbegin(), run.history().rend(), is_time_step);
    EXPECT_EQ(run.history().back().all_iterations, start.iteration + made);
    EXPECT_EQ(time_steps(run).size(), 7u);
    for (std::size_t i = 1; i < run.history().size(); ++i)
        EXPECT_EQ(run.history()[i].iteration, run.history()[i - 1].iteration + 1);
}

TEST_F(FollowingTest, TheExactMeshMovesWithTheMonitor) {
    Scenario moving = find_scenario(*catalogue, "sphere-x4");
    apply_settings(*catalogue, moving,
                   {"domain.cells=6", "method.type=newton", "time.end=0.2", "time.step=0.02",
                    "method.diagnostics_every=1", "time.monitor.center_latitude=center_latitude - 100*t"});
    gaspard::Run run(catalogue, moving);
    run.solve();
    for (const StepReport& step : time_steps(run))
        EXPECT_LT(*step.value("exact_rms"), 0.02) << "at t = " << *time_of(step);
}

TEST_F(FollowingTest, AMeshThatIsTangledAtTheStartEndsTheRun) {
    gaspard::Run run =
        make({"domain.cells=12", "monitor.amplitude=300", "monitor.sharpness=200", "time.end=0.04"});
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::tangled);
    EXPECT_TRUE(time_steps(run).empty());
}

TEST_F(FollowingTest, AMonitorThatCannotBeMadeEndsTheRunAtTheTimeBefore) {
    Scenario moving = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, moving,
                   {"domain.cells=12", "method.type=newton", "monitor.type=formula", "time.end=0.2",
                    "monitor.expression=1 + (t > 0.11 ? log(x - 0.3) : 0)"});
    gaspard::Run run(catalogue, moving);
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::invalid_input);
    EXPECT_NE(run.history().back().note.find("formula"), std::string::npos) << run.history().back().note;
    EXPECT_NEAR(*run.time(), 0.1, 1e-9);
    EXPECT_EQ(run.history().back().tangled_cells, 0u) << "measured";
    EXPECT_EQ(time_of(run.history().back()), run.time());
    EXPECT_TRUE(is_time_step(run.history().back())) << "plots go on against t";
}

TEST_F(FollowingTest, WhatIsInTheWayBetweenTwoTimesEndsNothing) {
    // Two iterations do not suffice, so that steps are divided; the monitor has no values half-way.
    const auto ends = [&](const std::string& between) {
        Scenario moving = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, moving,
                       {"domain.cells=16", "method.type=newton", "monitor.type=formula", "time.end=0.4",
                        "time.step=0.1", "time.iterations=2",
                        "monitor.expression=1+30*exp(-200*((x-0.5-t)^2+(y-0.5)^2))" + between});
        gaspard::Run run(catalogue, moving);
        run.solve();
        EXPECT_NEAR(*run.time(), 0.4, 1e-12) << run.history().back().note;
        // What is reported is of the monitor at this time.
        Scenario still = moving;
        apply_settings(*catalogue, still, {"time.end=0", "monitor.t=0.4"});
        const gaspard::Run again(catalogue, still, {.start = run.state()});
        EXPECT_NEAR(again.history().front().residual, run.history().back().residual,
                    1e-12 + 1e-9 * run.history().back().residual);
        return run.status();
    };
    EXPECT_EQ(ends("+0*t"), RunStatus::converged) << "divided";
    EXPECT_NE(ends("+(t>0.11&&t<0.19?log(-1):0)"), RunStatus::invalid_input);
    EXPECT_NE(ends("+(t>0.301&&t<0.399?1e5*exp(-1e4*((x-0.25)^2+(y-0.5)^2)):0)"), RunStatus::invalid_input)
        << "no part is solved";
}

TEST_F(FollowingTest, ARunThatEndsEarlySaysWhatWasUnsolvedBefore) {
    Scenario moving = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, moving,
                   {"domain.cells=12", "method.type=newton", "monitor.type=formula", "time.end=0.2",
                    "time.rule=tolerance", "time.tolerance=1e-14", "time.iterations=1",
                    "monitor.expression=1 + 5*exp(-40*(x-0.5-t)^2) + (t > 0.07 ? log(-1) : 0)"});
    gaspard::Run run(catalogue, moving);
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::invalid_input);
    const std::string& note = run.history().back().note;
    EXPECT_NE(note.find("formula"), std::string::npos) << note;
    EXPECT_NE(note.find("3 time steps were not solved"), std::string::npos) << note;
}

TEST_F(FollowingTest, CountsTheIterationsOfAllAttempts) {
    gaspard::Run run = make({"time.step=0.5", "time.end=0.5", "time.iterations=18", "monitor.amplitude=40",
                             "time.rule=tolerance"});
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_GT(*time_steps(run).back().value(time_names::iterations), 18) << "it was divided";
}

TEST_F(FollowingTest, AStateBeginsAtTheStart) {
    gaspard::Run run = make();
    while (!run.moves()) run.step();
    const State first = run.state();
    while (run.time() < 0.1) run.step();
    run.start_from(first);
    EXPECT_EQ(run.time(), 0.0);
    EXPECT_EQ(run.status(), RunStatus::running);
    EXPECT_TRUE(run.moves()) << "it is solved already";
    run.step();
    EXPECT_NEAR(*run.time(), 0.02, 1e-12);
}

TEST_F(FollowingTest, SmallTimeScalesLagLess) {
    const auto last = [&](const std::string& tau) {
        gaspard::Run run = make({"time.rule=relaxation", "time.tau=" + tau});
        run.solve();
        EXPECT_EQ(run.status(), RunStatus::converged) << "all steps are made";
        return *run.history().back().value("equidistribution");
    };
    EXPECT_LT(last("0.005"), last("0.03"));
    EXPECT_LT(last("0.03"), last("0.2"));
}

TEST_F(FollowingTest, ReportsTheVelocityOfTheNodes) {
    gaspard::Run run = make();
    while (!run.moves()) run.step();
    run.step();
    const auto before = run.snapshot();
    run.step();
    const auto now = run.snapshot();
    const Field *speed = now->field("mesh_speed"), *x = now->field("mesh_velocity_x"),
                *y = now->field("mesh_velocity_y");
    ASSERT_TRUE(speed && x && y);
    EXPECT_EQ(now->field("mesh_velocity_z"), nullptr);
    double largest = 0;
    for (std::size_t i = 0; i < now->x.size(); ++i) {
        EXPECT_NEAR(x->values[i], (now->x.x[i] - before->x.x[i]) / 0.02, 1e-9);
        EXPECT_NEAR(speed->values[i], std::hypot(x->values[i], y->values[i]), 1e-12);
        largest = std::max(largest, speed->values[i]);
    }
    EXPECT_NEAR(*now->report.value(time_names::speed), largest, 1e-12);
    EXPECT_GT(largest, 0.3) << "about as fast as the ring";
}

TEST_F(FollowingTest, TheSameInputGivesTheSameBits) {
    gaspard::Run one = make(), other = make();
    one.solve(), other.solve();
    EXPECT_EQ(one.snapshot()->x, other.snapshot()->x);
    EXPECT_EQ(one.history().size(), other.history().size());
}

TEST_F(FollowingTest, UnsolvedStepsAreTold) {
    gaspard::Run run =
        make({"time.rule=tolerance", "time.tolerance=1e-12", "time.iterations=1", "method.type=relaxation"});
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::iteration_limit);
    EXPECT_NE(run.history().back().note.find("10 time steps were not solved"), std::string::npos)
        << run.history().back().note;
}

TEST_F(FollowingTest, AStepThatIsTooLongIsDivided) {
    // In one step across a quarter of the square; Newton's method does not follow from there.
    gaspard::Run run = make({"time.step=0.5", "time.end=0.5", "time.iterations=18", "monitor.amplitude=40",
                             "time.rule=tolerance"});
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    gaspard::Run there(catalogue, scenario({"time.end=0", "monitor.center_x=0.75", "monitor.amplitude=40"}));
    there.solve();
    EXPECT_LT(largest_distance(run.snapshot()->x, there.snapshot()->x), 1e-6);
}

TEST_F(FollowingTest, OtherValuesGoOnAtTheSameTime) {
    gaspard::Run run = make();
    while (run.time() < 0.1) run.step();
    run.change(scenario({"monitor.amplitude=6"}));
    EXPECT_NEAR(*run.time(), 0.1, 1e-12);
    EXPECT_EQ(run.history().size(), 1u);
    run.solve();
    EXPECT_EQ(run.time(), 0.2);
    EXPECT_EQ(time_steps(run).size(), 5u);
    run.change(scenario({"monitor.amplitude=6", "time.speed=3"})); // only for the window
    EXPECT_EQ(time_steps(run).size(), 5u);
    run.reset();
    EXPECT_EQ(run.time(), 0.0);
    run.change(scenario({"time.end=0"}));
    EXPECT_EQ(run.time(), std::nullopt);
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
}

TEST_F(FollowingTest, GoesOnFromATimeWithItsMap) {
    gaspard::Run run = make();
    while (run.time() < 0.1) run.step();
    const State there = run.state();
    const Points x = run.snapshot()->x;
    run.solve();
    run.go_on_from(there, 0.1);
    EXPECT_NEAR(*run.time(), 0.1, 1e-12);
    EXPECT_EQ(run.snapshot()->x, x);
    run.solve();
    EXPECT_EQ(run.time(), 0.2);
    EXPECT_EQ(run.status(), RunStatus::converged);
}

TEST_F(FollowingTest, StepsMayBeLeftOut) {
    gaspard::Run run = make({"time.rule=tolerance"});
    while (!run.moves()) run.step();
    run.step({}, 4);
    EXPECT_NEAR(*run.time(), 0.08, 1e-12);
    run.step({}, 100);
    EXPECT_EQ(run.time(), 0.2);
    EXPECT_EQ(run.status(), RunStatus::converged);
    gaspard::Run there(catalogue, scenario({"time.end=0", "monitor.center_x=0.6"}));
    there.solve();
    EXPECT_LT(largest_distance(run.snapshot()->x, there.snapshot()->x), 1e-7);
}

TEST_F(FollowingTest, AnInterruptedStepLeavesTheTimeBefore) {
    gaspard::Run run = make({"time.rule=tolerance"});
    while (!run.moves()) run.step();
    run.step();
    const Points x = run.snapshot()->x;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(run.step(stop.get_token()), Interrupted);
    EXPECT_NEAR(*run.time(), 0.02, 1e-12);
    EXPECT_EQ(run.snapshot()->x, x);
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
}

TEST_F(FollowingTest, AMotionWithoutTimeIsTold) {
    gaspard::Run run = make({"time.end=0"});
    const auto report = run.monitor_report();
    ASSERT_TRUE(report && report->notes.size() == 1);
    EXPECT_NE(report->notes[0].find("does not move"), std::string::npos);
    gaspard::Run moving = make();
    EXPECT_TRUE(moving.monitor_report()->notes.empty());
}

TEST_F(FollowingTest, TimeInWhichNothingMovesIsTold) {
    const auto notes = [&](const std::vector<std::string>& settings) {
        Scenario scenario = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, scenario, {"domain.cells=8"});
        apply_settings(*catalogue, scenario, settings);
        const auto report = gaspard::Run(catalogue, scenario).monitor_report();
        return report ? report->notes : std::vector<std::string>{};
    };
    ASSERT_EQ(notes({"time.end=1"}).size(), 1u);
    EXPECT_NE(notes({"time.end=1"})[0].find("Time passes, but the monitor does not move"), std::string::npos);
    ASSERT_EQ(notes({"time.end=-1"}).size(), 1u);
    EXPECT_NE(notes({"time.end=-1"})[0].find("time.end is before time.start"), std::string::npos);
    EXPECT_TRUE(notes({}).empty());
    EXPECT_TRUE(notes({"time.end=1", "monitor.type=formula", "monitor.expression=2 + x*sin(t)"}).empty());
}

TEST_F(FollowingTest, AMonitorOfTheCallerHasItsOwnTime) {
    gaspard::Run run = make();
    while (!run.moves()) run.step();
    run.follow(function_monitor([](Vec3) { return 1.0; }));
    EXPECT_EQ(run.time(), std::nullopt);
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    gaspard::Run still = make({"time.monitor.center_x="});
    EXPECT_EQ(still.monitor_report()->notes.size(), 1u) << "nothing moves";
    still.follow(function_monitor([](Vec3) { return 1.0; }));
    const auto report = still.monitor_report();
    EXPECT_TRUE(!report || report->notes.empty()) << "the caller moves it";
}

/// Maps that were not solved would be extrapolated ever farther.
TEST_F(FollowingTest, CountedIterationsDoNotLeadAway) {
    gaspard::Run run = make({"domain.cells=24", "time.end=0.6", "time.rule=iterations", "time.iterations=1",
                             "monitor.sharpness=200", "time.monitor.center_x=0.5 + 0.4*t"});
    run.solve();
    for (const StepReport& step : time_steps(run)) {
        EXPECT_LT(step.residual, 0.5) << *time_of(step);
        EXPECT_EQ(step.tangled_cells, 0u) << *time_of(step);
    }
    EXPECT_LT(time_steps(run).back().residual, 0.05);
}

/// Cells are as wide as the ring, and there are too few iterations for most time steps. Without a new
/// beginning residuals grow beyond 1000.
TEST_F(FollowingTest, AStepThatIsWorseThanTheUniformMeshBeginsThere) {
    const std::vector<std::string> ring{"domain.cells=9", "time.end=1.5",
                                        "time.monitor.center_x=center_x + t",
                                        "method.diagnostics_every=1000"};
    for (const std::vector<std::string>& hard :
         {std::vector<std::string>{"time.step=0.01", "time.iterations=1", "time.rule=iterations",
                                   "monitor.sharpness=200", "monitor.amplitude=10"},
          {"time.step=0.03", "time.iterations=3", "monitor.sharpness=800", "monitor.amplitude=40"}}) {
        std::vector<std::string> settings = ring;
        settings.insert(settings.end(), hard.begin(), hard.end());
        gaspard::Run run = make(settings);
        run.solve();
        for (const StepReport& step : time_steps(run)) EXPECT_LT(step.residual, 5) << *time_of(step);
    }
}

} // namespace
} // namespace gaspard
