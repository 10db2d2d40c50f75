#include "gui/base/layout.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

constexpr float em = 15;

Layout at(float width, float height, float size) {
    return compute_layout(width, height, size * em, 1.7F * size * em);
}

TEST(Layout, ATooSmallWindowHasOnePlotOrNone) {
    EXPECT_EQ(at(1400, 900, 1).plots, 2);
    EXPECT_EQ(at(1000, 700, 1).plots, 2);
    EXPECT_TRUE(at(1000, 700, 1).plots_beside) << "where curves are high enough to be read";
    const LayoutChoice projector{.sidebar = false};
    const auto large = [&](float width, float height) {
        return compute_layout(width, height, 1.7F * em, 1.7F * 1.7F * em, projector);
    };
    EXPECT_EQ(large(1280, 720).plots, 2);
    const Layout one = large(800, 600);
    EXPECT_EQ(one.plots, 1);
    EXPECT_GE(one.first_plot.height(), 10.5F * 1.7F * em) << "it can be read";
    EXPECT_EQ(one.second_plot.width(), 0);
    const Layout none = large(640, 480);
    EXPECT_EQ(none.plots, 0);
    EXPECT_GT(none.plots_note.height(), 0);
    EXPECT_EQ(none.viewport.bottom, none.plots_note.top);
    EXPECT_EQ(one.plots_note.height(), 0);
    EXPECT_EQ(none.viewport.right, 640) << "the mesh has all the space";
    EXPECT_EQ(compute_layout(1400, 900, em, 25, {.plots = false}).plots, 0);
}

TEST(Layout, PlotsThatAreShownAreLargeEnoughAndLeaveTheMeshInSight) {
    for (const float width : {480, 640, 800, 1000, 1400, 2560})
        for (const float height : {360, 480, 600, 800, 1440})
            for (const float size : {1.0F, 1.7F, 2.5F}) {
                const Layout layout = at(width, height, size);
                const float unit = size * em;
                if (layout.plots == 0) continue;
                EXPECT_GE(layout.first_plot.width(), 12 * unit - 1)
                    << width << " x " << height << ", " << size;
                EXPECT_GE(layout.first_plot.height(), 10.5F * unit - 1)
                    << width << " x " << height << ", " << size;
                EXPECT_GE(std::min(layout.viewport.width() - 6 * unit, layout.viewport.height()),
                          8 * unit - 1)
                    << width << " x " << height << ", " << size;
            }
}

} // namespace
} // namespace gaspard
