// Dragging centres of monitors and control points.
#include "core/mesh/control_points.hpp"
#include "gui/application_fixture.hpp"
#include "gui/globes.hpp"
#include "gui/panels/viewport_pane.hpp"
#include "gui/plan_fixture.hpp"
#include "gui/viewport/handles.hpp"

#include <cmath>

namespace gaspard {
namespace {

class HandleTest : public PlanFixture {
  protected:
    HandleTest() : PlanFixture("", {{0, 0}, {900, 600}}) {}
    Scenario with(const std::string& name, const std::vector<std::string>& settings) const {
        Scenario scenario = find_scenario(catalogue, name);
        apply_settings(catalogue, scenario, settings);
        return scenario;
    }
    const Catalogue catalogue = builtin_catalogue();
};

TEST_F(HandleTest, EveryPlaceOfAMonitorHasOne) {
    const auto ring = monitor_handles(with("plane-ring", {"monitor.center_x=0.3"}));
    ASSERT_EQ(ring.size(), 1U);
    EXPECT_EQ(ring[0].place, (Vec3{0.3, 0.5, 0}));
    const auto cross = monitor_handles(find_scenario(catalogue, "sphere-cross"));
    ASSERT_EQ(cross.size(), 2U);
    EXPECT_NEAR(norm(cross[0].place - Vec3{std::sqrt(0.75), 0, 0.5}), 0, 1e-12);
    EXPECT_TRUE(monitor_handles(with("plane-ring", {"monitor.type=constant"})).empty());
}

TEST_F(HandleTest, MovesRoundAPeriodicPlaneAndStaysWithinWalls) {
    const Scenario periodic = find_scenario(catalogue, "plane-ring");
    const auto handle = monitor_handles(periodic).front();
    const Scenario moved = with_handle_at(periodic, handle, {1.25, -0.125, 0});
    EXPECT_EQ(moved.monitor.values.real("center_x"), 0.25);
    EXPECT_EQ(moved.monitor.values.real("center_y"), 0.875);
    EXPECT_NO_THROW(check(catalogue, moved));
    const Scenario walls = with_handle_at(find_scenario(catalogue, "walls-ring"), handle, {1.25, -0.125, 0});
    EXPECT_EQ(walls.monitor.values.real("center_x"), 1);
    EXPECT_EQ(walls.monitor.values.real("center_y"), 0);
    const Scenario sphere = find_scenario(catalogue, "sphere-x2");
    const auto pole = monitor_handles(sphere).front();
    for (const Vec3 place : {Vec3{0, 0, 1}, {0, 0, -1}, {-1, 0, 0}, {0.6, -0.8, 0}}) {
        const Scenario there = with_handle_at(sphere, pole, place);
        EXPECT_NEAR(norm(monitor_handles(there).front().place - place), 0, 2e-4);
        EXPECT_NO_THROW(check(catalogue, there));
    }
}

TEST_F(HandleTest, MovesOverAPatchOfAnySizeInStepsThatFitIt) {
    const auto dragged = [&](double side, Vec3 place) {
        const std::string s = format_number(side);
        const Scenario patch =
            with("spline-circle",
                 {"domain.type=spline-patch", R"(domain.file={"degrees":[1,1],"knots":[[0,0,1,1],[0,0,1,1]],)"
                                              R"("control_points":[[0,0],[)" +
                                                  s + ",0],[0," + s + "],[" + s + "," + s + "]]}"});
        const auto handle = monitor_handles(patch).front();
        EXPECT_EQ(handle.place, (Vec3{side / 2, side / 2, 0}));
        return monitor_handles(with_handle_at(patch, handle, place)).front().place;
    };
    EXPECT_EQ(dragged(2000, {1500.04, 300.06, 0}), (Vec3{1500, 300.1, 0}));
    EXPECT_EQ(dragged(0.002, {0.00150004, 0.00030006, 0}), (Vec3{0.0015, 0.0003001, 0}));
}

TEST_F(HandleTest, APixelMeansThePlaceThatIsSeenThere) {
    Handle handle = monitor_handles(find_scenario(catalogue, "plane-ring")).front();
    const PlannedView plane = plan(ring_snapshot(8)).views[0];
    const auto there = pixel_of(handle, plane);
    ASSERT_TRUE(there);
    EXPECT_NEAR(norm(*place_under(handle, plane, *there) - handle.place), 0, 1e-9);

    handle = monitor_handles(find_scenario(catalogue, "sphere-x2")).front();
    EXPECT_FALSE(pixel_of(handle, plane)) << "of another domain";
    const Snapshot globe = xn_globe(cubed_globe(4, 2), 2);
    for (const char* layout : {"single", "projection", "front-and-rear"}) {
        view_.set("layout", std::string(layout));
        int seen = 0;
        for (const PlannedView& shown : plan(globe).views)
            for (int i = 0; i < 12; ++i) {
                const double l = 0.55 * i, p = 0.2 * i - 1.1;
                handle.place = {std::cos(p) * std::cos(l), std::cos(p) * std::sin(l), std::sin(p)};
                const auto pixel = pixel_of(handle, shown);
                if (!pixel) continue;
                ++seen;
                const auto back = place_under(handle, shown, *pixel);
                ASSERT_TRUE(back);
                EXPECT_NEAR(norm((1 / norm(*back)) * *back - handle.place), 0, 1e-6) << layout;
            }
        EXPECT_GE(seen, layout == std::string("single") ? 3 : 12) << layout;
    }
    view_.set("layout", std::string("single"));
    const PlannedView shown = plan(globe).views[0];
    EXPECT_NEAR(norm(*place_under(handle, shown, {0, 0})), 1, 1e-12) << "beside the globe its limb";
    EXPECT_NEAR(dot(*place_under(handle, shown, {0, 0}), towards_viewer(shown.camera)), 0, 1e-12);
}

TEST_F(HandleTest, ControlPointsOfAPatchInThePlane) {
    const auto scenario = with("spline-circle", {"domain.type=spline-patch"});
    Snapshot snapshot = ring_snapshot(4);
    EXPECT_TRUE(domain_handles(scenario, snapshot).empty()) << "of another domain";
    Points corners(4);
    corners.set(1, {1, 0, 0}), corners.set(2, {0, 1, 0}), corners.set(3, {1, 1, 0});
    snapshot.control = std::make_shared<const Points>(corners);
    const auto handles = domain_handles(scenario, snapshot);
    ASSERT_EQ(handles.size(), 4U);
    EXPECT_EQ(item_name(handles[3]), "handle.control_points.3");
    const Scenario moved = with_handle_at(scenario, handles[3], {1.23456789, 0.5, 0});
    EXPECT_EQ(moved.domain.values.text("control_points"), "0 0, 1 0, 0 1, 1.2346 0.5");
    // The next drag goes on from there, also while the snapshot is still the old one.
    EXPECT_EQ(domain_handles(moved, snapshot)[3].place, (Vec3{1.2346, 0.5, 0}));
    Points wide = corners, tiny = corners;
    wide.set(3, {5000, 1000, 0}), tiny.set(1, {1e-5, 0, 0}), tiny.set(2, {0, 1e-5, 0}), tiny.set(3, {});
    Handle other = handles[3];
    other.control = std::make_shared<const Points>(wide);
    EXPECT_EQ(with_handle_at(scenario, other, {1234.5678, 987.654, 0}).domain.values.text("control_points"),
              "0 0, 1 0, 0 1, 1234.6 987.7");
    other.control = std::make_shared<const Points>(tiny);
    const Scenario fine = with_handle_at(scenario, other, {1.23456789e-5, 2e-6, 0});
    const Points read = parse_control_points(fine.domain.values.text("control_points"), 4);
    EXPECT_NEAR(read[3].x, 1.23456789e-5, 1e-9) << "a small patch can be shaped as well";
    EXPECT_NEAR(read[3].y, 2e-6, 1e-9);
    EXPECT_TRUE(
        domain_handles(with("spline-circle", {"domain.type=spline-patch", "domain.control_points=1 2"}),
                       snapshot)
            .empty());
    const PlannedView shown = plan(snapshot).views[0];
    const auto pixel = pixel_of(handles[1], shown);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(norm(*place_under(handles[1], shown, *pixel) - handles[1].place), 0, 1e-9);
}

TEST_F(HandleTest, ConvexDomainsHaveCentresAndPointsOfBothSides) {
    const auto scenario = with("transport-ellipse", {"domain.target.shape=polygon"});
    const auto handles = domain_handles(scenario, ring_snapshot(4));
    ASSERT_EQ(handles.size(), 5U) << "the source's centre, four corners";
    EXPECT_TRUE(handles[0].of_source);
    EXPECT_FALSE(handles[1].of_source);
    EXPECT_EQ(with_handle_at(scenario, handles[0], {0.5, 0.25, 0}).domain.values.real("y"), 0.25);
    EXPECT_EQ(with_handle_at(scenario, handles[1], {-2, -1, 0}).domain.values.text("target.points"),
              "-2 -1, 1 -1, 1 1, -1 1");
    const auto curve = with("transport-ellipse", {"domain.shape=curve"});
    EXPECT_EQ(with_handle_at(curve, handles[0], {0.5, 0.25, 0}), curve) << "the shape was changed meanwhile";
}

/// A viewport alone, with a handle in each corner of a square.
class HeldHandleTest : public HandleTest {
  protected:
    HeldHandleTest() {
        Points corners(4);
        corners.set(1, {1, 0, 0}), corners.set(2, {0, 1, 0}), corners.set(3, {1, 1, 0});
        Snapshot snapshot = ring_snapshot(4);
        snapshot.control = std::make_shared<const Points>(corners);
        scenario_ = with("spline-circle", {"domain.type=spline-patch"});
        handles_ = domain_handles(scenario_, snapshot);
        run_.snapshot = std::make_shared<const Snapshot>(std::move(snapshot));
        run_.scenario = run_.opened = scenario_;
        viewport_.view = view_;
    }
    void frame(std::size_t handles) {
        items_.clear();
        pane_.offer_handles({handles_.begin(), handles_.begin() + static_cast<std::ptrdiff_t>(handles)});
        ui_.frame([&] {
            pane_.frame({&run_, run_.snapshot}, viewport_, {0, 0, 900, 600}, {theme_, 1, items_});
        });
    }

