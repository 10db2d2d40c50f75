// Contour lines, heights and the computational domain of plane meshes: plans, and what the panel offers.
#include "core/scenario/view_rows.hpp"
#include "gui/application_fixture.hpp"
#include "gui/plan_fixture.hpp"
#include "gui/viewport/handles.hpp"
#include "gui/viewport/legend.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace gaspard {
namespace {

class PlanePlan : public PlanFixture {
  protected:
    PlanePlan() : PlanFixture("square", {{100, 50}, {901, 650}}) {
        view_ = Values("view", view_rows(std::vector<FieldInfo>{{.name = "solution"}}, "solution"));
    }
    Snapshot snapshot_ = corner_layer_snapshot(8, 0.05);
};

TEST_F(PlanePlan, TheComputationalMeshHasTheValuesOfThePhysicalOne) {
    view_.set("layout", std::string("computational"));
    const ViewportPlan one = plan(snapshot_);
    ASSERT_EQ(one.views.size(), 1U);
    EXPECT_EQ(one.views[0].scene.blend, 0);
    view_.set("layout", std::string("side-by-side"));
    const ViewportPlan both = plan(snapshot_);
    ASSERT_EQ(both.views.size(), 2U);
    EXPECT_EQ(one.views[0].scene, both.views[0].scene);
    EXPECT_EQ(both.views[0].scene.point_values, both.views[1].scene.point_values);
}

TEST_F(PlanePlan, HeightsAreSeenByACameraOfTheirOwn) {
    view_.set("camera", std::string("centre 0.25 0.75 height 0.5"));
    const Camera flat = plan(snapshot_).views[0].camera;
    view_.set("elevation", 1.0);
    const ViewportPlan high = plan(snapshot_);
    const Camera home = high.views[0].camera;
    EXPECT_STREQ(camera_key(high.views[0].scene), "elevation_camera");
    EXPECT_LT(towards_viewer(home).z, 0.9) << "seen from the side";
    EXPECT_GT(towards_viewer(home).z, 0.1);
    for (const Points* points : {high.views[0].scene.computational.get(), high.views[0].scene.physical.get()})
        for (std::size_t i = 0; i < points->size(); ++i) {
            const Pixel at = to_pixel(home, high.views[0].size(), (*points)[i]);
            EXPECT_TRUE(at.x > 0 && at.x < 801 && at.y > 0 && at.y < 600) << at.x << ' ' << at.y;
        }
    view_.set("elevation", 3.0);
    EXPECT_NE(plan(snapshot_).views[0].camera, home) << "all of it is still seen";
    view_.set("elevation_camera", std::string("right 1 0 0 up 0 0 1"));
    EXPECT_EQ(towards_viewer(plan(snapshot_).views[0].camera), (Vec3{0, -1, 0}));
    view_.set("elevation", 0.0);
    EXPECT_EQ(plan(snapshot_).views[0].camera, flat) << "where one looked from is not lost";
}

TEST_F(PlanePlan, ASurfaceOfHeightsHasOneSideAndNoHandles) {
    view_.set("elevation", 1.0);
    const ViewportPlan made = plan(snapshot_);
    const auto missing = made.unavailable;
    EXPECT_NE(std::find(missing.begin(), missing.end(), "layout=front-and-rear"), missing.end());
    const Handle handle{.first = "corners", .second = {}, .place = {0.5, 0.5, 0}};
    EXPECT_FALSE(pixel_of(handle, made.views[0]));
    view_.set("elevation", 0.0);
    EXPECT_TRUE(pixel_of(handle, plan(snapshot_).views[0]));
}

TEST_F(PlanePlan, ARowThatShowsNothingIsNoted) {
    const Snapshot interval = layer_snapshot(8, 0.1), globe = sphere_snapshot(2);
    EXPECT_EQ(missing_note(view_, snapshot_), "");
    view_.set("elevation", 1.0);
    EXPECT_EQ(missing_note(view_, snapshot_), "");
    EXPECT_NE(missing_note(view_, interval).find("view.elevation"), std::string::npos);
    EXPECT_NE(missing_note(view_, globe).find("view.elevation"), std::string::npos);
    view_.set("elevation", 0.0);
    view_.set("contours", std::int64_t{10});
    view_.set("color", std::string("monitor"));
    EXPECT_EQ(missing_note(view_, globe), "") << "a sphere has contour lines";
    EXPECT_NE(missing_note(view_, interval).find("view.contours"), std::string::npos);
    view_.set("color", std::string("area"));
    EXPECT_NE(missing_note(view_, snapshot_).find("view.contours"), std::string::npos);
}

TEST_F(PlanePlan, TheLegendHasRoomForTheStepOfTheContours) {
    const Colouring plain = *plan(snapshot_).colouring;
    EXPECT_TRUE(plain.contours.text.empty());
    view_.set("contours", std::int64_t{10});
    const Colouring lined = *plan(snapshot_).colouring;
    EXPECT_EQ(lined.contours.text, "every 0.1");
    ui_.frame([&] {
        const float text = ImGui::CalcTextSize(("contours " + lined.contours.text).c_str()).x;
        EXPECT_GT(legend_width(lined, true, 1), text);
    });
}

class PlaneRows : public ApplicationTest {
  protected:
    bool offers(const std::string& key) {
        frame();
        frame();
        return application.items().count("view." + key) > 0;
    }
};

TEST_F(PlaneRows, AreOfferedWhereTheyShowSomething) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    show_all_view_rows();
    for (const char* key : {"contours", "elevation", "blend", "camera"}) EXPECT_TRUE(offers(key)) << key;
    EXPECT_FALSE(offers("direction"));
    look().set("color", std::string("area"));
    for (const char* key : {"contours", "elevation"}) EXPECT_FALSE(offers(key)) << key;
    look().set("color", std::string("displacement"));
    look().set("elevation", 1.0);
    for (const char* key : {"contours", "elevation", "elevation_camera", "direction", "spin"})
        EXPECT_TRUE(offers(key)) << key;
    EXPECT_FALSE(offers("camera"));
    EXPECT_FALSE(offers("overlay"));
    look().set("layout", std::string("computational"));
    EXPECT_FALSE(offers("blend"));
    EXPECT_EQ(application.views().front().scene.blend, 0);
}

TEST_F(PlaneRows, HeightsAreTurnedWithTheMouseAndUndone) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    const auto rows = run().history.size();
    look().set("elevation", 0.8);
    frame();
    EXPECT_EQ(application.views().front().scene.elevation, 0.8);
    EXPECT_EQ(run().history.size(), rows) << "nothing is solved";
    const Camera home = application.views().front().camera;
    ui.drag(application.items().find("viewport")->second, 0.5F, 0.6F, drawing());
    frame();
    EXPECT_NE(towards_viewer(application.views().front().camera), towards_viewer(home));
    EXPECT_NE(look().text("elevation_camera"), "");
    EXPECT_EQ(look().text("camera"), "");
    EXPECT_TRUE(application.press_key("H"));
    frame();
    EXPECT_EQ(look().text("elevation_camera"), "");
    for (int i = 0; i < 3 && look().real("elevation") > 0; ++i) { // home, the camera, the height
        EXPECT_TRUE(application.press_key("Ctrl+Z"));
        frame();
    }
    EXPECT_EQ(look().real("elevation"), 0);
    EXPECT_TRUE(application.views().front().scene.planar());
}

} // namespace
} // namespace gaspard
