#include "gui/plot_widget.hpp"
#include "headless_ui.hpp"

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

} // namespace
} // namespace gaspard