    Scenario scenario_;
    std::vector<Handle> handles_;
    DocumentRun run_;
    DocumentViewport viewport_;
    ItemRectangles items_;
    ViewportPane pane_{std::make_shared<TessellationCache>()};
};

TEST_F(HeldHandleTest, AHandleThatGoesAwayIsLetGo) {
    for (int i = 0; i < 3; ++i) frame(4);
    const ItemRectangle last = items_.at("handle.control_points.3");
    ui_.move(last.left, last.top);
    frame(4);
    ui_.button(true);
    frame(4);
    ui_.move(last.left - 30, last.top + 30);
    frame(4);
    ASSERT_TRUE(pane_.take_handle_move());
    frame(2); // another patch has arrived
    ui_.move(last.left - 60, last.top + 60);
    frame(4);
    EXPECT_FALSE(pane_.take_handle_move()) << "it is another's point";
    ui_.button(false);
    frame(4);
    EXPECT_FALSE(pane_.take_handle_move());
}

using HandleApplicationTest = ApplicationTest;

TEST_F(HandleApplicationTest, TheMeshFollowsADraggedCentre) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    frame();
    const Camera before = shown().camera;
    const ItemRectangle centre = application.items().find("handle.center_x")->second;
    ui.move(centre.left, centre.top);
    frame();
    ui.button(true);
    frame();
    const float step = static_cast<float>(0.02 / before.scale);
    for (int i = 1; i <= 10; ++i) {
        ui.move(centre.left + static_cast<float>(i) * step, centre.top - static_cast<float>(i) * step);
        frame();
    }
    ui.button(false);
    frame();
    frame();
    EXPECT_NEAR(run().scenario.monitor.values.real("center_x"), 0.7, 0.01);
    EXPECT_NEAR(run().scenario.monitor.values.real("center_y"), 0.7, 0.01);
    EXPECT_EQ(shown().camera, before) << "the picture stays";
    EXPECT_EQ(look().text("pick"), "") << "nothing is picked";
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_EQ(run().status.run, RunStatus::converged);
    EXPECT_EQ(run().status.scenario->monitor, run().scenario.monitor);
    const ItemRectangle now = application.items().find("handle.center_x")->second;
    EXPECT_NEAR(now.left, centre.left + 10 * step, 1.5F);

