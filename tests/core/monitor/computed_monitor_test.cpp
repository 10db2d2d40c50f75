// Monitors that are computed, at any time: of a flow, and of Burgers' equation.
#include "core/base/error.hpp"
#include "core/flow/burgers_history.hpp"
#include "core/flow/flow_history.hpp"
#include "core/flow/flow_starts.hpp"
#include "core/function/source.hpp"
#include "core/monitor/field_monitor.hpp"
#include "support/monitor_defaults.hpp"
#include "support/monitor_values.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

const Space flow_space{SpaceKind::periodic_square};
const Space burgers_space{.kind = SpaceKind::euclidean, .dimension = 1};

Values flow_values(double t) {
    Values values = default_values(monitor_type("flow"), flow_space);
    values.set("cells", std::int64_t{32}), values.set("radius", 0.1), values.set("t", t);
    return values;
}

Points some_points(const Space& space) {
    Points x(40);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double s = static_cast<double>(i);
        x.set(i, {std::fmod(0.377 * s, 1), space.dimension == 1 ? 0 : std::fmod(0.631 * s, 1), 0});
    }
    return x;
}

TEST(FlowMonitor, IsThatOfTheFieldOfAFlowAtItsTime) {
    const double t = 0.37;
    std::vector<double> start = vortex_values(32, scattered_vortices(6, 1), 0.1);
    for (double& q : start) q *= 20;
    GridData data{Coordinates::cartesian, {}, flow_history({.cells = 32}, start)->at(t)};
    for (int i = 0; i < 32; ++i) data.axes[0].push_back(i / 32.0);
    data.axes[1] = data.axes[0];
    const std::vector<double> q = data.values;
    const DataContext context{.space = flow_space};
    const auto expected = field_monitor(
        {"q", {}, std::move(data)}, {.field = {.transform = FieldTransform::absolute, .blur = 1}}, context);
    const auto monitor = monitor_type("flow").make(flow_values(t), context);
    const Points x = some_points(flow_space);
    EXPECT_EQ(values_of(*monitor, x), values_of(*expected, x));
    EXPECT_NE(values_of(*monitor, x), values_of(*monitor_type("flow").make(flow_values(0), context), x));
    Points nodes(32);
    for (std::size_t i = 0; i < 32; ++i) nodes.set(i, {static_cast<double>(i) / 32, 5.0 / 32, 0});
    const auto fields = monitor->fields(nodes);
    ASSERT_EQ(fields.size(), 1u);
    EXPECT_EQ(fields[0].name, "q");
    for (std::size_t i = 0; i < 32; ++i) EXPECT_NEAR(fields[0].values[i], q[5 * 32 + i], 1e-2);
}

TEST(FlowMonitor, DoesNotDependOnWhatWasAskedForBefore) {
    const DataContext fresh{.space = flow_space};
    DataContext kept = fresh;
    kept.files = std::make_shared<FileCache>();
    const Points x = some_points(flow_space);
    const MonitorType type = monitor_type("flow");
    for (const double t : {0.9, 0.1, 0.0, 0.55, 0.9})
        EXPECT_EQ(values_of(*type.make(flow_values(t), kept), x),
                  values_of(*type.make(flow_values(t), fresh), x));
    Values other = flow_values(0.55);
    other.set("seed", std::int64_t{2});
    EXPECT_EQ(values_of(*type.make(other, kept), x), values_of(*type.make(other, fresh), x))
        << "a flow of its own";
}

TEST(FlowMonitor, StopsAndReportsProgress) {
    DataContext context{.space = flow_space};
    std::vector<std::string> texts;
    context.progress = [&](double, std::string_view text) { texts.emplace_back(text); };
    monitor_type("flow").make(flow_values(1), context);
    EXPECT_NE(std::find(texts.begin(), texts.end(), "Computing the flow"), texts.end());
    std::stop_source stop;
    stop.request_stop();
    context.stop = stop.get_token();
    EXPECT_THROW(monitor_type("flow").make(flow_values(1000), context), Interrupted);
}

TEST(FlowSource, IsForThePeriodicPlane) {
    EXPECT_TRUE(is_offered(source_type("flow"), flow_space));
    EXPECT_FALSE(is_offered(source_type("flow"), Space{}));
    EXPECT_FALSE(is_offered(source_type("flow"), Space{SpaceKind::sphere}));
    EXPECT_FALSE(is_offered(source_type("image"), Space{.dimension = 3, .solid = true}));
    EXPECT_TRUE(is_offered(source_type("formula"), Space{.dimension = 3, .solid = true}));
    const auto choices = [](const Space& space) {
        return monitor_type("derived").rows(space).front().choices;
    };
    EXPECT_EQ(std::ranges::count(choices(flow_space), "flow"), 1);
    EXPECT_EQ(std::ranges::count(choices(Space{}), "flow"), 0);
}

TEST(FlowSource, HasTheValuesOfQ) {
    Values values(
        "monitor.u",
        all_rows(source_type("flow"), Values("monitor.u", source_type("flow").rows(flow_space)), flow_space));
    values.set("cells", std::int64_t{32}), values.set("radius", 0.1);
    const auto u = source_type("flow").make(values, {.space = flow_space}).function;
    const auto vortices = scattered_vortices(6, 1);
    Points centre(1);
    centre.set(0, {vortices[1].centre[0], vortices[1].centre[1], 0});
    double value = 0;
    u->values(centre, {&value, 1});
    EXPECT_NEAR(value, 20 * vortices[1].strength, 1.5);
    EXPECT_LT(value, -10);
}

TEST(BurgersMonitor, IsTheArcLengthOfTheSolution) {
    const MonitorType type = monitor_type("burgers");
    Values values = default_values(type, burgers_space);
    values.set("t", 0.5), values.set("nu", 0.02), values.set("alpha", 2.0);
    const auto monitor = type.make(values, {.space = burgers_space});
    const BurgersData exact = burgers_front(0.02, 0.2);
    const Points x = some_points(burgers_space);
    const auto m = values_of(*monitor, x);
    const auto u = monitor->fields(x);
    ASSERT_EQ(u.size(), 1u);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double h = 1e-5, slope = (exact(x.x[i] + h, 0.5) - exact(x.x[i] - h, 0.5)) / (2 * h);
        EXPECT_NEAR(u[0].values[i], exact(x.x[i], 0.5), 1e-4);
        EXPECT_NEAR(m[i], std::hypot(1, 2 * slope), 0.02);
    }
    EXPECT_GT(*std::max_element(m.begin(), m.end()), 5);
    Points gradients;
    monitor->gradients(x, gradients);
    for (std::size_t i = 0; i < x.size(); ++i) {
        Points beside(2);
        beside.set(0, {x.x[i] - 1e-7, 0, 0}), beside.set(1, {x.x[i] + 1e-7, 0, 0});
        const auto ends = values_of(*monitor, beside);
        if (x.x[i] > 0 && x.x[i] < 1) {
            EXPECT_NEAR(gradients.x[i], (ends[1] - ends[0]) / 2e-7, 1e-2 * (1 + std::abs(gradients.x[i])));
        }
    }
}

} // namespace
} // namespace gaspard
