#include "gui/base/plot_text.hpp"
#include "gui/headless_ui.hpp"
#include "gui/plot/plot_legend.hpp"
#include "gui/plot/plot_read_out.hpp"
#include "gui/plot/plot_widget.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace gaspard {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Plot plot_of(std::vector<double> x, std::vector<double> y, bool logarithmic = false) {
    Plot plot;
    plot.x.label = "iteration";
    plot.y = {"residual", logarithmic};
    plot.curves.push_back({"run", std::move(x), std::move(y), false});
    return plot;
}

AxisRange home_of(const Plot& plot, bool vertical) { return home_range(view_of(plot), vertical); }

TEST(HomeRange, HoldsAllValuesWithALittleRoomAboveAndBelow) {
    const Plot plot = plot_of({0, 10}, {1, 3});
    EXPECT_EQ(home_of(plot, false), (AxisRange{0, 10}));
    EXPECT_NEAR(home_of(plot, true).low, 0.9, 1e-12);
    EXPECT_NEAR(home_of(plot, true).high, 3.1, 1e-12);
}

TEST(HomeRange, OfALogarithmicAxisCountsDecadesAndPassesOverWhatHasNone) {
    const Plot plot = plot_of({0, 1, 2, 3, 4}, {1, 1e-4, 0, -5, nan}, true);
    EXPECT_NEAR(home_of(plot, true).low, -4.2, 1e-12);
    EXPECT_NEAR(home_of(plot, true).high, 0.2, 1e-12);
    EXPECT_EQ(home_of(plot, false).high, 1) << "points that are not shown ask for no room";
}

TEST(HomeRange, OfNothingAndOfOnePointIsNotEmpty) {
    for (const bool logarithmic : {false, true})
        for (const Plot& plot :
             {Plot{.title = {}, .x = {}, .y = {"", logarithmic}, .curves = {}}, plot_of({}, {}, logarithmic),
              plot_of({3}, {7}, logarithmic), plot_of({0, 1}, {nan, nan}, logarithmic),
              plot_of({0, 1}, {2, 2}, logarithmic), plot_of({0, 1}, {0, 0}, logarithmic)})
            for (const bool vertical : {false, true}) {
                const AxisRange range = home_of(plot, vertical);
                EXPECT_LT(range.low, range.high);
                EXPECT_TRUE(std::isfinite(range.low) && std::isfinite(range.high));
            }
}

TEST(PlotFrame, OfALowPlotHasOneLineForTheNamesOfBothAxes) {
    HeadlessUi ui;
    ui.frame([] {
        const float line = ImGui::GetFontSize();
        const Plot plot = plot_of({1, 2}, {3, 4});
        const auto below = [&](float lines) { // what is left below the curves, in lines
            const ScreenRect rect{{0, 0}, {300, lines * line}};
            return (rect.max.y - make_frame(view_of(plot), rect, {}, 1).area.max.y) / line;
        };
        EXPECT_GT(below(9), 2);
        EXPECT_LT(below(7), 1.5);
        EXPECT_GT(below(7), 1) << "the ticks";
    });
}

TEST(PlotFrame, LabelsOfTheVerticalAxisDoNotOverlap) {
    HeadlessUi ui;
    ui.frame([] {
        const double line = static_cast<double>(ImGui::GetFontSize());
        for (const double lowest : {1.0, 0.0021, 3e-9})
            for (const double factor : {1.3, 3.0, 9.5, 45.0, 1e4, 1e9})
                for (const float height : {60.0F, 90.0F, 150.0F, 300.0F, 700.0F}) {
                    const Plot plot = plot_of({0, 1}, {lowest, factor * lowest}, true);
                    const PlotFrame frame = make_frame(view_of(plot), {{0, 0}, {300, height}}, {}, 1);
                    double above = INFINITY;
                    int labels = 0;
                    for (const Tick& tick : frame.y_ticks) {
                        if (tick.label.empty()) continue;
                        const double pixel = frame.pixel_y(tick.value);
                        EXPECT_GE(above - pixel, line) << tick.label << ", " << lowest << " times " << factor
                                                       << ", " << height << " high";
                        above = pixel, ++labels;
                    }
                    if (height >= 150) {
                        EXPECT_GE(labels, 1) << lowest << " times " << factor;
                    }
                }
    });
}

