#include "core/scenario/view_rows.hpp"
#include "core/tessellate/interval_plots.hpp"
#include "core/tessellate/plot_axis.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {
namespace {

/// Nodes at `x` in [0, 1], with a solution and that of the uniform mesh.
Snapshot snapshot_at(std::vector<double> x) {
    const std::size_t n = x.size() - 1;
    Mesh mesh{.kind = {CellShape::line, 1}, .space_dimension = 1, .nodes = Points(n + 1), .cells = {}};
    for (std::size_t i = 0; i <= n; ++i) mesh.nodes.x[i] = static_cast<double>(i) / static_cast<double>(n);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(n); ++i)
        mesh.cells.insert(mesh.cells.end(), {i, i + 1});
    Snapshot snapshot;
    Field here{{.name = "solution", .label = "Solution", .centre = 0}, {}},
        uniform{{.name = "solution_uniform"}, {}};
    for (std::size_t i = 0; i <= n; ++i) {
        here.values.push_back(2.0 * static_cast<double>(i));
        uniform.values.push_back(-1.0 * static_cast<double>(i));
    }
    snapshot.fields = {here, uniform};
    snapshot.x = Points(n + 1);
    snapshot.x.x = std::move(x);
    snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
    return snapshot;
}

const std::vector<double> both_layers{0, 1e-12, 3e-12, 0.5, 1 - 0x1p-39, 1 - 0x1p-40, 1};

Values view_with(const std::vector<std::pair<std::string, std::string>>& settings) {
    Values view("view", view_rows(std::vector<FieldInfo>{{.name = "solution"}}, "solution"));
    for (const auto& [key, text] : settings) view.parse(key, text);
    return view;
}

using Ordinates = std::vector<double>;

TEST(IntervalPlots, ShowTheSolutionOnBothMeshesAndTheirNodes) {
    const auto columns = interval_plots(snapshot_at(both_layers), view_with({}));
    ASSERT_EQ(columns.size(), 1U);
    const Plot& plot = columns[0].values;
    ASSERT_EQ(plot.curves.size(), 2U);
    EXPECT_EQ(plot.curves[0].label, "adapted mesh");
    EXPECT_EQ(plot.curves[0].x, both_layers);
    EXPECT_EQ(plot.curves[0].y, (Ordinates{0, 2, 4, 6, 8, 10, 12}));
    EXPECT_TRUE(plot.curves[0].markers);
    EXPECT_EQ(plot.curves[1].label, "uniform mesh");
    EXPECT_EQ(plot.curves[1].x[3], 0.5);
    EXPECT_EQ(plot.curves[1].y, (Ordinates{0, -1, -2, -3, -4, -5, -6}));
    EXPECT_TRUE(plot.curves[1].behind);
    EXPECT_EQ(plot.y.label, "Solution");
    ASSERT_EQ(plot.rows.size(), 2U);
    EXPECT_EQ(plot.rows[0].x, both_layers);
    EXPECT_EQ(plot.rows[1].x, plot.curves[1].x);
    EXPECT_TRUE(
        interval_plots(snapshot_at(both_layers), view_with({{"lines", "false"}}))[0].values.rows.empty());
}

TEST(IntervalPlots, ShowTheWidthsOfCellsAtTheirMiddles) {
    const Plot spacing = interval_plots(snapshot_at(both_layers), view_with({}))[0].spacing;
    ASSERT_EQ(spacing.curves.size(), 2U);
    EXPECT_TRUE(spacing.y.logarithmic);
    EXPECT_EQ(spacing.curves[0].x[0], 5e-13);
    EXPECT_EQ(spacing.curves[0].y[0], 1e-12);
    EXPECT_EQ(spacing.curves[0].y[1], 3e-12 - 1e-12);
    EXPECT_EQ(spacing.curves[0].y[4], 0x1p-40);
    EXPECT_EQ(spacing.curves[0].y[5], 0x1p-40);
    EXPECT_EQ(spacing.curves[1].x.front(), 0);
    EXPECT_EQ(spacing.curves[1].x.back(), 1);
    for (const double width : spacing.curves[1].y) EXPECT_NEAR(width, 1.0 / 6, 1e-15);
}

