// Plans of viewports: rectangles, cameras, and messages about invalid texts.
#include "core/base/error.hpp"
#include "gui/plan_fixture.hpp"
#include "gui/viewport/legend.hpp"
#include "support/messages.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

const ScreenRect whole{{100, 50}, {901, 650}};

class ViewportTest : public PlanFixture {
  protected:
    ViewportTest() : PlanFixture("plane", whole) {}
};

TEST_F(ViewportTest, SideBySideIsTwoPicturesOfOneSizeSeenByOneCamera) {
    view_.set("layout", std::string("side-by-side"));
    view_.set("blend", 0.25);
    for (const ScreenRect rect : {whole, ScreenRect{{0, 0}, {400, 801}}}) {
        const ViewportPlan both = plan(ring_snapshot(8), view_, rect);
        ASSERT_EQ(both.views.size(), 2U);
        const PlannedView &first = both.views[0], &second = both.views[1];
        EXPECT_EQ(first.size(), second.size());
        EXPECT_EQ(first.camera, second.camera);
        EXPECT_EQ(first.scene.physical, second.scene.physical) << "nothing is uploaded twice";
        EXPECT_EQ(first.scene.blend, 0);
        EXPECT_EQ(second.scene.blend, 0.25);
        EXPECT_EQ(first.title, "computational");
        EXPECT_EQ(second.title, "λ = 0.25");
        const bool beside = second.rect.min.x >= first.rect.max.x,
                   below = second.rect.min.y >= first.rect.max.y;
        EXPECT_NE(beside, below) << "they do not overlap";
        EXPECT_EQ(beside, rect.width() > rect.height());
        for (const float edge : {first.rect.min.x, first.rect.max.x, second.rect.max.x, second.rect.max.y})
            EXPECT_EQ(edge, std::round(edge)) << "whole pixels";
    }
    view_.set("layout", std::string("single"));
    EXPECT_EQ(plan(ring_snapshot(8), view_).views.size(), 1U);
}

TEST_F(ViewportTest, FieldAndMeshAreApart) {
    view_.set("layout", std::string("field-and-mesh"));
    view_.set("blend", 0.5);
    const ViewportPlan both = plan(ring_snapshot(8), view_);
    ASSERT_EQ(both.views.size(), 2U);
    const MeshScene &field = both.views[0].scene, &mesh = both.views[1].scene;
    EXPECT_EQ(field.physical, mesh.physical) << "nothing is uploaded twice";
    EXPECT_EQ(both.views[0].camera, both.views[1].camera);
    EXPECT_EQ(field.blend, 0.5);
    EXPECT_EQ(mesh.blend, 0.5);
    EXPECT_NE(field.colouring, nullptr);
    EXPECT_FALSE(field.lines);
    EXPECT_EQ(mesh.colouring, nullptr);
    EXPECT_TRUE(mesh.lines);
    EXPECT_EQ(both.views[0].title, field.colouring->label);
    EXPECT_EQ(both.views[1].title, "mesh");
    EXPECT_NE(both.colouring, nullptr) << "the legend is that of the field";
}

TEST_F(ViewportTest, TheLegendOfTwoIsThatOfThePhysicalMesh) {
    Snapshot snapshot = ring_snapshot(8);
    const std::vector<double> errors(snapshot.mesh->cell_count(), 0.5);
    for (const char* name : {"interpolation_error", "interpolation_error_uniform"})
        snapshot.fields.push_back({{.name = name, .place = FieldPlace::cell}, errors});
    snapshot.interpolation = std::make_shared<const InterpolationComparison>();
    view_.set("layout", std::string("side-by-side"));
    view_.set("color", std::string("interpolation_error"));
    const ViewportPlan both = plan(snapshot, view_);
    EXPECT_EQ(both.views[0].scene.colouring->name, "interpolation_error_uniform");
    EXPECT_EQ(both.views[1].scene.colouring->name, "interpolation_error");
    ASSERT_NE(both.colouring, nullptr);
    EXPECT_EQ(both.colouring->name, "interpolation_error");
}