/// Draws a plot into a window of a headless ImGui and counts the triangles' corners.
int drawn_vertices(const Plot& plot, ImVec2 size = {400, 300}, ImVec2 mouse = {-100, -100}) {
    HeadlessUi ui;
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset; // as ours
    int count = 0;
    PlotZoom zoom;
    for (int repeated = 0; repeated < 3; ++repeated)
        ui.frame([&] {
            ui.move(mouse.x, mouse.y);
            ImGui::SetNextWindowPos({0, 0});
            ImGui::Begin("plots", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize);
            const int before = ImGui::GetWindowDrawList()->VtxBuffer.Size;
            plot_widget("plot", view_of(plot), size, zoom, dark_theme(), 1);
            count = ImGui::GetWindowDrawList()->VtxBuffer.Size - before;
            ImGui::End();
        });
    return count;
}

TEST(PlotWidget, DrawsWhateverItIsGiven) {
    std::vector<double> x, y;
    for (int i = 0; i < 200000; ++i) {
        x.push_back(i);
        y.push_back(i % 7 == 0 ? nan : std::sin(0.1 * i));
    }
    const int empty = drawn_vertices(plot_of({}, {}));
    EXPECT_GT(empty, 0) << "the axes are there";
    EXPECT_GT(drawn_vertices(plot_of(x, y)), empty + 1000);
    EXPECT_GT(drawn_vertices(plot_of({1}, {1})), 0);
    EXPECT_GT(drawn_vertices(plot_of({0, 1, 2}, {0, 1e-300, 1e300}, true)), 0);
    EXPECT_GE(drawn_vertices(plot_of({0, 1}, {0, -1}, true)), 0);
    EXPECT_GE(drawn_vertices(plot_of({0, 1}, {0, 1}), {6, 6}), 0) << "no room";
}

TEST(PlotWidget, ShowsValuesUnderThePointer) {
    const Plot plot = plot_of({0, 1, 2}, {1, 2, 0});
    const int away = drawn_vertices(plot);
    bool shown = false;
    for (float x = 0; x < 400 && !shown; x += 20)
        for (float y = 0; y < 300 && !shown; y += 20) shown = drawn_vertices(plot, {400, 300}, {x, y}) > away;
    EXPECT_TRUE(shown);
}

TEST(PlotWidget, HasALegendForSeveralCurves) {
    Plot plot = plot_of({0, 1}, {1, 2});
    plot.curves.push_back({"a long name to be written", {}, {}, false});
    EXPECT_GT(drawn_vertices(plot), drawn_vertices(plot_of({0, 1}, {1, 2})) + 40);
}

TEST(Legend, TellsTheWholeOfANameThatIsShortened) {
    HeadlessUi ui;
    const std::string name = "a name of many words that is too long for a plot of this size, whatever it is";
    Plot plot = plot_of({1, 2}, {1, 2});
    plot.curves.push_back({name, {1, 2}, {2, 1}, false});
    const auto told_at = [&](float width, ImVec2 pointer) {
        std::string whole;
        ui.frame([&] {
            const PlotView view = view_of(plot);
            const PlotFrame frame = make_frame(view, {{0, 0}, {width, 300}}, {}, 1);
            whole = draw_legend(*ImGui::GetBackgroundDrawList(), view, pixel_paths(view, frame), frame,
                                dark_theme(), 1, pointer);
        });
        return whole;
    };
    const auto told = [&](float width) {
        std::string whole;
        for (float y = 0; y < 300 && whole.empty(); y += 5) whole = told_at(width, {width / 2, y});
        return whole;
    };
    EXPECT_EQ(told(400), name);
    EXPECT_EQ(told(900), "") << "it is written in full";
}

