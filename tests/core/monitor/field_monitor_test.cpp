#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/read_data_file.hpp"
#include "core/base/read_file.hpp"
#include "core/data/field_file.hpp"
#include "core/flow/flow_options.hpp"
#include "core/io/formats.hpp"
#include "core/monitor/field_monitor.hpp"
#include "support/sample_snapshot.hpp"
#include "support/solved_run.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

const DataContext walls{.space = {SpaceKind::euclidean}};

/// v = x on the unit square.
FieldData slope(double factor = 1) {
    GridData data{Coordinates::cartesian, {}, {}};
    for (int i = 0; i <= 20; ++i) data.axes[0].push_back(i / 20.0);
    data.axes[1] = data.axes[0];
    for (int j = 0; j <= 20; ++j)
        for (int i = 0; i <= 20; ++i) data.values.push_back(factor * i / 20.0);
    return {"v", {"v", "w"}, std::move(data)};
}

double at(const Monitor& monitor, Vec3 x) {
    Points p(1);
    p.set(0, x);
    double value = 0;
    monitor.values(p, {&value, 1});
    return value;
}

TEST(FieldMonitor, ScalesFromLowToHigh) {
    const auto monitor = field_monitor(slope(7), {.contrast = 30}, walls);
    EXPECT_NEAR(at(*monitor, {0.5, 0.5, 0}), 1 + 29 * 0.5, 0.01);
    EXPECT_LT(at(*monitor, {0, 0.5, 0}), 2);
    EXPECT_GT(at(*monitor, {1, 0.5, 0}), 29);
    const auto inverse = field_monitor(slope(7), {.contrast = 30, .invert = true}, walls);
    EXPECT_GT(at(*inverse, {0, 0.5, 0}), 29);
    const auto squared = field_monitor(slope(7), {.contrast = 30, .gamma = 2}, walls);
    EXPECT_NEAR(at(*squared, {0.5, 0.5, 0}), 1 + 29 * 0.25, 0.1);
    const MonitorReport report = monitor->report();
    EXPECT_EQ(report.choices.at("variable"), (std::vector<std::string>{"v", "w"}));
    ASSERT_FALSE(report.notes.empty());
    EXPECT_TRUE(report.notes[0].starts_with("On the domain the field is between 0.0")) << report.notes[0];
}

TEST(FieldMonitor, TakesTheValuesAsTheyAre) {
    const auto monitor = field_monitor(slope(), {.scaled = false, .floor = 0.25}, walls);
    EXPECT_NEAR(at(*monitor, {0.7, 0.5, 0}), 0.7, 0.005);
    EXPECT_NEAR(at(*monitor, {0.05, 0.5, 0}), 0.25, 0.005);
    EXPECT_THROW(field_monitor(slope(-1), {.scaled = false}, walls), InputError);
    const auto constant = field_monitor(slope(0), {}, walls);
    EXPECT_EQ(constant->report().notes[0], "The field is constant on the domain, and the monitor is too.");
    EXPECT_NEAR(at(*constant, {0.3, 0.5, 0}), 1, 1e-12);
}

TEST(FieldMonitor, HasTheGradientsOfItsValues) {
    const auto monitor = field_monitor(slope(), {.contrast = 10}, walls);
    Points x(1), gradient;
    x.set(0, {0.4, 0.6, 0});
    monitor->gradients(x, gradient);
    const double h = 1e-5;
    EXPECT_NEAR(gradient.x[0], (at(*monitor, {0.4 + h, 0.6, 0}) - at(*monitor, {0.4 - h, 0.6, 0})) / (2 * h),
                1e-5);
}

TEST(FieldMonitor, ReadsWhatGaspardWrites) {
    const TemporaryFolder folder;
    const Snapshot snapshot = sample_snapshot(unit_square_mesh(3));
    write_vtu(folder / "adapted.vtu", snapshot);
    const FieldData vtu = parse_field(read_file(folder / "adapted.vtu"), "it", {.variable = "monitor"});
    const auto& points = std::get<ScatteredData>(vtu.data);
    EXPECT_EQ(points.values, snapshot.fields[0].values);
    EXPECT_EQ(points.points.x, snapshot.x.x);
    EXPECT_NE(std::find(vtu.variables.begin(), vtu.variables.end(), "jacobian"), vtu.variables.end());
    write_ugrid(folder / "adapted.ugrid.nc", snapshot, snapshot.x, "a mesh");
    const FieldData ugrid =
        parse_field(read_file(folder / "adapted.ugrid.nc"), "it", {.variable = "monitor"});
    const auto& corners = std::get<ScatteredData>(ugrid.data);
    ASSERT_FALSE(corners.values.empty());
    for (std::size_t p = 0; p < corners.values.size(); ++p)
        EXPECT_NEAR(corners.values[p], 2 + std::sin(5 * corners.points.x[p] + corners.points.y[p]), 1e-12);
}

/// On [-1, 1]^2.
FieldData paraboloid() {
    GridData data{Coordinates::cartesian, {}, {}};
    for (int i = 0; i <= 40; ++i) data.axes[0].push_back(i / 20.0 - 1);
    data.axes[1] = data.axes[0];
    for (const double y : data.axes[1])
        for (const double x : data.axes[0]) data.values.push_back(x * x + y * y);
    return {"v", {"v"}, std::move(data)};
}

