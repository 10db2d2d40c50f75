// Solids that are cut open: scenes, picking, handles of planes, and the actions of the window.
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/snapshot_section.hpp"
#include "core/tessellate/visible_cells.hpp"
#include "fixtures/fixture_catalogue.hpp"
#include "gui/application_fixture.hpp"
#include "gui/plan_fixture.hpp"
#include "gui/scene/section_worker.hpp"
#include "gui/viewport/cut_handles.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace gaspard {
namespace {

class CutPlan : public PlanFixture {
  protected:
    CutPlan() : PlanFixture("cube", {{0, 0}, {900, 700}}) {}
    void set(const std::string& key, const std::string& text) { view_.parse(key, text); }
    MeshScene scene() { return plan(snapshot_).views.front().scene; }
    std::vector<std::uint32_t> shown_cells() {
        std::vector<std::uint32_t> cells = scene().tessellation->triangle_cells;
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        return cells;
    }

    Snapshot snapshot_ = cube_snapshot(6);
};

TEST_F(CutPlan, ACutIsMadeWhereTheMeshIsShown) {
    set("cut", "x 0.45");
    for (const double blend : {0.0, 0.3, 1.0}) {
        view_.set("blend", blend);
        const MeshScene cut = scene();
        ASSERT_GT(cut.tessellation->caps, 0U);
        double highest = -1;
        for (std::uint32_t p : cut.tessellation->triangles)
            highest = std::max(highest, shown_point(cut, p).x);
        EXPECT_NEAR(highest, 0.45, 1e-12) << blend;
    }
    set("layout", "side-by-side");
    const ViewportPlan both = plan(snapshot_);
    for (const PlannedView& shown : both.views) {
        double highest = -1;
        for (std::uint32_t p : shown.scene.tessellation->triangles)
            highest = std::max(highest, shown_point(shown.scene, p).x);
        EXPECT_NEAR(highest, 0.45, 1e-12) << shown.title;
    }
}

TEST_F(CutPlan, TheSceneStaysTheSameWhileNothingChanges) {
    set("cut", "x 0.45");
    const MeshScene first = scene();
    EXPECT_EQ(scene(), first);
    set("cut", "x 0.46");
    const MeshScene moved = scene();
    EXPECT_NE(moved.tessellation, first.tessellation);
    EXPECT_EQ(moved.colouring, first.colouring) << "colours are those of the whole mesh";
    EXPECT_EQ(moved.home_box, first.home_box);
    set("cut", "");
    EXPECT_EQ(scene().tessellation->caps, 0U);
    EXPECT_EQ(scene().nodes, nullptr);
}

TEST_F(CutPlan, TheCameraDoesNotFollowThePlane) {
    const Camera whole = plan(snapshot_).views.front().camera;
    set("cut", "x 0.2");
    EXPECT_EQ(plan(snapshot_).views.front().camera, whole);
    planner_.forget_home();
    const Camera home = plan(snapshot_).views.front().camera;
    EXPECT_NEAR(home.scale, whole.scale, 1e-12);
    EXPECT_NEAR(norm(home.centre - whole.centre), 0, 1e-12);
}

TEST_F(CutPlan, CapsArePickedAndHiddenCellsAreNot) {
    set("cut", "x 0.45");
    set("camera", "centre 0.45 0.5 0.5 height 2 right 0 1 0 up 0 0 1"); // onto the cap
    const ViewportPlan made = plan(snapshot_);
    const PlannedView& shown = made.views.front();
    const auto cells = shown_cells();
    for (int j = 0; j < 6; ++j)
        for (int k = 0; k < 6; ++k) {
            const Vec3 there{0.45, (j + 0.5) / 6, (k + 0.5) / 6};
            const auto hit = pick_at(shown.scene, shown.camera, shown.size(),
                                     to_pixel(shown.camera, shown.size(), there), 0);
            ASSERT_TRUE(hit);
            ASSERT_EQ(hit->pick.kind, Pick::Kind::cell);
            EXPECT_NEAR(hit->where.x, 0.45, 1e-9);
            // The mesh is moved in x alone, so that j and k are known.
            EXPECT_EQ(hit->pick.index / 6, static_cast<std::uint32_t>(6 * k + j));
            EXPECT_TRUE(std::binary_search(cells.begin(), cells.end(), hit->pick.index));
        }
    // Node (6, 0, 0) at the corner that was cut off, and the cell there.
    EXPECT_FALSE(middle_of({Pick::Kind::cell, 5}, shown.scene, shown.camera, shown.size()));
    EXPECT_FALSE(std::binary_search(cells.begin(), cells.end(), 5U));
}

TEST_F(CutPlan, WhatOtherCellsHideIsNotOutlined) {
    set("camera", "right 0 1 0 up 0 0 1"); // from x = infinity
    const auto is_seen = [&](Pick pick) {
        const PlannedView shown = plan(snapshot_).views.front();
        return faces_viewer(pick, shown.scene, shown.camera);
    };
    constexpr std::uint32_t row = 6, front = row - 1; // of cells along x
    const Pick near{Pick::Kind::cell, 2 * row * row + 2 * row + front},
        far{Pick::Kind::cell, 2 * row * row + 2 * row};
    const Pick inner{Pick::Kind::cell, 2 * row * row + 2 * row + 2};
    EXPECT_TRUE(is_seen(near));
    EXPECT_FALSE(is_seen(far)) << "on the far side";
    EXPECT_FALSE(is_seen(inner));
    set("cut", "x 0.45");
    EXPECT_TRUE(is_seen(inner)) << "on the cut face";
    EXPECT_FALSE(is_seen(near)) << "cut off";
    set("cut", "");
    const std::uint32_t nodes = row + 1;
    const std::uint32_t middle = 3 * nodes * nodes + 3 * nodes;
    EXPECT_TRUE(is_seen({Pick::Kind::node, middle + row}));
    EXPECT_FALSE(is_seen({Pick::Kind::node, middle}));
    set("explode", "0.3");
    EXPECT_TRUE(is_seen(near));
    EXPECT_FALSE(is_seen(inner)) << "all of its faces are there, behind others";
}

TEST_F(CutPlan, ConditionsLayersAndPeelsHideCells) {
    EXPECT_EQ(shown_cells().size(), 216U - 64) << "what is seen from outside";
    set("peel", "1");
    EXPECT_EQ(shown_cells().size(), 64U - 8);
    set("peel", "0");
    set("layers", "i 2 to 3; k 5");
    EXPECT_EQ(shown_cells().size(), 12U);
    set("layers", "");
    // The monitor of cube_snapshot() is largest around (0.3, 0, 0.4).
    const std::vector<double> means = corner_means(*snapshot_.mesh, snapshot_.fields[0].values);
    set("only", "monitor > 1.6");
    const auto cells = shown_cells();
    ASSERT_GT(cells.size(), 2U);
    for (const std::uint32_t cell : cells) EXPECT_GT(means[cell], 1.6);
    set("only", "value > 1.6");
    EXPECT_EQ(shown_cells(), cells) << "the colours show the monitor";
    set("color", "area");
    set("only", "value > 1");
    EXPECT_TRUE(scene().tessellation->triangles.empty()) << "no cell is as large";
    EXPECT_EQ(plan(snapshot_).complaint, "view.only leaves nothing to see of the solid");
    EXPECT_EQ(note_on_hidden(snapshot_, view_), plan(snapshot_).complaint);
    set("peel", "1");
    EXPECT_EQ(plan(snapshot_).complaint, "view.peel and view.only leave nothing to see of the solid");
    set("peel", "0");
    set("only", "area > 0.004 and jacobian > 0.5 and monitor < 1.6");
    EXPECT_EQ(scene().tessellation->triangle_cells.empty(), false);
    EXPECT_EQ(plan(snapshot_).complaint, "");
    EXPECT_EQ(note_on_hidden(snapshot_, view_), "");
    set("explode", "0.4");
    set("only", "monitor > 1.6");
    EXPECT_EQ(shown_cells(), cells);
}

TEST_F(CutPlan, TextsThatCannotBeReadHideNothing) {
    for (const auto& [key, text] : {std::pair{"cut", "x"}, {"layers", "l 3"}, {"only", "jacobian"}}) {
        set(key, text);
        const ViewportPlan made = plan(snapshot_);
        EXPECT_NE(made.complaint.find(std::string("view.") + key), std::string::npos) << made.complaint;
        EXPECT_EQ(made.views.front().scene.nodes, nullptr);
        set(key, "");
    }
    EXPECT_EQ(plan(snapshot_).complaint, "");
    set("cut", "x 0.5");
    EXPECT_EQ(missing_note(view_, snapshot_), "");
    EXPECT_NE(missing_note(view_, ring_snapshot(4)).find("view.cut shows nothing"), std::string::npos);
}

TEST_F(CutPlan, AFootMovesThePlaneWithThePointer) {
    set("cut", "normal 1 -1 1 at 0.5 0.5 0.5");
    const auto cut = parse_cut(view_.text("cut"));
    const ViewportPlan made = plan(snapshot_);
    const PlannedView& shown = made.views.front();
    const auto handles = cut_handles(cut, shown, 50);
    ASSERT_EQ(handles.size(), 2U);
    const CutHandle &tip = handles[0], &foot = handles[1];
    EXPECT_TRUE(tip.turns && !foot.turns);
    EXPECT_NEAR(norm(tip.tip - tip.foot), 50 * shown.camera.scale, 1e-12);
    const Vec3 goal = foot.foot + 0.1 * cut[0][0].normal;
    const auto pixel = [&](Vec3 p) { return to_pixel(shown.camera, shown.size(), p); };
    const auto moved = with_cut_handle_at(cut, foot, shown, pixel(foot.foot), pixel(goal));
    EXPECT_NEAR(norm(moved[0][0].at - goal), 0, 2e-4);
    EXPECT_EQ(moved[0][0].normal, cut[0][0].normal);
    // Never out of reach.
    const auto far = with_cut_handle_at(cut, foot, shown, pixel(foot.foot), {9000, -9000});
    EXPECT_GE(plane_in_box(far[0][0], {{-1, -1, -1}, {2, 2, 2}}).size(), 3U);
}

TEST_F(CutPlan, ATipTurnsThePlaneAndSnapsToAxes) {
    set("cut", "x 0.5");
    set("camera", "centre 0.5 0.5 0.5 height 2 right 1 0 0 up 0 0 1"); // the normal is seen from its side
    const auto cut = parse_cut(view_.text("cut"));
    const ViewportPlan made = plan(snapshot_);
    const PlannedView& shown = made.views.front();
    const CutHandle tip = cut_handles(cut, shown, 60).front();
    const Pixel from = to_pixel(shown.camera, shown.size(), tip.tip);
    const auto turned_by = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const Vec3 to = tip.foot + norm(tip.tip - tip.foot) * Vec3{std::cos(angle), 0, std::sin(angle)};
        return with_cut_handle_at(cut, tip, shown, from, to_pixel(shown.camera, shown.size(), to))[0][0];
    };
    for (const double degrees : {20.0, 45.0, 130.0})
        EXPECT_NEAR(std::atan2(turned_by(degrees).normal.z, turned_by(degrees).normal.x),
                    degrees * std::numbers::pi / 180, 1e-6);
    EXPECT_EQ(turned_by(88).normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(turned_by(177).normal, (Vec3{-1, 0, 0}));
    EXPECT_EQ(format_cut({{turned_by(3)}}), "x 0.5");
}

TEST_F(CutPlan, ThePartOfAPlaneInABoxIsAPolygonInOrder) {
    const Box unit{{0, 0, 0}, {1, 1, 1}};
    const auto area = [&](const char* text) {
        const CutPlane plane = parse_cut(text)[0][0];
        const auto points = plane_in_box(plane, unit);
        Vec3 sum;
        for (std::size_t i = 0; i < points.size(); ++i)
            sum = sum + 0.5 * cross(points[i], points[(i + 1) % points.size()]);
        return std::abs(dot(sum, plane.normal));
    };
    EXPECT_NEAR(area("x 0.3"), 1, 1e-12);
    EXPECT_NEAR(area("normal 1 1 1 at 0.5 0.5 0.5"), 0.75 * std::sqrt(3.0), 1e-12);
    EXPECT_LT(plane_in_box(parse_cut("y 2")[0][0], unit).size(), 3U);
}

TEST(SectionWorker, MakesTheLastJobAndReportsIt) {
    const Snapshot snapshot = bent_snapshot(4);
    const auto faces = std::make_shared<const SolidFaces>(solid_faces(*snapshot.mesh));
    SectionJob job{.mesh = snapshot.mesh,
                   .faces = faces,
                   .x = snapshot.x,
                   .visible = std::vector<char>(64, 1),
                   .choice = {.cut = parse_cut("x 0.1")},
                   .pieces = 4};
    SectionWorker worker;
    EXPECT_FALSE(worker.busy());
    worker.post(job);
    job.choice.cut = parse_cut("x 0.2");
    worker.post(job);
    EXPECT_TRUE(worker.busy());
    const Tessellation expected = SectionMaker(snapshot.mesh, faces).make(job.x, job.visible, job.choice, 4);
    std::optional<MadeSection> last;
    for (int i = 0; i < 5000 && worker.busy(); ++i) {
        if (auto made = worker.take()) last = std::move(made);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_TRUE(last && last->tessellation);
    EXPECT_EQ(last->tessellation->triangles, expected.triangles);
    EXPECT_EQ(last->mesh, snapshot.mesh);
}

TEST(SectionWorker, ShowsWhatWasThereUntilTheSectionComes) {
    const Snapshot snapshot = bent_snapshot(16); // in cells that stand apart, too many for a frame
    SceneBuilder builder;
    builder.work_in_background();
    Values values = view("monitor");
    const auto whole = builder.make(snapshot, values).tessellation;
    values.set("explode", 0.5);
    EXPECT_EQ(builder.make(snapshot, values).tessellation, whole);
    EXPECT_TRUE(builder.awaits_section());
    for (int i = 0; i < 5000 && builder.awaits_section(); ++i) {
        builder.make(snapshot, values);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    const MeshScene apart = builder.make(snapshot, values);
    SceneBuilder at_once;
    EXPECT_EQ(apart.tessellation->triangles, at_once.make(snapshot, values).tessellation->triangles);
    EXPECT_EQ(builder.make(snapshot, values), apart);
}

/// Makes scenes until no section is awaited any more; false if that takes too long.
bool settled(SceneBuilder& builder, const Snapshot& snapshot, const Values& values) {
    for (int i = 0; i < 5000 && builder.awaits_section(); ++i) {
        builder.make(snapshot, values);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return !builder.awaits_section();
}

TEST(SectionWorker, IsForgottenWhenTheInsideIsLeft) {
    const Snapshot snapshot = bent_snapshot(16);
    SceneBuilder builder;
    builder.work_in_background();
    Values values = view("monitor");
    const auto whole = builder.make(snapshot, values).tessellation;
    values.set("explode", 0.5);
    builder.make(snapshot, values);
    ASSERT_TRUE(builder.awaits_section());
    values.set("explode", 0.0);
    builder.make(snapshot, values);
    EXPECT_TRUE(settled(builder, snapshot, values)) << "else the window is drawn for ever";
    EXPECT_EQ(builder.make(snapshot, values).tessellation->triangles, whole->triangles);
}

TEST(SectionWorker, ALateSectionDoesNotReplaceANewerOne) {
    const Snapshot snapshot = bent_snapshot(16);
    SceneBuilder builder, at_once;
    builder.work_in_background();
    Values values = view("monitor");
    values.set("explode", 0.5);
    builder.make(snapshot, values);
    ASSERT_TRUE(builder.awaits_section());
    values.set("explode", 0.0);
    values.parse("cut", "x 0.5");
    builder.make(snapshot, values);
    ASSERT_TRUE(settled(builder, snapshot, values));
    const MeshScene shown = builder.make(snapshot, values);
    EXPECT_EQ(shown.tessellation->triangles, at_once.make(snapshot, values).tessellation->triangles);
    EXPECT_GT(shown.tessellation->caps, 0U);
}

/// The fixture's cube in the window.
class CutApplicationTest : public ApplicationFixture {
  protected:
    CutApplicationTest() : CutApplicationTest(std::make_shared<Catalogue>(fixture_catalogue())) {}
    void drag_item(const std::string& name, float x, float y) {
        const ItemRectangle item = application.items().find(name)->second;
        ui.move(item.left, item.top);
        frame();
        ui.button(true);
        frame();
        for (int i = 1; i <= 4; ++i) {
            ui.move(item.left + x * static_cast<float>(i) / 4, item.top + y * static_cast<float>(i) / 4);
            frame();
        }
        ui.button(false);
        frame();
        ui.move_away();
        frame();
    }

  private:
    explicit CutApplicationTest(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, cube(*of)) {}
    static Scenario cube(const Catalogue& catalogue) {
        Scenario scenario = default_scenario(catalogue);
        apply_settings(catalogue, scenario,
                       {"domain.type=cube", "domain.cells=4", "monitor.type=constant",
                        "method.type=relaxation", "method.step_size=1", "method.max_iterations=3"});
        return scenario;
    }
};

TEST_F(CutApplicationTest, KeysOpenFlipAndCloseIt) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    EXPECT_TRUE(application.press_key("I"));
    frame();
    const std::string first = look().text("cut");
    ASSERT_EQ(parse_cut(first).size(), 1U);
    const CutPlane plane = parse_cut(first)[0][0];
    EXPECT_GT(dot(plane.normal, towards_viewer(shown().camera)), 0.5) << "the side of the viewer is hidden";
    EXPECT_GT(shown().scene.tessellation->caps, 0U);
    EXPECT_TRUE(application.press_key("J"));
    frame();
    EXPECT_EQ(parse_cut(look().text("cut"))[0][0].normal, -1 * plane.normal);
    EXPECT_TRUE(application.press_key("J"));
    EXPECT_TRUE(application.press_key("I"));
    frame();
    EXPECT_EQ(look().text("cut"), "");
    EXPECT_TRUE(application.press_key("I"));
    frame();
    EXPECT_EQ(look().text("cut"), first) << "it opens as it was";
}

TEST_F(CutApplicationTest, HandlesMoveAndTurnAPlaneAndADragIsOneEdit) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    look().set("cut", std::string("x 0.5"));
    frame();
    frame();
    const std::string camera = look().text("camera");
    drag_item("cut.0.foot", 40, 10);
    const auto moved = parse_cut(look().text("cut"));
    EXPECT_EQ(moved[0][0].normal, (Vec3{1, 0, 0}));
    EXPECT_GT(std::abs(moved[0][0].at.x - 0.5), 0.01);
    drag_item("cut.0.tip", 0, 35);
    EXPECT_LT(parse_cut(look().text("cut"))[0][0].normal.x, 0.99);
    EXPECT_EQ(look().text("camera"), camera) << "the mesh was not rotated";
    EXPECT_TRUE(application.press_key("Ctrl+Z"));
    frame();
    EXPECT_EQ(look().text("cut"), format_cut(moved));
    EXPECT_TRUE(application.press_key("Ctrl+Z"));
    frame();
    EXPECT_EQ(look().text("cut"), "x 0.5");
}

TEST_F(CutApplicationTest, RowsAreOfferedForSolids) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    show_all_view_rows();
    for (const std::string& key : inside_keys())
        EXPECT_TRUE(application.items().contains("view." + key)) << key;
}

class CutOfPlaneTest : public ApplicationTest {};

TEST_F(CutOfPlaneTest, NothingIsOfferedWithoutASolid) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    show_all_view_rows();
    for (const std::string& key : inside_keys())
        EXPECT_FALSE(application.items().contains("view." + key)) << key;
    application.press_key("I");
    frame();
    EXPECT_EQ(look().text("cut"), "");
}

} // namespace
} // namespace gaspard