TEST(Legend, OfManyNamesInASmallPlotStandsAboveTheCurves) {
    HeadlessUi ui;
    ui.frame([] {
        Plot plot = plot_of({1, 2}, {1, 2});
        plot.curves.assign(6, {"ε = 10⁻⁴", {1, 2}, {1, 2}, false});
        const auto frame = [&](ImVec2 size) { return make_frame(view_of(plot), {{0, 0}, size}, {}, 1); };
        const PlotFrame small = frame({300, 220}), large = frame({1600, 1200});
        EXPECT_GT(small.legend_width, 200);
        EXPECT_EQ(large.legend_width, 0) << "a box inside";
        EXPECT_GT(small.area.min.y, large.area.min.y + ImGui::GetFontSize());
        plot.curves.resize(4);
        EXPECT_EQ(frame({300, 220}).legend_width, 0) << "few";
        plot.curves.resize(60, plot.curves.front());
        EXPECT_EQ(frame({300, 220}).legend_width, 0) << "no room";
    });
}

TEST(PlotFrame, ALongTitleTakesSeveralLines) {
    HeadlessUi ui;
    ui.frame([] {
        Plot plot = plot_of({1, 2}, {1, 2});
        plot.title = "short";
        const auto top = [&] { return make_frame(view_of(plot), {{0, 0}, {300, 220}}, {}, 1).area.min.y; };
        const float one = top();
        plot.title = "errors beyond 64 cells per side are measured only with method.reference=on";
        EXPECT_NEAR(top(), one + ImGui::GetFontSize(), 1);
    });
}

TEST(Legend, StandsWhereItHidesLeast) {
    const ScreenRect area{{0, 0}, {400, 300}};
    const auto place = [&](const std::vector<PixelPath>& paths) {
        const ScreenRect box = legend_place(paths, area, {100, 60}, 8);
        EXPECT_EQ(box.width(), 100);
        EXPECT_EQ(box.height(), 60);
        return std::string(box.min.y < 150 ? "upper " : "lower ") + (box.min.x < 150 ? "left" : "right");
    };
    EXPECT_EQ(place({}), "upper right");
    const PixelPath falling{{0, 400}, {0, 300}}, along_the_top{{0, 400}, {20, 20}};
    const PixelPath gap{{0, 200, 400}, {20, nan, 20}};
    EXPECT_EQ(place({falling}), "upper right");
    EXPECT_EQ(place({along_the_top}), "lower left");
    EXPECT_EQ(place({along_the_top, PixelPath{{0, 150}, {250, 250}}}), "lower right");
    EXPECT_EQ(place({gap}), "upper right") << "nothing is drawn across a gap";
}

/// A plot with mouse and zoom, in a window of its own.
class PlotSteering : public testing::Test {
  protected:
    void frame() {
        ui.frame([this] {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::Begin("plots", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize);
            const ImVec2 low = ImGui::GetCursorScreenPos();
            menu = plot_widget("plot", view_of(plot), {400, 300}, zoom, dark_theme(), 1) || menu;
            shown = make_frame(view_of(plot), {low, {low.x + 400, low.y + 300}}, zoom, 1);
            ImGui::End();
        });
    }
    void SetUp() override { frame(), frame(), home = shown; }
    /// A whole pixel, as ImGui rounds the mouse to.
    ImVec2 place(float across, float down) const {
        return {std::floor(shown.area.min.x + across * shown.area.width()),
                std::floor(shown.area.min.y + down * shown.area.height())};
    }
    void point(ImVec2 at) { ui.move(at.x, at.y), frame(), frame(); }
    void wheel(ImVec2 at, float turns) { point(at), ui.wheel(turns), frame(), ui.wheel(0), frame(); }
    void drag(ImVec2 from, ImVec2 to, int button) {
        point(from);
        ui.button(true, button), frame();
        point({(from.x + to.x) / 2, (from.y + to.y) / 2});
        point(to);
        ui.button(false, button), frame(), frame();
    }
    void rest() {
        for (int i = 0; i < 60; ++i) frame(); // so that no click is taken for the second of two
    }
    double under(ImVec2 at) const { return shown.position_x(static_cast<double>(at.x)); }
    double height_at(ImVec2 at) const { return shown.position_y(static_cast<double>(at.y)); }

