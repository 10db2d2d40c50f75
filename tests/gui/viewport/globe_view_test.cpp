// Globes and maps in a viewport: cameras, picking, and what the window lets one do with them.
#include "core/base/error.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/check_view.hpp"
#include "fixtures/fixture_catalogue.hpp"
#include "gui/application_fixture.hpp"
#include "gui/globes.hpp"
#include "gui/panels/status_bar.hpp"
#include "gui/plan_fixture.hpp"
#include "support/messages.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

constexpr Size size{800, 600};

std::string picked(const PlannedView& shown, Pixel at) {
    const auto hit = pick_at(shown.scene, shown.camera, shown.size(), at, 8);
    return hit ? format_pick(hit->pick) : "";
}

/// The node in the middle of a square of order 2.
Vec3 middle_of_cell(const Snapshot& snapshot, std::size_t cell) {
    return snapshot.x[static_cast<std::size_t>(snapshot.mesh->cell(cell)[8])];
}

class GlobeTest : public PlanFixture {
  protected:
    GlobeTest() : PlanFixture("sphere", {{0, 0}, {900, 600}}) {}
};

TEST_F(GlobeTest, FrontAndRearTogetherShowEveryCellWhereItIs) {
    view_.set("layout", std::string("front-and-rear"));
    const Snapshot snapshot = xn_globe(cubed_globe(6, 2), 2);
    const ViewportPlan both = plan(snapshot);
    ASSERT_EQ(both.views.size(), 2U);
    EXPECT_EQ(both.views[0].size(), both.views[1].size());
    EXPECT_TRUE(both.views[1].rear);
    EXPECT_EQ(towards_viewer(both.views[1].camera), -1 * towards_viewer(both.views[0].camera));
    EXPECT_EQ(both.views[0].scene.physical, both.views[1].scene.physical) << "nothing is sent twice";
    std::size_t found = 0;
    for (std::size_t cell = 0; cell < snapshot.mesh->cell_count(); ++cell) {
        const Vec3 middle = middle_of_cell(snapshot, cell);
        for (const PlannedView& shown : both.views) {
            if (dot(middle, towards_viewer(shown.camera)) < 0.2) continue;
            ++found;
            Pixel at = to_pixel(shown.camera, shown.size(), middle);
            const std::string node = "node " + std::to_string(snapshot.mesh->cell(cell)[8]);
            EXPECT_EQ(picked(shown, at), node);
            const auto hit = pick_at(shown.scene, shown.camera, shown.size(), at, 0);
            ASSERT_TRUE(hit);
            EXPECT_NEAR(norm(hit->where - middle), 0, 1e-2);
        }
    }
    EXPECT_GT(found, snapshot.mesh->cell_count() * 3 / 4);
}

TEST_F(GlobeTest, TheMapFindsEveryCellAtItsPlace) {
    view_.set("layout", std::string("projection"));
    for (const double longitude : {0.0, 77.0, -180.0}) {
        view_.set("projection_longitude", longitude);
        const Snapshot snapshot = xn_globe(cubed_globe(6, 2), 4);
        const ViewportPlan made = plan(snapshot);
        ASSERT_EQ(made.views.size(), 1U);
        const PlannedView& shown = made.views[0];
        ASSERT_TRUE(shown.scene.projection);
        EXPECT_TRUE(shown.scene.planar());
        for (std::size_t cell = 0; cell < snapshot.mesh->cell_count(); ++cell) {
            const Vec3 place = to_map(*shown.scene.projection, middle_of_cell(snapshot, cell));
            if (place.x * place.x / 8 + place.y * place.y / 2 > 0.97) continue; // rounds to beside the map
            const auto hit = pick_at(shown.scene, shown.camera, shown.size(),
                                     to_pixel(shown.camera, shown.size(), place), 0);
            ASSERT_TRUE(hit) << cell;
            // Without reach only the node in the very middle is nearer than its cell.
            EXPECT_TRUE(hit->pick == (Pick{Pick::Kind::cell, static_cast<std::uint32_t>(cell)}) ||
                        hit->pick.index == static_cast<std::uint32_t>(snapshot.mesh->cell(cell)[8]))
                << cell << ": " << format_pick(hit->pick);
        }
        EXPECT_EQ(picked(shown, {2, 2}), "") << "beside the map";
    }
}