    ui.drag(application.viewport_rectangle(), 0.3F, 0.4F, drawing()); // beside it
    frame();
    EXPECT_NE(shown().camera, before) << "pans as ever";
}

class PatchApplicationTest : public ApplicationFixture {
  protected:
    PatchApplicationTest() : PatchApplicationTest(std::make_shared<Catalogue>(builtin_catalogue())) {}

  private:
    explicit PatchApplicationTest(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, patch(*of)) {}
    static Scenario patch(const Catalogue& catalogue) {
        Scenario scenario = find_scenario(catalogue, "spline-circle");
        apply_settings(catalogue, scenario,
                       {"domain.type=spline-patch", "domain.cells=4", "domain.degree=2"});
        return scenario;
    }
};

TEST_F(PatchApplicationTest, TheControlPointsOfTheDiskAreANetOfThreeByThree) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().snapshot; }));
    EXPECT_EQ(run().snapshot->control_columns, 3U);
    const auto handles = domain_handles(run().scenario, *run().snapshot);
    ASSERT_EQ(handles.size(), 9U);
    EXPECT_EQ(handles[4].columns, 3U);
}

TEST_F(PatchApplicationTest, AFoldStopsAControlPointButNotTheHand) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    frame();
    const auto first = application.items().find("handle.control_points.4");
    const auto last = application.items().find("handle.control_points.8");
    ASSERT_NE(first, application.items().end());
    ASSERT_NE(last, application.items().end());
    const ItemRectangle from = first->second, to = last->second; // the middle, a corner
    const std::size_t lines = application.messages().log().lines().size();
    ui.move(from.left, from.top);
    frame();
    ui.button(true);
    frame();
    for (const float way : {0.1F, 0.2F, 2.5F}) {
        ui.move(from.left + way * (to.left - from.left), from.top + way * (to.top - from.top));
        frame();
        ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    }
    EXPECT_TRUE(run().status.refused);
    EXPECT_NE(application.messages().last().text.find("folds"), std::string::npos)
        << application.messages().last().text;
    EXPECT_FALSE(application.messages().error().open()) << "it would take the handle out of the hand";
    const std::string good = run().scenario.domain.values.text("control_points");
    EXPECT_NE(good, "") << "the last good place";
    EXPECT_EQ(good, run().status.scenario->domain.values.text("control_points"));
    ui.move(from.left + 0.1F * (to.left - from.left), from.top + 0.1F * (to.top - from.top));
    frame();
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_FALSE(run().status.refused) << "the same drag goes on";
    EXPECT_NE(run().scenario.domain.values.text("control_points"), good);
    ui.button(false);
    frame();
    for (std::size_t i = lines; i < application.messages().log().lines().size(); ++i)
        EXPECT_FALSE(application.messages().log().lines()[i].notice.error);

    EXPECT_EQ(application.document().edits().undo_count(), 1U) << "one drag, although some of it was refused";
    Scenario typed = run().scenario; // by other ways the same is an error
    typed.domain.values.set("control_points", std::string("0 0"));
    application.document().change(run().id, typed);
    EXPECT_TRUE(wait_until([&] { return application.messages().error().open() && run().changes.settled(); }));
    EXPECT_EQ(application.document().edits().undo_count(), 1U);
    application.document().undo();
    EXPECT_EQ(run().scenario.domain.values.text("control_points"), "") << "as before the drag";
}