    HeadlessUi ui;
    Plot plot = plot_of({0, 25, 50, 75, 100}, {1, 1e-2, 1e-3, 1e-5, 1e-8}, true);
    PlotZoom zoom;
    PlotFrame shown, home;
    bool menu = false;
};

TEST_F(PlotSteering, TheWheelZoomsAtThePointer) {
    const ImVec2 at = place(0.25F, 0.6F);
    const double x = under(at), y = height_at(at);
    wheel(at, 3);
    EXPECT_NEAR(shown.x_range.span(), home.x_range.span() / std::pow(1.2, 3), 1e-9);
    EXPECT_NEAR(shown.y_range.span(), home.y_range.span() / std::pow(1.2, 3), 1e-9);
    EXPECT_NEAR(zoom.x->low + (x - home.x_range.low) / home.x_range.span() * zoom.x->span(), x, 1e-9)
        << "what is under the pointer stays there";
    EXPECT_NEAR(zoom.y->low + (y - home.y_range.low) / home.y_range.span() * zoom.y->span(), y, 1e-9);
}

TEST_F(PlotSteering, ShiftCtrlAndTheAxesZoomOneDirectionOnly) {
    ui.shift(true);
    wheel(place(0.5F, 0.5F), 1);
    EXPECT_TRUE(zoom.x && !zoom.y);
    zoom = {};
    ui.shift(false), ui.control(true);
    wheel(place(0.5F, 0.5F), 1);
    EXPECT_TRUE(!zoom.x && zoom.y);
    zoom = {};
    ui.control(false);
    wheel({place(0.5F, 1).x, shown.area.max.y + 6}, 1);
    EXPECT_TRUE(zoom.x && !zoom.y) << "over the axis below";
    zoom = {};
    frame();
    wheel({shown.area.min.x - 6, place(0, 0.5F).y}, 1);
    EXPECT_TRUE(!zoom.x && zoom.y) << "over the axis at the left";
}

TEST_F(PlotSteering, TheLeftButtonDragsAndADoubleClickShowsEverything) {
    const ImVec2 from = place(0.5F, 0.5F), to = place(0.6F, 0.3F);
    const double right = under(to) - under(from), up = height_at(to) - height_at(from);
    drag(from, to, 0);
    ASSERT_TRUE(zoom.x && zoom.y);
    EXPECT_NEAR(zoom.x->low, home.x_range.low - right, 0.02 * right) << "the curve follows the mouse";
    EXPECT_NEAR(zoom.y->low, home.y_range.low - up, 0.02 * up);
    EXPECT_NEAR(zoom.x->span(), home.x_range.span(), 1e-9);
    rest();
    for (int click = 0; click < 2; ++click) ui.button(true), frame(), ui.button(false), frame();
    EXPECT_EQ(zoom, PlotZoom{});
}

TEST_F(PlotSteering, TheRightButtonZoomsToARectangle) {
    const ImVec2 from = place(0.2F, 0.25F), to = place(0.7F, 0.75F);
    const AxisRange x{under(from), under(to)}, y{height_at(to), height_at(from)};
    drag(from, to, 1);
    ASSERT_TRUE(zoom.x && zoom.y);
    EXPECT_NEAR(zoom.x->low, x.low, 1e-9);
    EXPECT_NEAR(zoom.x->high, x.high, 1e-9);
    EXPECT_NEAR(zoom.y->low, y.low, 1e-9);
    EXPECT_NEAR(zoom.y->high, y.high, 1e-9);
    EXPECT_FALSE(menu);
}

TEST_F(PlotSteering, ARightClickAsksForTheMenu) {
    drag(place(0.5F, 0.5F), place(0.5F, 0.5F), 1);
    EXPECT_TRUE(menu);
    EXPECT_EQ(zoom, PlotZoom{});
}

TEST_F(PlotSteering, NewDataMoveOnlyWhatIsNotZoomed) {
    ui.shift(true);
    wheel(place(0.5F, 0.5F), 2);
    const AxisRange x = shown.x_range;
    plot.curves[0].x.push_back(200);
    plot.curves[0].y.push_back(1e-12);
    frame();
    EXPECT_EQ(shown.x_range, x);
    EXPECT_LT(shown.y_range.low, -12);
}