TEST_F(GlobeTest, TheMapIsMadeAnewOnlyForAnotherMesh) {
    view_.set("layout", std::string("projection"));
    Snapshot snapshot = xn_globe(cubed_globe(4, 2), 2);
    const auto first = plan(snapshot).views[0].scene;
    EXPECT_EQ(plan(snapshot).views[0].scene.tessellation, first.tessellation);
    EXPECT_EQ(plan(snapshot).views[0].scene.point_values, first.point_values);
    view_.set("lines", false);
    EXPECT_EQ(plan(snapshot).views[0].scene.physical, first.physical);
    view_.set("blend", 0.5);
    EXPECT_NE(plan(snapshot).views[0].scene.physical, first.physical);
    view_.set("blend", 1.0);
    ++snapshot.version;
    EXPECT_NE(plan(snapshot).views[0].scene.physical, first.physical);
    view_.set("arrows", true);
    EXPECT_EQ(plan(snapshot).views[0].scene.arrows, nullptr) << "a map has none";
}

TEST_F(GlobeTest, MapAndGlobeHaveCamerasOfTheirOwn) {
    const Snapshot snapshot = xn_globe(cubed_globe(4, 2), 2);
    view_.set("camera", std::string("centre 0 0 0 height 1 right 0 1 0 up 0 0 1"));
    view_.set("projection_camera", std::string("centre 1 0.5 height 2"));
    EXPECT_EQ(plan(snapshot).views[0].camera.up, (Vec3{0, 0, 1}));
    view_.set("layout", std::string("projection"));
    EXPECT_EQ(plan(snapshot).views[0].camera.centre, (Vec3{1, 0.5, 0}));
    view_.set("projection_camera", std::string("here"));
    EXPECT_NE(plan(snapshot).complaint, "");
}

TEST_F(GlobeTest, WhatAMeshHasNotIsUnavailableAndNotShown) {
    for (const char* layout : {"projection", "front-and-rear"}) {
        view_.set("layout", std::string(layout));
        const ViewportPlan made = plan(ring_snapshot(6));
        EXPECT_EQ(made.views.size(), 1U);
        EXPECT_FALSE(made.views[0].scene.projection);
        const std::string sentence =
            message_of<InputError>([&] { check_view(view_, ring_snapshot(4).mesh.get()); });
        EXPECT_NE(sentence.find("use single or side-by-side"), std::string::npos) << sentence;
        EXPECT_NO_THROW(check_view(view_, sphere_snapshot(2).mesh.get()));
    }
    const auto unavailable = [&](const Snapshot& snapshot) { // beside what needs time
        std::vector<std::string> choices = plan(snapshot).unavailable;
        EXPECT_EQ(std::erase_if(choices, [](const auto& one) { return one.starts_with("color=mesh_"); }), 4U);
        return choices;
    };
    EXPECT_EQ(unavailable(ring_snapshot(6)),
              (std::vector<std::string>{"layout=front-and-rear", "layout=projection", "overlay=exact"}));
    EXPECT_EQ(unavailable(cube_snapshot(3)), (std::vector<std::string>{"layout=projection", "overlay=exact"}));
    EXPECT_EQ(unavailable(beside_exact_globe(3)), std::vector<std::string>());
    EXPECT_EQ(missing_note(view_, ring_snapshot(4)), "");
    view_.set("overlay", std::string("exact"));
    EXPECT_NE(missing_note(view_, ring_snapshot(4)), "");
    EXPECT_EQ(missing_note(view_, beside_exact_globe(3)), "");
}

TEST_F(GlobeTest, VelocitiesOfTheMeshNeedTime) {
    Snapshot snapshot = ring_snapshot(6);
    view_.set("color", std::string("mesh_velocity_z"));
    EXPECT_EQ(missing_note(view_, snapshot), "view.color = mesh_velocity_z shows nothing: no time passes");
    for (const char* name : {"mesh_speed", "mesh_velocity_x", "mesh_velocity_y"})
        snapshot.fields.push_back({mesh_colour(name), std::vector<double>(snapshot.x.size())});
    EXPECT_EQ(missing_note(view_, snapshot),
              "view.color = mesh_velocity_z shows nothing: the mesh has no such direction");
    const auto choices = plan(snapshot).unavailable;
    EXPECT_EQ(std::ranges::count(choices, "color=mesh_velocity_z"), 1);
    EXPECT_EQ(std::ranges::count(choices, "color=mesh_velocity_y"), 0);
}