// The corners of the square, where the field is 2, are not on the disk.
TEST(FieldMonitor, TakesItsRangeFromThePatchAlone) {
    const gaspard::Run run = solved_run("spline-two-circles", {"domain.cells=32", "method.max_iterations=1"});
    const DataContext disk{.space = run.space(), .discretisation = &run.discretisation()};
    const double sigma_square = std::numbers::pi / (32 * 32); // of a blur over one cell
    const auto scaled = field_monitor(paraboloid(), {.field = {.blur = 1}, .contrast = 5}, disk);
    const auto plain = field_monitor(paraboloid(), {.scaled = false, .floor = 0.1}, disk);
    for (const double r : {0.0, 0.3, 0.5, 0.7})
        EXPECT_NEAR(at(*scaled, {0.6 * r, -0.8 * r, 0}), 1 + 4 * (r * r + 2 * sigma_square), 0.01) << r;
    EXPECT_NEAR(at(*plain, {0.6, 0, 0}), 0.6 * 0.6 + 2 * sigma_square, 1e-3);
    const auto notes = scaled->report().notes;
    const auto says = [&](const char* text) {
        return std::find(notes.begin(), notes.end(), text) != notes.end();
    };
    EXPECT_TRUE(says("The field is blurred over 1 cell, so that the mesh can follow.")) << join(notes, " ");
}

TEST(FieldMonitor, NeedsPositiveValuesOnThePatchAlone) {
    FieldData field = paraboloid();
    for (double& value : std::get<GridData>(field.data).values) value = 1.5 - value; // -0.5 in the corners
    const gaspard::Run run = solved_run("spline-two-circles", {"domain.cells=32", "method.max_iterations=1"});
    const DataContext disk{.space = run.space(), .discretisation = &run.discretisation()};
    const auto monitor = field_monitor(field, {.scaled = false}, disk);
    EXPECT_NEAR(at(*monitor, {0.3, 0.4, 0}), 1.25 - 2 * std::numbers::pi / (32 * 32), 1e-3);
}

// Stretched over u and v: the field is u at the parameters (u, v).
TEST(FieldMonitor, IsScaledOnASurface) {
    const gaspard::Run run = solved_run("spline-torus", {"domain.cells=24", "method.max_iterations=1"});
    const DataContext torus{.space = run.space(), .discretisation = &run.discretisation()};
    Points uv(1), x;
    const auto monitor = field_monitor(slope(7), {.contrast = 3}, torus);
    for (const double u : {0.4, 0.5, 0.6}) {
        uv.set(0, {u, 0.5, 0});
        run.discretisation().parameters()->points(uv, x);
        EXPECT_NEAR(at(*monitor, x[0]), 1 + 2 * u, 0.01);
    }
}

// The data are the end of a flow from noise, which keeps the mean (tests/core/published compute the rest).
TEST(FieldMonitor, TheVorticesThatAreShippedHaveTheMeanOfTheirNoise) {
    const FieldData field = parse_field(read_data_file("gaspard:flow-vortices.nc", {}), "flow-vortices.nc");
    EXPECT_EQ(field.variables, std::vector<std::string>{"q"});
    const auto& grid = std::get<GridData>(field.data);
    EXPECT_EQ(grid.axes[0], grid.axes[1]);
    ASSERT_EQ(grid.values.size(), 10000u);
    double mean = 0, noise = 0, low = 0, high = 0;
    for (const double value : noise_values(100, 1)) noise += value / 1e4;
    for (const double value : grid.values)
        mean += value / 1e4, low = std::min(low, value), high = std::max(high, value);
    EXPECT_NEAR(mean, noise, 1e-9);
    EXPECT_NEAR(low, -0.397, 1e-3);
    EXPECT_NEAR(high, 0.376, 1e-3);
}

// As in the paper: max(q^2, 0.005) on 60 x 60 cells.
TEST(FieldMonitor, AMeshFollowsTheShippedVortices) {
    for (const std::string method : {"quasi-newton", "auto"}) {
        gaspard::Run run = solved_run("flow-vortices", {"method.type=" + method});
        EXPECT_EQ(run.status(), RunStatus::converged) << method;
        EXPECT_LE(run.history().back().iteration, method == "auto" ? 50 : 35);
        EXPECT_EQ(run.history().back().tangled_cells, 0u);
        const auto snapshot = run.snapshot();
        const auto& monitor = snapshot->field("monitor")->values;
        const auto [low, high] = std::minmax_element(monitor.begin(), monitor.end());
        EXPECT_NEAR(*low, 0.005, 1e-6);
        EXPECT_NEAR(*high, 0.103, 2e-3);
    }
}

class FieldScenario : public testing::TestWithParam<const char*> {};

TEST_P(FieldScenario, Converges) {
    auto run = solved_run(GetParam(), {"domain.cells=16"});
    EXPECT_EQ(run.status(), RunStatus::converged);
    const auto snapshot = run.snapshot();
    ASSERT_NE(snapshot->monitor_report, nullptr);
    EXPECT_FALSE(snapshot->monitor_report->choices.at("variable").empty());
    const auto& monitor = snapshot->fields[0].values;
    const auto [low, high] = std::minmax_element(monitor.begin(), monitor.end());
    EXPECT_GT(*high / *low, 2) << "the monitor follows the field";
}

INSTANTIATE_TEST_SUITE_P(All, FieldScenario,
                         testing::Values("plane-field", "sphere-field", "spline-field", "flow-vortices"));

} // namespace
} // namespace gaspard