TEST(IntervalPlots, DistancesFromTheLeftEndAreExact) {
    const Plot plot = interval_plots(snapshot_at(both_layers), view_with({{"x_axis", "log-left"}}))[0].values;
    EXPECT_TRUE(plot.x.logarithmic);
    EXPECT_FALSE(plot.x.reversed);
    EXPECT_EQ(plot.curves[0].x, both_layers);
    EXPECT_NEAR(to_axis(plot.x, plot.curves[0].x[1]), -12, 1e-14);
    EXPECT_LT(*plot.x.low, 1e-12);
    EXPECT_GT(*plot.x.low, 1e-13) << "the axis begins at the first node beside the end";
}

TEST(IntervalPlots, DistancesFromTheRightEndAreExact) {
    const auto columns = interval_plots(snapshot_at(both_layers), view_with({{"x_axis", "log-right"}}));
    const Plot& plot = columns[0].values;
    EXPECT_TRUE(plot.x.reversed);
    EXPECT_EQ(plot.curves[0].x, (Ordinates{0, 0x1p-40, 0x1p-39, 0.5, 1 - 3e-12, 1 - 1e-12, 1}))
        << "in the order of distances";
    EXPECT_EQ(plot.curves[0].y, (Ordinates{12, 10, 8, 6, 4, 2, 0}));
    EXPECT_EQ(columns[0].spacing.curves[0].x[0], 0x1p-41);
    EXPECT_EQ(columns[0].spacing.curves[0].y[0], 0x1p-40);
    const auto ticks = axis_ticks(plot.x, asked_range(plot.x, {-12, 0}), 5);
    EXPECT_EQ(ticks.back().label, "1 − 10⁰");
    EXPECT_LT(fraction_of(plot.x, {-12, 0}, to_axis(plot.x, 0.5)), 0.1) << "the end is at the right";
    EXPECT_NEAR(fraction_of(plot.x, {-12, 0}, to_axis(plot.x, 1e-12)), 1, 1e-14);
}

TEST(IntervalPlots, BlendMovesNodesFromTheUniformMesh) {
    const Snapshot snapshot = snapshot_at(both_layers);
    const auto nodes = [&](const char* t) {
        return interval_plots(snapshot, view_with({{"blend", t}}))[0].values.curves[0].x;
    };
    EXPECT_EQ(nodes("0"), snapshot.mesh->nodes.x);
    EXPECT_EQ(nodes("1"), snapshot.x.x);
    EXPECT_NEAR(nodes("0.25")[1], 0.75 / 6 + 0.25e-12, 1e-16);
}

TEST(IntervalPlots, SideBySideShowsTheSameValuesOverXi) {
    const Snapshot snapshot = snapshot_at(both_layers);
    const auto columns = interval_plots(snapshot, view_with({{"layout", "side-by-side"}}));
    ASSERT_EQ(columns.size(), 2U);
    EXPECT_EQ(columns[0].values.title, "physical");
    EXPECT_EQ(columns[1].values.title, "computational");
    ASSERT_EQ(columns[1].values.curves.size(), 1U);
    EXPECT_EQ(columns[1].values.curves[0].x, snapshot.mesh->nodes.x);
    EXPECT_EQ(columns[1].values.curves[0].y, columns[0].values.curves[0].y);
    EXPECT_EQ(columns[1].spacing.curves[0].y, columns[0].spacing.curves[0].y);
}

TEST(IntervalPlots, WithoutASolutionTheMapIsShown) {
    Snapshot snapshot = snapshot_at(both_layers);
    snapshot.fields.clear();
    const auto columns = interval_plots(snapshot, view_with({}));
    ASSERT_EQ(columns.size(), 1U);
    EXPECT_EQ(columns[0].values.x.label, "ξ");
    EXPECT_EQ(columns[0].values.curves[0].x, snapshot.mesh->nodes.x);
    EXPECT_EQ(columns[0].values.curves[0].y, snapshot.x.x);
    const auto right = interval_plots(snapshot, view_with({{"x_axis", "log-right"}}))[0].values;
    EXPECT_TRUE(right.y.reversed && right.y.logarithmic);
    EXPECT_EQ(right.curves[0].y[5], 0x1p-40);
}