TEST_F(GlobeTest, WhatIsPickedIsMarkedOnTheSideWhereItIs) {
    view_.set("layout", std::string("front-and-rear"));
    const Snapshot snapshot = xn_globe(cubed_globe(6, 2), 2);
    const ViewportPlan both = plan(snapshot);
    int beyond = 0;
    for (std::uint32_t cell = 0; cell < snapshot.mesh->cell_count(); ++cell) {
        const Vec3 middle = middle_of_cell(snapshot, cell);
        const auto node = static_cast<std::uint32_t>(snapshot.mesh->cell(cell)[8]);
        int marks = 0;
        for (const PlannedView& shown : both.views) {
            const double facing = dot(middle, towards_viewer(shown.camera));
            EXPECT_EQ(faces_viewer({Pick::Kind::node, node}, shown.scene, shown.camera), facing > 0);
            const bool marked = faces_viewer({Pick::Kind::cell, cell}, shown.scene, shown.camera);
            if (facing > 0) {
                EXPECT_TRUE(marked);
            }
            marks += marked ? 1 : 0;
        }
        if (marks == 1) ++beyond; // cells at the limb are seen from both sides
    }
    EXPECT_GT(beyond, static_cast<int>(snapshot.mesh->cell_count()) / 2);
    EXPECT_TRUE(faces_viewer({Pick::Kind::cell, 0}, plan(ring_snapshot(4)).views[0].scene, {}));
}

TEST_F(GlobeTest, ACameraOfAxesAloneShowsTheWholeBallInAnyLayout) {
    const Snapshot snapshot = xn_globe(cubed_globe(4, 2), 2);
    view_.set("camera", std::string("right -1 0 0 up 0 0 1"));
    for (const char* layout : {"single", "side-by-side", "front-and-rear"}) {
        view_.set("layout", std::string(layout));
        for (const ScreenRect rect : {ScreenRect{{0, 0}, {900, 600}}, {{0, 0}, {300, 700}}}) {
            const PlannedView shown = plan(snapshot, view_, rect).views[0];
            EXPECT_NEAR(norm(towards_viewer(shown.camera) - Vec3{0, 1, 0}), 0, 1e-12);
            const double across = 2 / shown.camera.scale;
            EXPECT_LE(across, std::min(shown.size().width, shown.size().height)) << layout;
            EXPECT_GE(across, 0.45 * std::min(shown.size().width, shown.size().height)) << layout;
        }
    }
}

TEST_F(GlobeTest, TheExactMeshLiesOverTheComputedOne) {
    const Snapshot snapshot = beside_exact_globe(4);
    EXPECT_EQ(plan(snapshot).views[0].scene.overlay, nullptr);
    view_.set("overlay", std::string("exact"));
    const auto overlay = plan(snapshot).views[0].scene.overlay;
    ASSERT_NE(overlay, nullptr);
    EXPECT_EQ(plan(snapshot).views[0].scene.overlay, overlay) << "made once";
    for (std::uint32_t p = 0; p < overlay->tessellation->point_count; ++p)
        if (const auto node = overlay->tessellation->node_of(p)) {
            EXPECT_EQ((*overlay->points)[p], (*snapshot.exact)[*node]);
        }
    view_.set("layout", std::string("side-by-side"));
    EXPECT_EQ(plan(snapshot).views[0].scene.overlay, nullptr) << "not over xi";
    EXPECT_NE(plan(snapshot).views[1].scene.overlay, nullptr);
    view_.set("layout", std::string("projection"));
    const auto mapped = plan(snapshot).views[0].scene.overlay;
    ASSERT_NE(mapped, nullptr);
    EXPECT_EQ((*mapped->points)[0].z, 0);
}

TEST_F(GlobeTest, ItsHomeStaysWhenCellsComeToBeCutFiner) {
    Snapshot snapshot = xn_globe(cubed_globe(30, 2), 16);
    const Points adapted = snapshot.x;
    snapshot.x = snapshot.mesh->nodes;
    const ViewportPlan before = plan(snapshot);
    snapshot.x = adapted;
    ++snapshot.version;
    const ViewportPlan after = plan(snapshot);
    EXPECT_GT(after.views[0].scene.tessellation->cuts, before.views[0].scene.tessellation->cuts);
    EXPECT_EQ(after.views[0].camera, before.views[0].camera);
}

