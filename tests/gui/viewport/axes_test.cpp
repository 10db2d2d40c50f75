// Axes of meshes in the plane, in viewports.
#include "core/tessellate/plane_axes.hpp"
#include "gui/plan_fixture.hpp"
#include "gui/viewport/axes.hpp"
#include "gui/viewport/legend.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class AxesTest : public PlanFixture {
  protected:
    AxesTest() : PlanFixture("plane", {{0, 0}, {825, 800}}) {}

    /// The letters that axes draw, as vertices within a rectangle.
    std::size_t vertices_within(const PlannedView& shown, ScreenRect pane, ScreenRect where) {
        std::size_t count = 0;
        ui_.frame([&] {
            ImDrawList& list = *ImGui::GetForegroundDrawList();
            draw_axes(list, shown, pane, std::nullopt, theme_, 1);
            for (const ImDrawVert& vertex : list.VtxBuffer)
                count += vertex.pos.x > where.min.x && vertex.pos.x < where.max.x &&
                                 vertex.pos.y > where.min.y && vertex.pos.y < where.max.y
                             ? 1
                             : 0;
        });
        return count;
    }
    static double side_in_pixels(const PlannedView& shown) { return 1 / shown.camera.scale; }
};

TEST_F(AxesTest, TheMeshFillsThreeFifthsOfThePane) {
    const ViewportPlan made = plan(ring_snapshot(8));
    const PlannedView& shown = made.views[0];
    ASSERT_TRUE(shown.axes);
    const double side = side_in_pixels(shown), pane = shown.size().width * shown.size().height;
    EXPECT_GE(side * side / pane, 0.6);
}

TEST_F(AxesTest, WithoutThemTheMeshHasTheirRoom) {
    const double with = side_in_pixels(plan(ring_snapshot(8)).views[0]);
    view_.set("axes", false);
    const ViewportPlan made = plan(ring_snapshot(8));
    EXPECT_FALSE(made.views[0].axes);
    EXPECT_GT(side_in_pixels(made.views[0]), with + 20);
}

TEST_F(AxesTest, OnlyFlatMeshesInThePlaneHaveThem) {
    EXPECT_FALSE(plan(sphere_snapshot(2)).views[0].axes);
    EXPECT_FALSE(plan(cube_snapshot(2)).views[0].axes);
    Snapshot snapshot = ring_snapshot(4);
    view_.set("elevation", 1.0);
    EXPECT_FALSE(plan(snapshot).views[0].axes);
}

TEST_F(AxesTest, TheyFollowTheMeshThatIsShown) {
    Snapshot snapshot = ring_snapshot(4);
    snapshot.x = snapshot.mesh->nodes;
    for (double& x : snapshot.x.x) x = 2.5 * x - 0.75;
    view_.set("layout", std::string("side-by-side"));
    const ViewportPlan both = plan(snapshot);
    ASSERT_TRUE(both.views[0].axes && both.views[1].axes);
    EXPECT_EQ(both.views[0].axes->low.x, 0) << "computational";
    EXPECT_EQ(both.views[1].axes->low.x, -0.75) << "physical";
    EXPECT_EQ(both.views[1].axes->high.x, 1.75);
    view_.set("layout", std::string("single"));
    view_.set("blend", 0.5);
    EXPECT_EQ(plan(snapshot).views[0].axes->high.x, 1.375);
}

TEST_F(AxesTest, LabelsAreBesideTheMesh) {
    const ViewportPlan made = plan(ring_snapshot(8));
    const PlannedView& shown = made.views[0];
    const Pixel corner = to_pixel(shown.camera, shown.size(), {0, 0, 0});
    const auto x = static_cast<float>(corner.x), y = static_cast<float>(corner.y);
    const ScreenRect pane = made.rect, left{{0, 0}, {x - 8, y}}, below{{x, y + 8}, {825, 800}};
    EXPECT_GT(vertices_within(shown, pane, left), 40U);
    EXPECT_GT(vertices_within(shown, pane, below), 40U);
    EXPECT_EQ(vertices_within(shown, pane, {{x + 2, 0}, {825, y - 2}}), 0U) << "not over the mesh";
}

TEST_F(AxesTest, WhereTheEdgeOfTheMeshIsOutOfSightTheyAreAtThatOfThePane) {
    view_.set("camera", std::string("centre 0.5 0.5 height 0.01"));
    const ViewportPlan made = plan(ring_snapshot(8));
    const ScreenRect pane = made.rect;
    EXPECT_GT(vertices_within(made.views[0], pane, {{0, 0}, {80, 760}}), 40U);
    EXPECT_GT(vertices_within(made.views[0], pane, {{80, 760}, {825, 800}}), 40U);
    view_.set("camera", std::string("centre 8 8 height 1"));
    EXPECT_EQ(vertices_within(plan(ring_snapshot(8)).views[0], pane, pane), 0U) << "the mesh is out of sight";
}

TEST_F(AxesTest, BesideEachOtherLabelsStayInTheirParts) {
    view_.set("layout", std::string("side-by-side"));
    const ViewportPlan made = plan(ring_snapshot(8));
    for (const PlannedView& shown : made.views) {
        const std::size_t all = vertices_within(shown, shown.rect, {{-1e4F, -1e4F}, {1e4F, 1e4F}});
        EXPECT_EQ(vertices_within(shown, shown.rect, shown.rect), all);
        const Pixel corner = to_pixel(shown.camera, shown.size(), {1, 0, 0});
        const float x = shown.rect.min.x + static_cast<float>(corner.x), y = static_cast<float>(corner.y);
        EXPECT_GT(vertices_within(shown, shown.rect, {{x - 14, y + 8}, {x + 14, y + 40}}), 4U)
            << "the last label";
    }
}

} // namespace
} // namespace gaspard