TEST(IntervalPlots, ComponentsAreToldApart) {
    Snapshot snapshot = snapshot_at({0, 0.25, 1});
    snapshot.fields.push_back({{.name = "solution_2"}, {3, 4, 5}});
    snapshot.fields.push_back({{.name = "solution_2_uniform"}, {6, 7, 8}});
    const Plot plot = interval_plots(snapshot, view_with({}))[0].values;
    std::vector<std::string> labels;
    for (const Curve& curve : plot.curves) labels.push_back(curve.label);
    EXPECT_EQ(labels, (std::vector<std::string>{"component 1, adapted mesh", "component 2, adapted mesh",
                                                "component 1, uniform mesh", "component 2, uniform mesh"}));
    EXPECT_EQ(plot.curves[1].y, (Ordinates{3, 4, 5}));
    EXPECT_EQ(plot.curves[3].y, (Ordinates{6, 7, 8}));
}

TEST(IntervalPlots, WildOscillationsOnTheUniformMeshLeaveTheOtherVisible) {
    Snapshot snapshot = snapshot_at({0, 0.25, 1}); // the solution is 0, 2, 4
    snapshot.fields[1].values = {0, 7.5, 0};
    EXPECT_FALSE(interval_plots(snapshot, view_with({}))[0].values.y.high) << "all is shown";
    snapshot.fields[1].values = {0, 1e5, -1};
    const Axis y = interval_plots(snapshot, view_with({}))[0].values.y;
    EXPECT_EQ(y.high, 8) << "the span of the solution more than it needs";
    EXPECT_NEAR(*y.low, -1.2, 1e-12) << "and as far down as anything reaches";
    const auto fixed = view_with({{"range", "fixed"}, {"low", "-3"}, {"high", "1e6"}});
    EXPECT_EQ(interval_plots(snapshot, fixed)[0].values.y.high, 1e6);
}

TEST(IntervalPlots, FieldsOfCellsAreAtTheirMiddles) {
    const Plot plot = interval_plots(snapshot_at({0, 0.25, 1}), view_with({{"color", "area"}}))[0].values;
    ASSERT_EQ(plot.curves.size(), 1U);
    EXPECT_EQ(plot.curves[0].x, (Ordinates{0.125, 0.625}));
    ASSERT_EQ(plot.curves[0].y.size(), 2U);
    EXPECT_NEAR(plot.curves[0].y[0], 0.25, 1e-15);
    EXPECT_NEAR(plot.curves[0].y[1], 0.75, 1e-15);
}

TEST(IntervalPlots, MeshesThatHaveFailedAreShownAsFarAsTheyAreThere) {
    for (const double wrong : {std::nan(""), HUGE_VAL, -1e300, 0.9}) {
        Snapshot snapshot = snapshot_at({0, 0.25, 0.5, 1});
        snapshot.x.x[1] = wrong;
        for (const char* axis : {"linear", "log-left", "log-right"})
            for (const char* layout : {"single", "side-by-side"})
                EXPECT_FALSE(
                    interval_plots(snapshot, view_with({{"x_axis", axis}, {"layout", layout}})).empty());
    }
}

TEST(PlotAxis, LinesBetweenPointsBendOnLogarithmicAxes) {
    const Axis x{.label = "x", .logarithmic = true};
    const auto places = bends_between(x, {-12, 0}, 0, 1, 0.5);
    ASSERT_EQ(places.size(), 24U) << "from the axis' end, for a point at zero lies beyond it";
    EXPECT_EQ(places.front(), -12);
    EXPECT_EQ(places.back(), -0.5);
    EXPECT_EQ(value_between(1e-12, 0, 0, 1, 5), 5e-12);
    EXPECT_TRUE(bends_between(x, {-12, 0}, 1, 10, 0.5).empty()) << "out of sight";
    EXPECT_TRUE(bends_between({"x"}, {0, 1}, 0.5, 0.4, 0.5).empty()) << "backwards";
}