TEST_F(GlobeTest, AnyCameraAndPixelPicksOnTheBallOrNothing) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> part(0, 1);
    const Snapshot snapshot = tangled_globe(6);
    const MeshScene scene = SceneBuilder().make(snapshot, view_);
    for (int i = 0; i < 200; ++i) {
        Camera camera = home(scene.box, size);
        turn_ball(camera, size, {800 * part(random), 600 * part(random)},
                  {800 * part(random), 600 * part(random)}, {}, scene.ball);
        zoom(camera, size, {800 * part(random), 600 * part(random)}, std::exp(3 * normal(random)), scene.box);
        if (i % 3 == 0) camera = from_behind(camera, {});
        const Pixel at{900 * part(random) - 50, 700 * part(random) - 50};
        const auto hit = pick_at(scene, camera, size, at, 8);
        if (!hit) continue;
        EXPECT_TRUE(has(*snapshot.mesh, hit->pick));
        EXPECT_LE(norm(hit->where), 1 + 1e-9);
        EXPECT_NO_THROW(parse_camera(format_camera(camera, size), size));
    }
}

/// The fixture's sphere in the window.
class GlobeApplicationTest : public ApplicationFixture {
  protected:
    GlobeApplicationTest() : GlobeApplicationTest(std::make_shared<Catalogue>(fixture_catalogue())) {}

  private:
    explicit GlobeApplicationTest(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, sphere(*of)) {}
    static Scenario sphere(const Catalogue& catalogue) {
        Scenario scenario = default_scenario(catalogue);
        apply_settings(catalogue, scenario,
                       {"domain.type=sphere", "domain.cells=4", "domain.geometry_order=1",
                        "monitor.type=constant", "method.type=relaxation", "method.step_size=1",
                        "method.max_iterations=3"});
        return scenario;
    }
};

TEST_F(GlobeApplicationTest, TheBallFollowsTheMouseFromFrontAndRear) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    for (const std::size_t which : {0U, 1U}) {
        look().set("layout", std::string("front-and-rear"));
        frame();
        const ItemRectangle area = shown(which).rectangle;
        const Camera before = shown(which).camera;
        const Size here = size_of(shown(which));
        const auto hit = pick_at(shown(which).scene, before, here, {0.5 * here.width, 0.5 * here.height}, 0);
        ASSERT_TRUE(hit);
        ui.drag(area, 0.5F, 0.6F, drawing());
        frame();
        const Pixel now = to_pixel(shown(which).camera, here, (1 / norm(hit->where)) * hit->where);
        EXPECT_NEAR(now.x, 0.6 * here.width, 3) << which;
        EXPECT_NEAR(now.y, 0.5 * here.height, 3) << which;
        EXPECT_NEAR(norm(towards_viewer(shown(0).camera) + towards_viewer(shown(1).camera)), 0, 1e-12)
            << "they look at each other";
        EXPECT_NE(shown(which).camera, before);
    }
}

TEST_F(GlobeApplicationTest, ADoubleClickTurnsAPointToTheFront) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    ItemRectangle spot = shown().rectangle;
    const Camera before = shown().camera;
    const Size here = size_of(shown());
    const float radius = static_cast<float>(1 / before.scale);
    const Pixel middle = to_pixel(before, here, {});
    const float x = std::floor(spot.left + static_cast<float>(middle.x) + 0.5F * radius),
                y = std::floor(spot.top + static_cast<float>(middle.y) + 0.3F * radius);
    const auto hit = pick_at(shown().scene, before, here,
                             {static_cast<double>(x - spot.left), static_cast<double>(y - spot.top)}, 0);
    ASSERT_TRUE(hit);
    spot = {x, y, x, y};
    ui.click(spot, drawing());
    ui.click(spot, drawing());
    frame();
    const Vec3 direction = (1 / norm(hit->where)) * hit->where;
    EXPECT_NEAR(norm(towards_viewer(shown().camera) - direction), 0, 1e-6);
    EXPECT_NEAR(to_pixel(shown().camera, here, {}).x, middle.x, 1e-6)
        << "a ball seen whole stays in its place";
    EXPECT_EQ(look().text("pick"), "");
}

