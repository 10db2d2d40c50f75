// Paths that are drawn with the mouse.
#include "core/scenario/toml.hpp"
#include "gui/document/path_drawing.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

class PathDrawingTest : public testing::Test {
  protected:
    Scenario at(double x, double y) {
        Scenario scenario = still;
        scenario.monitor.values.set("center_x", x);
        scenario.monitor.values.set("center_y", y);
        return scenario;
    }
    const Catalogue catalogue = builtin_catalogue();
    const Scenario still = find_scenario(catalogue, "plane-ring");
    PathDrawing drawing;
};

TEST_F(PathDrawingTest, PlacesAndTimesBecomeThePath) {
    drawing.add(at(0.5, 0.5), "center_x", 9);
    EXPECT_FALSE(drawing.drawing()) << "not armed";
    drawing.arm();
    for (int i = 0; i <= 10; ++i) drawing.add(at(0.5 + 0.02 * i, 0.5), "center_x", 100 + 0.1 * i);
    drawing.add(at(0.9, 0.9), "center_x", 101.001); // too soon after the last
    drawing.add(at(0.9, 0.9), "another", 102);
    EXPECT_TRUE(drawing.drawing());
    const auto moving = drawing.finish(catalogue, still);
    ASSERT_TRUE(moving);
    EXPECT_FALSE(drawing.armed());
    const auto path = parse_path(moving->time.text("path"));
    ASSERT_EQ(path.size(), 11u);
    EXPECT_EQ(path.front(), (PathPoint{0, 0.5, 0.5}));
    EXPECT_NEAR(path.back().t, 1, 1e-9);
    EXPECT_NEAR(path.back().first, 0.7, 1e-9);
    EXPECT_NEAR(moving->time.real("end"), 1, 1e-9);
    EXPECT_EQ(moving->time.real("speed"), 1) << "a unit of t is a second of the drag";
    EXPECT_EQ(moving->monitor, still.monitor) << "the clock moves the centre";
    EXPECT_NEAR(make_clock(*moving)->at(0.5).monitor.values.real("center_x"), 0.6, 1e-9);
}

TEST_F(PathDrawingTest, GoesOnAcrossTheBorder) {
    drawing.arm();
    for (const double x : {0.8, 0.9, 0.0, 0.1})
        drawing.add(at(x, 0.5), "center_x", 10 * x + (x < 0.5 ? 10 : 0));
    const auto path = parse_path(drawing.finish(catalogue, still)->time.text("path"));
    EXPECT_NEAR(path[2].first, 1.0, 1e-9);
    EXPECT_NEAR(path[3].first, 1.1, 1e-9);
}

TEST_F(PathDrawingTest, AClickIsNoPath) {
    drawing.arm();
    drawing.add(at(0.5, 0.5), "center_x", 0);
    drawing.add(at(0.5, 0.6), "center_x", 0.1);
    EXPECT_FALSE(drawing.finish(catalogue, still));
}

} // namespace
} // namespace gaspard
