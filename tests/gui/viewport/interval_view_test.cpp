// Plots instead of the mesh of an interval: where they are, and what the mouse and actions do with them.
#include "core/scenario/toml.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/session/run.hpp"
#include "core/tessellate/film.hpp"
#include "gui/application_fixture.hpp"
#include "gui/plan_fixture.hpp"
#include "gui/plot/plot_curves.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class SmallIntervalTest : public ApplicationFixture {
  protected:
    SmallIntervalTest() : SmallIntervalTest(std::make_shared<Catalogue>(builtin_catalogue())) {}

  private:
    explicit SmallIntervalTest(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, find_scenario(*of, "layer-1d")) {}
};

TEST_F(SmallIntervalTest, AWindowTooSmallForPlotsSaysSo) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto says = [&](float width, float height) {
        ImGui::GetIO().DisplaySize = {width, height};
        for (int i = 0; i < 3; ++i) frame();
        return application.items().count("viewport.too-small") == 1;
    };
    EXPECT_FALSE(says(1400, 900));
    EXPECT_TRUE(says(300, 180));
    EXPECT_FALSE(says(1400, 900));
}

class IntervalPlan : public PlanFixture {
  protected:
    IntervalPlan() : PlanFixture("interval", {{100, 50}, {901, 650}}) {
        view_ = Values("view", view_rows(std::vector<FieldInfo>{{.name = "solution"}}, "solution"));
    }
    std::vector<PlannedPlot> plots(const Snapshot& snapshot, const std::vector<ColumnZoom>& zooms = {}) {
        std::vector<PlannedPlot> made;
        ui_.frame([&] {
            made = planner_.plan(snapshot, view_, {.subject = subject_}, whole_, 1, {}, zooms).plots;
        });
        return made;
    }
    PlotFrame frame_of(const PlannedPlot& plot) {
        PlotFrame made;
        ui_.frame([&] { made = make_frame(plot.view, plot.rect, plot.zoom, 1); });
        return made;
    }
};

TEST_F(IntervalPlan, PlotsOfAColumnBeginAndEndAtTheSamePixel) {
    const Snapshot snapshot = layer_snapshot(32, 1e-8);
    const std::pair<const char*, std::size_t> layouts[] = {{"single", 2}, {"side-by-side", 4}};
    for (const auto& [layout, count] : layouts) {
        view_.set("layout", std::string(layout));
        EXPECT_TRUE(plan(snapshot, view_).views.empty());
        const auto shown = plots(snapshot);
        ASSERT_EQ(shown.size(), count);
        for (std::size_t i = 0; i < count; i += 2) {
            const PlotFrame above = frame_of(shown[i]), below = frame_of(shown[i + 1]);
            EXPECT_EQ(above.x_range, below.x_range);
            EXPECT_NEAR(above.area.min.x, below.area.min.x, 0.01);
            EXPECT_NEAR(above.area.max.x, below.area.max.x, 0.01);
            EXPECT_LE(above.area.max.y, below.area.min.y);
            EXPECT_GT(below.area.height(), 60);
        }
    }
}

TEST_F(IntervalPlan, WhileIteratesAreComparedTheirAxesStay) {
    const auto snapshot = [](double width, std::uint64_t version) {
        auto made = std::make_shared<Snapshot>(layer_snapshot(16, width));
        made->version = version;
        for (Field& field : made->fields)
            for (double& value : field.values) value *= static_cast<double>(version);
        return made;
    };
    const auto first = snapshot(0.2, 1), middle = snapshot(0.05, 2), last = snapshot(0.01, 4);
    const auto range = [&](const Snapshot& shown, std::size_t which) {
        return home_range(plots(shown)[which].view, true);
    };
    EXPECT_NE(range(*first, 0), range(*last, 0));
    EXPECT_NE(range(*first, 1), range(*last, 1));
    const AxisRange lowest = range(*first, 0), highest = range(*last, 0);
    planner_.compare_plots({first, last});
    for (const std::size_t which : {0U, 1U}) {
        EXPECT_EQ(range(*first, which), range(*middle, which));
        EXPECT_EQ(range(*middle, which), range(*last, which));
    }
    EXPECT_LE(range(*middle, 0).low, std::min(lowest.low, highest.low) + 1e-12);
    EXPECT_GE(range(*middle, 0).high, std::max(lowest.high, highest.high) - 1e-12);
    planner_.compare_plots({});
    EXPECT_NE(range(*first, 0), range(*last, 0)) << "fitted again afterwards";
}