TEST_F(GlobeApplicationTest, SpinsOnlyWhenAskedAndStaysWhereItStops) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    frame();
    const Camera still = shown().camera;
    for (int i = 0; i < 5; ++i) frame();
    EXPECT_EQ(shown().camera, still);
    EXPECT_FALSE(application.window_state().animating);
    EXPECT_TRUE(application.press_key("S"));
    for (int i = 0; i < 30; ++i) frame();
    EXPECT_TRUE(application.window_state().animating);
    const Camera turned = shown().camera;
    const double angle = std::acos(dot(still.right, turned.right)) * 180 / std::numbers::pi;
    EXPECT_NEAR(angle, 12 * 30.0 / 60, 0.6) << "degrees in half a second";
    EXPECT_NEAR(turned.up.z, still.up.z, 1e-12) << "the pole stays up";
    EXPECT_EQ(look().text("camera"), "") << "where one looked from is not lost";
    EXPECT_TRUE(application.press_key("S"));
    frame();
    frame();
    EXPECT_FALSE(application.window_state().animating);
    const Camera stopped = shown().camera;
    EXPECT_GE(dot(turned.right, stopped.right), std::cos(0.02));
    for (int i = 0; i < 5; ++i) frame();
    EXPECT_NEAR(norm(shown().camera.right - stopped.right), 0, 1e-12);
    EXPECT_NE(look().text("camera"), "");
    for (const char* key : {"B", "F", "B"}) {
        EXPECT_TRUE(application.press_key(key));
        frame();
        const Size here = size_of(shown());
        EXPECT_LE(2 / shown().camera.scale, std::min(here.width, here.height)) << "all of it in any layout";
        EXPECT_NEAR(norm(shown().camera.right - stopped.right), 0, 1e-9) << "turned as it was";
    }
    EXPECT_TRUE(application.press_key("S"));
    EXPECT_TRUE(application.press_key("M"));
    frame();
    frame();
    EXPECT_FALSE(application.window_state().animating) << "a map does not turn";
    EXPECT_EQ(look().text("projection_camera"), "");
}

TEST_F(GlobeApplicationTest, KeysChangeTheLayoutAndWhatIsNotThereDoesNothing) {
    ASSERT_TRUE(wait_until([&] { return !application.views().empty(); }));
    EXPECT_TRUE(application.press_key("F"));
    frame();
    EXPECT_EQ(application.views().size(), 2U);
    EXPECT_TRUE(application.press_key("M"));
    frame();
    ASSERT_EQ(application.views().size(), 1U);
    EXPECT_TRUE(shown().scene.projection);
    const std::string copied = (application.press_key("Ctrl+C"), ImGui::GetClipboardText());
    ui.drag(shown().rectangle, 0.4F, 0.6F, drawing());
    EXPECT_NE(look().text("projection_camera"), "");
    EXPECT_EQ(look().text("camera"), "");
    EXPECT_TRUE(application.press_key("Ctrl+V"));
    EXPECT_EQ(look().text("projection_camera"), copied);
    EXPECT_TRUE(application.press_key("H"));
    EXPECT_EQ(look().text("projection_camera"), "");
    EXPECT_TRUE(application.press_key("M"));
    frame();
    EXPECT_FALSE(shown().scene.projection);
    EXPECT_FALSE(application.press_key("X")) << "no exact mesh is known";
    EXPECT_NE(application.messages().last().text.find("Exact mesh"), std::string::npos)
        << application.messages().last().text;
}

TEST_F(GlobeApplicationTest, OffersQuadraticCellsWhereLinearOnesFail) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    const auto offered = [&] { return application.items().find("remedy") != application.items().end(); };
    frame();
    EXPECT_FALSE(offered()) << "nothing has failed";
    EXPECT_EQ(remedy_note(run()), "");
    run().history.back().tangled_cells = 5; // as if
    run().history.back().set("equidistribution", 1);
    EXPECT_NE(remedy_note(run()), "");
    frame();
    ASSERT_TRUE(offered());
    ui.click(application.items().find("remedy")->second, drawing());
    EXPECT_EQ(run().scenario.domain.values.integer("geometry_order"), 2);
    EXPECT_TRUE(wait_until([&] {
        return run().snapshot && run().snapshot->mesh->kind.order == 2 && run().history.size() > 1 &&
               run().ended();
    })) << "and goes on";
    EXPECT_FALSE(application.press_key("Q")) << "they are quadratic already";
    frame();
    EXPECT_FALSE(offered());
}

} // namespace
} // namespace gaspard