TEST_F(HandleTest, TheNetJoinsNeighbouringControlPoints) {
    // 3 x 2 points, whose net has 4 lines along the first and 3 along the second direction.
    Snapshot snapshot = ring_snapshot(4);
    Points control(6);
    for (std::size_t i = 0; i < 6; ++i)
        control.set(i, {0.5 * static_cast<double>(i % 3), static_cast<double>(i / 3), 0});
    snapshot.control = std::make_shared<const Points>(control);
    const Scenario patch = with("spline-circle", {"domain.type=spline-patch"});
    const ViewportPlan made = plan(snapshot);
    const auto vertices = [&](const std::vector<Handle>& handles, const PlannedView& shown) {
        int count = 0;
        ui_.frame([&] {
            ImDrawList& list = *ImGui::GetForegroundDrawList();
            draw_control_net(handles, list, shown, theme_, 1);
            count = list.VtxBuffer.Size;
        });
        return count;
    };
    EXPECT_EQ(vertices(domain_handles(patch, snapshot), made.views[0]), 0) << "no net";
    snapshot.control_columns = 1;
    const int five = vertices(domain_handles(patch, snapshot), made.views[0]);
    snapshot.control_columns = 3;
    const int seven = vertices(domain_handles(patch, snapshot), made.views[0]);
    EXPECT_GT(five, 0);
    EXPECT_EQ(7 * five, 5 * seven);
    PlannedView computational = made.views[0];
    computational.scene.blend = 0;
    EXPECT_EQ(vertices(domain_handles(patch, snapshot), computational), 0) << "where there are no handles";
}

TEST_F(HandleApplicationTest, AClickOnAHandlePicksWhatLiesBelow) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    frame();
    const Scenario before = run().scenario;
    ui.click(application.items().find("handle.center_x")->second, drawing());
    frame();
    EXPECT_EQ(run().scenario, before);
    EXPECT_NE(look().text("pick"), "");
}

} // namespace
} // namespace gaspard