TEST(PlotAxis, DistancesAreLabelledAsPlaces) {
    const auto labels = [](const char* before, AxisRange range) {
        const Axis axis{.label = "x", .logarithmic = true, .low = {}, .high = {}, .before = before};
        std::vector<std::string> found;
        for (const Tick& tick : axis_ticks(axis, range, 3))
            if (!tick.label.empty()) found.push_back(tick.label);
        return found;
    };
    using Labels = std::vector<std::string>;
    EXPECT_EQ(labels("1 − ", {-9, -8}), (Labels{"1 − 10⁻⁹", "1 − 10⁻⁸"}));
    const AxisRange narrow{std::log10(2), std::log10(2 + 2.1e-10)};
    EXPECT_EQ(labels("", narrow), (Labels{"2", "+10⁻¹⁰", "+2×10⁻¹⁰"}));
    EXPECT_EQ(labels("5 + ", narrow), (Labels{"5 + 2", "+10⁻¹⁰", "+2×10⁻¹⁰"}));
    EXPECT_EQ(labels("5 − ", narrow), (Labels{"5 − 2", "−10⁻¹⁰", "−2×10⁻¹⁰"}));
}

TEST(PlotAxis, LabelsBesideEachOtherDoNotTouch) {
    const auto width = [](const std::string& label) { return 8.0 * static_cast<double>(label.size()); };
    const Axis x{.label = "x"};
    EXPECT_EQ(fitting_ticks(x, {0, 1}, 10, 400, width).size(), axis_ticks(x, {0, 1}, 10).size());
    EXPECT_LT(fitting_ticks(x, {0, 1}, 10, 150, width).size(), axis_ticks(x, {0, 1}, 10).size());
}

TEST(PlotAxis, LabelsThatTouchAreLeftOutWhereTicksCannotBeFewer) {
    const auto height = [](const std::string&) { return 13.0; };
    for (const bool logarithmic : {false, true})
        for (const auto& [low, high] : {std::pair(0.52, 0.68), {0.2, 0.4}, {1.0, 10.0}})
            for (const double length : {9.0, 20.0, 31.0, 50.0}) {
                const Axis y{.label = "y", .logarithmic = logarithmic};
                const AxisRange range{to_axis(y, low), to_axis(y, high)};
                double last = -1e9;
                int labels = 0;
                for (const Tick& tick : fitting_ticks(y, range, 3, length, height)) {
                    if (tick.label.empty()) continue;
                    const double at = fraction_of(y, range, to_axis(y, tick.value)) * length;
                    EXPECT_GE(at - last, 13) << tick.label << " on " << length;
                    last = at, ++labels;
                }
                EXPECT_GE(labels, 1) << length;
            }
}

TEST(PlotAxis, CountsAreWholeAndNotNegative) {
    for (const bool logarithmic : {false, true})
        for (const AxisRange range : {AxisRange{0, 3}, AxisRange{-2, 5}, AxisRange{0.2, 2.9},
                                      AxisRange{0, 27}, AxisRange{3.1, 3.4}, AxisRange{-0.5, 0.5}})
            for (const int count : {1, 3, 8, 20})
                for (const Tick& tick : axis_ticks(
                         {.label = "iteration", .logarithmic = logarithmic, .whole = true}, range, count)) {
                    EXPECT_EQ(tick.value, std::round(tick.value)) << tick.label;
                    EXPECT_GE(tick.value, 0);
                    EXPECT_EQ(tick.label.find('.'), std::string::npos) << tick.label;
                }
    const Axis iterations{.label = "iteration", .whole = true};
    const auto ticks = axis_ticks(iterations, {0, 3}, 8);
    ASSERT_EQ(ticks.size(), 4U);
    EXPECT_EQ(ticks[3].label, "3");
    EXPECT_EQ(range_of_counts(iterations, {-0.5, 0.5}), (AxisRange{0, 1}));
    EXPECT_EQ(range_of_counts(iterations, {4.75, 5.25}), (AxisRange{4, 6}));
    EXPECT_EQ(range_of_counts({.label = "x"}, {-0.5, 0.5}), (AxisRange{-0.5, 0.5}));
}

} // namespace
} // namespace gaspard