TEST_F(IntervalPlan, AllFramesOfAFilmHaveTheSameAxes) {
    const auto catalogue = std::make_shared<Catalogue>(builtin_catalogue());
    struct Case {
        const char* name;
        FilmMotions motions;
        std::vector<std::string> settings;
    };
    const std::vector<std::string> in_time{"time.end=0.4", "time.step=0.05"};
    for (const Case& one :
         {Case{"layer-1d", {.iterations = true}, {}},
          {"layer-1d", {.iterations = true}, {"view.x_axis=log-left", "view.layout=side-by-side"}},
          {"layer-1d", {.iterations = true, .blend = true}, {}},
          {"layer-1d", {.iterations = true}, {"view.color=none", "view.x_axis=log-right"}},
          {"layer-1d", {.blend = true}, {"view.x_axis=log-left"}},
          {"burgers-1d", {.time = true}, in_time},
          {"burgers-1d", {.time = true, .blend = true}, in_time}}) {
        Scenario scenario = find_scenario(*catalogue, one.name);
        apply_settings(*catalogue, scenario, {"domain.cells=16"});
        apply_settings(*catalogue, scenario, one.settings);
        Recording recording{std::size_t{1} << 30};
        gaspard::Run run(catalogue, scenario);
        recording.add(*run.snapshot());
        while (run.status() == RunStatus::running) run.step(), recording.add(*run.snapshot());
        const Film film({.motions = one.motions}, recording, run.snapshot(), scenario.view);
        const auto ranges = [&](FilmFrame shown, bool held) {
            if (!held) shown.axes.clear();
            ViewportPlanner planner;
            planner.prepare(shown);
            std::vector<AxisRange> all;
            ui_.frame([&] {
                for (const PlannedPlot& plot :
                     planner.plan(*shown.snapshot, shown.view, {.subject = subject_}, whole_, 1).plots)
                    for (const bool vertical : {false, true}) all.push_back(home_range(plot.view, vertical));
            });
            return all;
        };
        const auto first = ranges(film.frame(0), true);
        bool differ = false;
        ASSERT_GT(film.frames(), 4) << one.name;
        for (int k = 0; k < film.frames(); ++k) {
            EXPECT_EQ(ranges(film.frame(k), true), first) << one.name << ", frame " << k;
            const auto own = ranges(film.frame(k), false);
            differ = differ || own != ranges(film.frame(0), false);
            for (std::size_t i = 0; i < own.size(); ++i) {
                EXPECT_GE(own[i].low, first[i].low - 1e-9) << "all is seen";
                EXPECT_LE(own[i].high, first[i].high + 1e-9);
            }
        }
        EXPECT_TRUE(differ) << one.name << ": each fitted by itself";
    }
}

TEST_F(IntervalPlan, ALinearAxisIsExactToTenToMinusTwelveAtBothEnds) {
    const Snapshot snapshot = layer_snapshot(8, 0.1);
    for (const double end : {0.0, 1.0}) {
        const double sign = end == 0 ? 1 : -1;
        const AxisRange zoom{std::min(end, end + sign * 0x1p-40), std::max(end, end + sign * 0x1p-40)};
        const PlotFrame frame = frame_of(plots(snapshot, {{.x = zoom, .values = {}, .spacing = {}}})[0]);
        const AxisRange allowed = limited(zoom, home_range(plots(snapshot)[0].view, false), false);
        EXPECT_NEAR(allowed.span(), zoom.span(), 0.1 * zoom.span()) << "one can zoom in so far";
        const double width = static_cast<double>(frame.area.width());
        const double at = frame.pixel_x(end + sign * 0x1p-42) - static_cast<double>(frame.area.min.x);
        EXPECT_NEAR(at, (end == 0 ? 0.25 : 0.75) * width, 1e-9 * width);
        std::vector<std::string> labels;
        for (const Tick& tick : frame.x_ticks) labels.push_back(tick.label);
        ASSERT_GE(labels.size(), 3U);
        std::sort(labels.begin(), labels.end());
        EXPECT_EQ(std::unique(labels.begin(), labels.end()), labels.end()) << "neighbours can be told apart";
    }
}