TEST_F(PlotSteering, CountsBeginAtZero) {
    plot.x.whole = true;
    for (const float turns : {-3.0F, -9.0F, 5.0F, -9.0F}) {
        wheel(place(0.3F, 0.4F), turns);
        ASSERT_TRUE(zoom.x);
        EXPECT_GE(zoom.x->low, 0);
    }
    const double span = zoom.x->span();
    drag(place(0.2F, 0.5F), place(0.8F, 0.5F), 0);
    EXPECT_EQ(zoom.x->low, 0);
    EXPECT_NEAR(zoom.x->span(), span, 1e-9 * span) << "dragged, not zoomed";
    for (const Tick& tick : shown.x_ticks) EXPECT_GE(tick.value, 0);
}

TEST_F(PlotSteering, NeverLeavesWhatNumbersCanShow) {
    for (const float turns : {60.0F, -60.0F})
        for (int i = 0; i < 20; ++i) {
            wheel(place(0.3F, 0.4F), turns);
            ASSERT_LT(shown.x_range.low, shown.x_range.high);
            ASSERT_LT(shown.y_range.low, shown.y_range.high);
            ASSERT_TRUE(std::isfinite(shown.x_range.span()) && std::isfinite(shown.y_range.span()));
        }
    EXPECT_LE(shown.x_range.span(), 20.001 * home.x_range.span()) << "the curve can be found again";
}

TEST_F(PlotSteering, PointsAtAreTheNearestOfEveryCurveThatIsThere) {
    plot.curves.push_back({"short", {0, 10, 20, 30, 30}, {5, 4, nan, 2, 2}}); // its end twice
    const auto at = [&](double x) {
        return points_at(view_of(plot), shown, static_cast<float>(shown.pixel_x(x)));
    };
    frame();
    const auto both = at(22);
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[0].index, 1U) << "25";
    EXPECT_EQ(both[1].index, 3U) << "30, for 20 is a gap";
    const auto one = at(60);
    ASSERT_EQ(one.size(), 1U) << "the second ended before";
    EXPECT_EQ(one[0].curve, 0U);
    EXPECT_EQ(one[0].index, 2U) << "50";
}

TEST(Shortened, KeepsBothEndsAndWholeLetters) {
    HeadlessUi ui;
    ui.frame([] {
        const std::string text = "Ränge über alles, amplitude 20";
        EXPECT_EQ(shortened(text, 10000), text);
        for (float width = 0; width < 220; width += 7) {
            const std::string cut = shortened(text, width);
            EXPECT_TRUE(cut == "…" || ImGui::CalcTextSize(cut.c_str()).x <= width) << cut;
            for (std::size_t i = 0; i < cut.size();) { // every letter is complete
                const auto first = static_cast<unsigned char>(cut[i]);
                const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : 3;
                ASSERT_NE(first & 0xc0U, 0x80U) << cut;
                for (std::size_t k = 1; k < length; ++k)
                    ASSERT_EQ(static_cast<unsigned char>(cut.at(i + k)) & 0xc0U, 0x80U) << cut;
                i += length;
            }
        }
        const std::string cut = shortened(text, 120);
        EXPECT_TRUE(cut.starts_with("R") && cut.ends_with("20")) << cut;
    });
}

TEST(PlotFrame, ANarrowAxisOfIterationsHasAScale) {
    const Theme theme = dark_theme();
    HeadlessUi ui(800, 600, &theme);
    ui.scale(1.7F); // as for a projector
    ui.frame([] {
        Plot plot{.title = "", .x = {.label = "iteration", .whole = true}, .y = {"", true}, .curves = {}};
        plot.curves.push_back({"", {0, 20, 45}, {1, 1e-3, 1e-9}});
        const PlotFrame frame = make_frame(view_of(plot), {{0, 0}, {240, 200}}, {}, 1.7F);
        std::size_t labels = 0;
        for (const Tick& tick : frame.x_ticks) labels += tick.label.empty() ? 0 : 1;
        EXPECT_GE(labels, 2U);
    });
}

} // namespace
} // namespace gaspard