TEST_F(ViewportTest, HomeStaysWhileTheMeshMovesUntilItIsForgotten) {
    Snapshot snapshot = cube_snapshot(3);
    const Camera before = plan(snapshot, view_).views[0].camera;
    for (double& x : snapshot.x.x) x += 5;
    ++snapshot.version;
    EXPECT_EQ(plan(snapshot, view_).views[0].camera, before);
    planner_.forget_home();
    EXPECT_NE(plan(snapshot, view_).views[0].camera, before);
    view_.set("direction", std::string("top"));
    EXPECT_EQ(towards_viewer(plan(snapshot, view_).views[0].camera), (Vec3{0, 0, 1}));
}

TEST_F(ViewportTest, HomeKeepsTheMeshClearOfTheLegend) {
    const ViewportPlan made = plan(ring_snapshot(8), view_);
    const PlannedView& shown = made.views[0];
    const double right = to_pixel(shown.camera, shown.size(), {1, 0, 0}).x;
    EXPECT_LT(right,
              shown.size().width - static_cast<double>(legend_width(*shown.scene.colouring, true, 1)) + 1);
    view_.set("color", std::string("none"));
    EXPECT_NE(plan(ring_snapshot(8), view_).views[0].camera, shown.camera);
}

TEST_F(ViewportTest, TheCameraOfTheViewCounts) {
    view_.set("camera", std::string("centre 0.25 0.75 height 0.5"));
    const Camera camera = plan(ring_snapshot(8), view_).views[0].camera;
    EXPECT_EQ(camera.centre, (Vec3{0.25, 0.75, 0}));
    EXPECT_EQ(camera.scale, 0.5 / 600);
    view_.set("camera", std::string("centre of the world"));
    const ViewportPlan wrong = plan(ring_snapshot(8), view_);
    EXPECT_NE(wrong.complaint.find("'of'"), std::string::npos) << wrong.complaint;
    view_.set("camera", std::string());
    EXPECT_EQ(plan(ring_snapshot(8), view_).views[0].camera, wrong.views[0].camera) << "home instead";
    EXPECT_EQ(plan(ring_snapshot(8), view_).complaint, "");
}

TEST_F(ViewportTest, ThePickFollowsTheMesh) {
    Snapshot snapshot = ring_snapshot(8);
    view_.set("pick", std::string("node 40"));
    const ViewportPlan before = plan(snapshot, view_);
    ASSERT_TRUE(before.pick);
    EXPECT_EQ(before.facts.front().second, "node 40  (4, 4)");
    snapshot.x.x[40] += 0.01;
    ++snapshot.version;
    const ViewportPlan after = plan(snapshot, view_);
    EXPECT_EQ(after.pick, before.pick);
    EXPECT_NE(after.facts, before.facts);
    view_.set("pick", std::string("node 81"));
    EXPECT_FALSE(plan(snapshot, view_).pick) << "the mesh has 81 nodes";
    view_.set("pick", std::string("everything"));
    EXPECT_NE(plan(snapshot, view_).complaint.find("neither a cell nor a node"), std::string::npos);
}

TEST_F(ViewportTest, ArrowsAreMadeAnewOnlyForAnotherCamera) {
    view_.set("arrows", true);
    Snapshot snapshot = ring_snapshot(20);
    const auto first = plan(snapshot, view_).views[0].scene.arrows;
    ASSERT_NE(first, nullptr);
    ++snapshot.version;
    EXPECT_EQ(plan(snapshot, view_).views[0].scene.arrows, first);
    view_.set("camera", std::string("centre 0.5 0.5 height 0.1"));
    EXPECT_NE(plan(snapshot, view_).views[0].scene.arrows, first);
    view_.set("arrows", false);
    EXPECT_EQ(plan(snapshot, view_).views[0].scene.arrows, nullptr);
}

TEST(Legend, TicksAreTheEndsAndRoundValuesThatKeepTheirDistance) {
    const auto labels = [](const ColourRange& range) {
        std::vector<std::string> found;
        for (const Tick& tick : legend_ticks(range)) found.push_back(tick.label);
        return found;
    };
    EXPECT_EQ(labels({1, 11}), (std::vector<std::string>{"2", "4", "6", "8", "10", "1", "11"}));
    EXPECT_EQ(labels({0.01, 100, true}), (std::vector<std::string>{"10⁻¹", "10⁰", "10¹", "0.01", "100"}));
    EXPECT_EQ(labels({1e-17, 0.5}).at(5 - 1), "0") << "what rounding has missed";
    EXPECT_EQ(labels({3, 3}), (std::vector<std::string>{"3"}));
}

} // namespace
} // namespace gaspard