TEST_F(IntervalPlan, TheRightEndIsAtTheRightAndDistancesFromItAreExact) {
    Snapshot snapshot = layer_snapshot(8, 0.1);
    snapshot.x.x[7] = 1 - 0x1p-40;
    view_.set("x_axis", std::string("log-right"));
    const auto shown = plots(snapshot);
    const PlotFrame frame = frame_of(shown[0]);
    EXPECT_GT(frame.pixel_x(0x1p-40), frame.pixel_x(0.5));
    EXPECT_EQ(shown[0].view.curves[0].x[1], 0x1p-40);
    EXPECT_NEAR(frame.position_x(frame.pixel_x(0x1p-40)), -40 * std::log10(2), 1e-12);
    ASSERT_FALSE(frame.x_ticks.empty());
    EXPECT_EQ(frame.x_ticks.back().label.rfind("1 − 10", 0), 0U) << frame.x_ticks.back().label;
}

TEST_F(IntervalPlan, RunsAreBesideEachOtherAndZoomedTogether) {
    const Snapshot first = layer_snapshot(8, 0.1), second = layer_snapshot(16, 0.01);
    const std::vector<NamedSnapshot> others{{"Shishkin", &second}};
    view_.set("layout", std::string("runs"));
    const ColumnZoom zoom{.x = AxisRange{0.2, 0.3}, .values = {}, .spacing = {}};
    std::vector<PlannedPlot> made;
    ui_.frame([&] {
        made = planner_.plan(first, view_, {.subject = "mesh PDE"}, whole_, 1, others, {zoom}).plots;
    });
    ASSERT_EQ(made.size(), 4U);
    EXPECT_EQ(made[0].view.title, "mesh PDE");
    EXPECT_EQ(made[2].view.title, "Shishkin");
    EXPECT_EQ(made[0].view.curves[0].x.size(), 9U);
    EXPECT_EQ(made[2].view.curves[0].x.size(), 17U);
    for (const PlannedPlot& plot : made) EXPECT_EQ(plot.zoom.x, zoom.x);
    EXPECT_GE(made[2].rect.min.x, made[0].rect.max.x);
}

TEST_F(IntervalPlan, AMeshOfManyCellsIsDrawnFromFewPoints) {
    const Snapshot snapshot = layer_snapshot(65536, 1e-8);
    for (const char* axis : {"linear", "log-left", "log-right"}) {
        view_.set("x_axis", std::string(axis));
        const auto shown = plots(snapshot);
        for (const PlannedPlot& plot : shown) {
            const PlotFrame frame = frame_of(plot);
            for (const PixelPath& path : pixel_paths(plot.view, frame))
                EXPECT_LT(path.x.size(), 8 * static_cast<std::size_t>(frame.area.width())) << axis;
            for (const RowView& row : plot.view.rows)
                EXPECT_LT(columns_of(row.x, frame).size(), static_cast<std::size_t>(frame.area.width()) + 4);
        }
    }
}

TEST_F(IntervalPlan, EveryNodeOfARowHasItsColumn) {
    PlotFrame frame;
    frame.area = {{100, 0}, {300, 10}};
    EXPECT_EQ(columns_of(std::vector<double>{0, 0.25, 0.2501, 1}, frame),
              (std::vector<float>{100, 150, 300}));
    EXPECT_EQ(columns_of(std::vector<double>{1, 0.25, -3}, frame), (std::vector<float>{300, 150}));
    frame.x.reversed = true;
    EXPECT_EQ(columns_of(std::vector<double>{0, 0.25, 1}, frame), (std::vector<float>{300, 250, 100}));
}

class IntervalWindow : public ApplicationFixture {
  protected:
    IntervalWindow() : IntervalWindow(std::make_shared<Catalogue>(builtin_catalogue())) {}
    void SetUp() override {
        ASSERT_TRUE(wait_until([&] { return run().ended() && !application.interval_plots().empty(); }));
        frame();
    }
    PlannedPlot plot(std::size_t i) { return application.interval_plots().at(i); }
    ItemRectangle item(std::size_t i) {
        return application.items().find("viewport.plot." + std::to_string(i))->second;
    }
    void turn_wheel(std::size_t i, float turns) {
        ui.move(item(i).center_x(), item(i).center_y());
        frame();
        ui.wheel(turns);
        frame();
        ui.wheel(0);
        frame();
    }

