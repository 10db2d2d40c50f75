#include "core/base/error.hpp"
#include "core/method/driven.hpp"
#include "support/largest_distance.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(Accelerated, FindsTheMapOfTheRelaxationInFewerIterations) {
    struct Case {
        const char* monitor;
        bool periodic;
        int most; ///< iterations on all planes
    };
    for (const auto& [type, periodic, most] :
         {Case{"ring", true, 60}, {"bell", true, 100}, {"ring", false, 60}, {"bell", false, 100}}) {
        SCOPED_TRACE(std::string(type) + (periodic ? ", periodic" : ", walls"));
        const auto monitor = monitor_of(type, periodic);
        Driven accelerated(accelerated_method(), 60, periodic), relaxed(relaxation_method(), 60, periodic);
        accelerated.begin(monitor);
        relaxed.begin(monitor);
        const int iterations = accelerated.solve();
        EXPECT_LE(iterations, most);
        EXPECT_LT(2 * iterations, relaxed.solve());
        EXPECT_LT(largest_distance(accelerated.method->positions(), relaxed.method->positions()), 1e-8);
        EXPECT_NEAR(accelerated.history.back().series[0], relaxed.history.back().series[0], 1e-8);
        EXPECT_EQ(accelerated.state.layout, accelerated.layout(60));
        EXPECT_EQ(accelerated.quality().tangled_cells, 0u);
    }
}

TEST(Accelerated, GoesOverCoarserPlanesAndShowsTheFinestMesh) {
    Driven run(accelerated_method(), 120, true);
    run.begin(monitor_of("ring", true));
    std::vector<std::string> layouts;
    run.each = [&] {
        if (layouts.empty() || layouts.back() != run.state.layout) layouts.push_back(run.state.layout);
        ASSERT_EQ(run.method->positions().size(), 121u * 121u);
        EXPECT_EQ(run.quality().tangled_cells, 0u) << run.history.size();
        EXPECT_GT(run.history.back().step_size, 0);
    };
    run.solve();
    EXPECT_EQ(layouts, (std::vector{run.layout(30), run.layout(60), run.layout(120)}));
}

TEST(Accelerated, DoesNotCallACoarserPlanesResidualItsOwn) {
    // Whatever tolerance a run has, an iterate below it is one of the plane that was asked for.
    for (const double tolerance : {0.5, 0.1, 1e-2}) {
        Driven run(accelerated_method(), 120, true);
        Values values("method", common_method_rows());
        values.set("tolerance", tolerance);
        run.method->configure(values);
        run.begin(monitor_of("ring", true));
        run.solve(tolerance);
        EXPECT_EQ(run.state.layout, run.layout(120)) << tolerance;
    }
}

TEST(Accelerated, FollowsAMonitorThatMovesALittleWhereItIs) {
    Driven run(accelerated_method(), 60, true);
    run.begin(monitor_of("ring", true));
    const int from_nothing = run.solve();
    run.begin(monitor_of("ring", true, {{"center_x", 0.505}}));
    run.each = [&] { EXPECT_EQ(run.state.layout, run.layout(60)); };
    EXPECT_LT(run.solve(), from_nothing);
}

TEST(Accelerated, ConvergesWhereCoarserPlanesAreOfNoUse) {
    // A ring that 30 x 30 cells cannot resolve.
    Driven run(accelerated_method(), 60, true);
    run.begin(monitor_of("ring", true, {{"amplitude", 50}, {"sharpness", 400}}));
    run.solve();
    EXPECT_EQ(run.quality().tangled_cells, 0u);
}

TEST(Accelerated, GoesOnFromTheMiddleOfTheWay) {
    Driven run(accelerated_method(), 60, true);
    run.begin(monitor_of("ring", true));
    for (int i = 0; i < 5; ++i) run.method->step(problem_of(*run.monitor), run.state, {});
    ASSERT_EQ(run.state.layout, run.layout(30));
    Driven other(accelerated_method(), 60, true);
    other.state = *other.method->adopt(run.state, nullptr);
    EXPECT_EQ(other.state.layout, run.layout(30));
    other.begin(run.monitor);
    auto plane = PlaneQ2({60, true}); // its residual is that of the finest plane
    PlaneQ2 from({30, true});
    auto workspace = plane.make_workspace(), from_workspace = from.make_workspace();
    const auto phi = plane.transfer(from, run.state.arrays[0].values, from_workspace, workspace);
    const auto relaxation = make_relaxation(other.plane, 0.1);
    const Evaluation fine =
        relaxation->evaluate(problem_of(*run.monitor), State{other.layout(60), {{"phi", phi}}}, {});
    EXPECT_NEAR(other.history[0].residual, fine.residual, 1e-12);
    EXPECT_LT(largest_distance(other.method->positions(), relaxation->positions()), 1e-14);
    other.solve();
    EXPECT_EQ(other.state.layout, run.layout(60));
}

TEST(Accelerated, AdoptsWhatTheRelaxationHasFound) {
    Driven coarse(relaxation_method(), 40, true), fine(accelerated_method(), 60, true);
    coarse.begin(monitor_of("ring", true));
    coarse.solve();
    fine.state = *fine.method->adopt(coarse.state, nullptr);
    EXPECT_EQ(fine.state.layout, fine.layout(60));
    fine.begin(coarse.monitor);
    EXPECT_LT(fine.history[0].residual, 0.3);
    fine.each = [&] { EXPECT_EQ(fine.state.layout, fine.layout(60)); };
    fine.solve();
    EXPECT_FALSE(fine.method->adopt({"sphere", {}}, nullptr).has_value());
    EXPECT_FALSE(fine.method->adopt({fine.layout(30), {{"phi", {1, 2}}}}, nullptr).has_value());
}

TEST(Accelerated, MovesNothingForAConstantMonitor) {
    Driven run(accelerated_method(), 60, false);
    run.begin(monitor_of("constant", false));
    for (int i = 0; i < 5; ++i) run.method->step(problem_of(*run.monitor), run.state, {});
    EXPECT_LT(largest_distance(run.method->positions(), run.plane->mesh()->nodes), 1e-13);
}

TEST(Accelerated, ChecksThatStatesAreItsOwn) {
    Driven run(accelerated_method(), 60, true);
    run.begin(monitor_of("ring", true));
    State other = Driven(relaxation_method(), 16, true).state;
    EXPECT_THROW(run.method->evaluate(problem_of(*run.monitor), other, {}), InternalError);
    EXPECT_THROW(run.method->step(problem_of(*run.monitor), other, {}), InternalError);
}

} // namespace
} // namespace gaspard