  private:
    explicit IntervalWindow(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, layer(*of)) {}
    static Scenario layer(const Catalogue& catalogue) {
        Scenario scenario = find_scenario(catalogue, "layer-1d");
        apply_settings(catalogue, scenario, {"method.interpolation=false"});
        return scenario;
    }
};

TEST_F(IntervalWindow, TheWheelZoomsBothPlotsOfAColumnAndADoubleClickShowsEverything) {
    const AxisRange home = home_range(plot(0).view, false);
    turn_wheel(0, 3);
    ASSERT_TRUE(plot(0).zoom.x && plot(0).zoom.y && plot(1).zoom.x);
    EXPECT_NEAR(plot(0).zoom.x->span(), home.span() / std::pow(1.2, 3), 1e-9);
    EXPECT_EQ(plot(1).zoom.x, plot(0).zoom.x);
    EXPECT_FALSE(plot(1).zoom.y) << "widths are on another axis";
    const double before = plot(1).zoom.x->span();
    turn_wheel(1, 1);
    EXPECT_NEAR(plot(0).zoom.x->span(), before / 1.2, 1e-9) << "the plot below zooms the one above";
    ui.move(item(0).center_x(), item(0).center_y());
    frame();
    for (int click = 0; click < 2; ++click) ui.button(true), frame(), ui.button(false), frame();
    frame();
    EXPECT_EQ(plot(0).zoom, PlotZoom{});
    EXPECT_FALSE(plot(1).zoom.x);
}

TEST_F(IntervalWindow, OtherAxesAndHomeShowEverything) {
    turn_wheel(0, 2);
    ASSERT_TRUE(plot(0).zoom.x);
    application.perform("home");
    frame();
    EXPECT_EQ(plot(0).zoom, PlotZoom{});
    turn_wheel(0, 2);
    look().set("x_axis", std::string("log-left"));
    frame(), frame();
    EXPECT_EQ(plot(0).zoom, PlotZoom{});
    turn_wheel(0, 2);
    look().set("color", std::string("monitor"));
    frame(), frame();
    EXPECT_TRUE(plot(0).zoom.x) << "the same axis";
    EXPECT_FALSE(plot(0).zoom.y) << "other values";
}

TEST_F(IntervalWindow, DraggingMovesAReversedAxisWithTheMouse) {
    look().set("x_axis", std::string("log-right"));
    frame(), frame();
    const AxisRange home = home_range(plot(0).view, false);
    ui.drag(item(0), 0.5F, 0.6F, drawing());
    frame();
    ASSERT_TRUE(plot(0).zoom.x);
    EXPECT_GT(plot(0).zoom.x->low, home.low) << "what was at the left, far from the end, comes into sight";
}

TEST_F(IntervalWindow, ActionsThatMakeNoSenseSayWhy) {
    for (const char* name : {"arrows", "copy-camera", "paste-camera", "spin", "projection", "front-and-rear",
                             "exact", "right"}) {
        const Action& row = find_action(application.actions(), name);
        EXPECT_FALSE(row.is_enabled()) << name;
        EXPECT_FALSE(row.why_disabled().empty()) << name;
    }
    EXPECT_TRUE(find_action(application.actions(), "side-by-side").is_enabled());
    application.perform("side-by-side");
    frame(), frame();
    EXPECT_EQ(application.interval_plots().size(), 4U);
    application.perform("lines");
    frame(), frame();
    EXPECT_TRUE(plot(0).view.rows.empty());
}

TEST_F(IntervalWindow, AnotherDomainShowsItsMesh) {
    turn_wheel(0, 2);
    Scenario plane = find_scenario(*catalogue, "plane-ring");
    set_value(*catalogue, plane, "domain.cells", std::int64_t{8});
    application.document().change(run().id, plane);
    ASSERT_TRUE(wait_until([&] { return !application.views().empty(); }));
    EXPECT_TRUE(application.interval_plots().empty());
    for (int i = 0; i < 3; ++i) ui.click(application.items().find("viewport")->second, drawing());
}

} // namespace
} // namespace gaspard
