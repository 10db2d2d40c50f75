// A window whose monitor moves: the section Time, plots, the status bar, going on from a time, paths.
#include "core/scenario/time_rows.hpp"
#include "core/session/time_series.hpp"
#include "gui/application_fixture.hpp"
#include "gui/panels/formula_rows.hpp"

#include <algorithm>

namespace gaspard {
namespace {

class TimeApplicationTest : public ApplicationFixture {
  protected:
    TimeApplicationTest() : TimeApplicationTest(std::make_shared<Catalogue>(builtin_catalogue())) {}
    ItemRectangle item(const std::string& name) {
        const auto found = application.items().find(name);
        EXPECT_NE(found, application.items().end()) << name;
        return found == application.items().end() ? ItemRectangle{} : found->second;
    }
    std::string status_of(const std::string& name) {
        for (const StatusCell& cell : application.status())
            if (cell.label == name) return cell.value;
        return "";
    }

  private:
    explicit TimeApplicationTest(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, moving_ring(*of)) {}
    static Scenario moving_ring(const Catalogue& catalogue) {
        Scenario scenario = find_scenario(catalogue, "plane-ring");
        apply_settings(catalogue, scenario,
                       {"domain.cells=12", "method.type=newton", "time.end=1", "time.step=0.02",
                        "time.monitor.center_x=center_x + t/4"});
        return scenario;
    }
};

TEST_F(TimeApplicationTest, ShowsTheTimeAndPlotsAgainstIt) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    frame();
    EXPECT_EQ(status_of("Time t"), "1");
    EXPECT_NE(status_of("Iterations of the step"), "") << "of the time step";
    EXPECT_EQ(application.items().count("handle.center_x"), 0u) << "the time moves it";
    EXPECT_GT(item("time").width(), 0);
    EXPECT_GT(item("time.end").width(), 0) << "the section is open where there is time";
    const auto steps = std::count_if(run().history.begin(), run().history.end(), is_time_step);
    EXPECT_EQ(steps, 50);
    const SeriesTrace& residual = *run().curves.find("residual");
    ASSERT_EQ(residual.trace.times.size(), 50u);
    EXPECT_NEAR(residual.trace.times[4], 0.1, 1e-12);
    EXPECT_EQ(application.items().count("plot.first.abscissa"), 1u);
}

TEST_F(TimeApplicationTest, TheEquationHasTheValuesOfTheTimeThatIsShown) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto sidebar = [&] { // what is drawn there; all else in it is as at the start
        ui.move_away();
        for (int i = 0; i < 5; ++i) frame();
        std::string bytes;
        const ImDrawData& drawn = *ImGui::GetDrawData();
        for (int i = 0; i < drawn.CmdListsCount; ++i)
            if (const ImDrawList& list = *drawn.CmdLists[i]; std::string(list._OwnerName) == "##sidebar")
                bytes.append(reinterpret_cast<const char*>(list.VtxBuffer.Data),
                             sizeof(ImDrawVert) * static_cast<std::size_t>(list.VtxBuffer.Size));
        return bytes;
    };
    const std::string at_end = sidebar();
    ASSERT_FALSE(at_end.empty());
    for (int i = 0; i < 20; ++i) application.perform("step-back");
    EXPECT_FALSE(sidebar() == at_end);
    application.perform("to-end");
    EXPECT_TRUE(sidebar() == at_end);
}

TEST_F(TimeApplicationTest, AWrongFormulaStaysInItsFieldAndTheLastValidOneInForce) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    ImGui::GetIO().DisplaySize.y = 2000;
    frame(), frame();
    ui.click(item("time.more"), drawing());
    for (int i = 0; i < 3; ++i) frame();
    const std::string key = "time.monitor.center_x", row = "monitor.center_x";
    const auto formula = [&] { return run().scenario.time.text(row); };
    const auto type = [&](const std::string& text) {
        replace_text(item(key), text);
        for (int i = 0; i < 60; ++i) frame(); // a pause
    };
    const auto complaint = [&] { return application.items().contains(key + ".complaint"); };
    const std::string before = formula();
    EXPECT_FALSE(complaint());
    for (const char* wrong : {"center_x + t*", "center_x + q*t", "center_x + x", "1/(t-t)"}) {
        type(wrong);
        EXPECT_TRUE(complaint()) << wrong;
        EXPECT_EQ(formula(), before) << wrong;
        ui.click(item("time"), drawing()); // leaves the field, and closes the section
        for (int i = 0; i < 3; ++i) frame();
        ui.click(item("time"), drawing());
        for (int i = 0; i < 3; ++i) frame();
        EXPECT_TRUE(complaint()) << "what is typed is still there: " << wrong;
        EXPECT_FALSE(application.messages().error().open()) << wrong;
    }
    EXPECT_EQ(run().status.run, RunStatus::converged) << "the solver never saw it";
    type("center_x + t/8");
    EXPECT_FALSE(complaint());
    EXPECT_EQ(formula(), "center_x + t/8");
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    type("center_x +");
    ui.click(item(key + ".reset"), drawing());
    for (int i = 0; i < 3; ++i) frame();
    EXPECT_FALSE(complaint()) << "the arrow takes it back";
    EXPECT_EQ(formula(), "center_x + t/8");
    replace_text(item("time.path"), "0 0.2");
    for (int i = 0; i < 60; ++i) frame();
    EXPECT_TRUE(application.items().contains("time.path.complaint"));
    EXPECT_EQ(run().scenario.time.text("path"), "");
    application.perform("undo");
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(formula(), before) << "what is wrong is no edit";
}

TEST_F(TimeApplicationTest, AComplaintGoesWithItsCause) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    Scenario still = run().scenario;
    set_value(*catalogue, still, "time.monitor.center_x", std::string());
    application.document().change(run().id, still);
    application.document().end_gesture();
    Scenario on_path = still;
    set_value(*catalogue, on_path, "time.path", std::string("0 0.5 0.5; 1 0.6 0.5"));
    application.document().change(run().id, on_path);
    application.document().end_gesture();
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    ImGui::GetIO().DisplaySize.y = 2000;
    frame(), frame();
    ui.click(item("time.more"), drawing());
    for (int i = 0; i < 3; ++i) frame();
    const std::string key = "time.monitor.center_x", row = "monitor.center_x";
    const auto has = [&](const std::string& what) { return application.items().contains(key + what); };
    const auto enter = [&] {
        ui.key(ImGuiKey_Enter, true);
        frame();
        ui.key(ImGuiKey_Enter, false);
        frame();
    };
    replace_text(item(key), "0.5 + 0.1*t");
    enter();
    EXPECT_TRUE(has(".complaint"));
    const auto said = motion_complaint(run().scenario, row, "0.5 + 0.1*t");
    ASSERT_TRUE(said.has_value());
    EXPECT_EQ(said->text, "Path and Centre x(t) both move the monitor; leave one empty");
    application.perform("undo");
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().scenario.time == still.time; }));
    frame(), frame();
    EXPECT_FALSE(has(".complaint")) << "the path is gone";
    EXPECT_TRUE(has(".valid"));
    EXPECT_TRUE(application.document().edits().can_redo());
    ui.click(item(key), drawing());
    enter();
    EXPECT_EQ(run().scenario.time.text(row), "0.5 + 0.1*t");
    for (int i = 0; i < 60; ++i) frame();
    EXPECT_FALSE(has(".valid"));
}

TEST_F(TimeApplicationTest, AnEndThatIsDraggedTooFarOpensNoDialog) {
    Scenario growing = run().scenario;
    set_value(*catalogue, growing, "time.monitor.center_x", std::string());
    set_value(*catalogue, growing, "time.monitor.radius", std::string("radius + t/4"));
    application.document().change(run().id, growing);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    ImGui::GetIO().DisplaySize.y = 2000;
    frame(), frame();
    ui.drag(item("time.end"), 0.1F, 0.9F, drawing());
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_FALSE(application.messages().error().open()) << application.messages().error().sentence();
    EXPECT_LT(run().scenario.time.real("end"), 5);
}

TEST_F(TimeApplicationTest, KeepsTheMethodOfAScenarioWithTime) {
    EXPECT_EQ(for_window(*catalogue, find_scenario(*catalogue, "flow-live")).method.type, "newton");
    EXPECT_EQ(for_window(*catalogue, find_scenario(*catalogue, "plane-ring")).method.type, "auto");
}

TEST_F(TimeApplicationTest, GoesOnFromTheTimeThatIsShown) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_FALSE(application.press_key("Ctrl+G")) << "the newest is shown";
    for (int i = 0; i < 20; ++i) application.perform("step-back");
    frame();
    const double shown = std::stod(status_of("Time t"));
    EXPECT_LT(shown, 0.7);
    EXPECT_TRUE(application.press_key("Ctrl+G"));
    EXPECT_EQ(application.document().runs().size(), 2u) << "what was there is kept";
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    for (int i = 0; i < 20; ++i) frame();
    EXPECT_FALSE(run().wants_to_run) << "values may be changed first";
    EXPECT_EQ(run().history.size(), 1u);
    application.press_key("Space");
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto first = time_of(run().history.front());
    ASSERT_TRUE(first.has_value());
    EXPECT_LE(*first, shown + 1e-9);
    EXPECT_GT(*first, shown - 0.02 * 9) << "one in eight has a state";
    EXPECT_EQ(time_of(run().history.back()), 1.0);
}

TEST_F(TimeApplicationTest, ALongerRunStandsAtTheTimeOfTheFirstTangledMesh) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    application.perform("keep");
    Scenario shorter = run().scenario;
    apply_settings(*catalogue, shorter, {"time.end=0.5", "time.step=0.05"});
    application.document().change(run().id, shorter);
    application.perform("run-again");
    ASSERT_TRUE(wait_until([&] {
        return run().changes.settled() && run().ended() && time_of(run().history.back()) == 0.5 &&
               time_of(run().history.front()) == 0.0;
    }));
    application.perform("runs");
    Snapshot tangled = *run().snapshot; // as if its last mesh were
    tangled.report.tangled_cells = 3;
    run().recording->add(tangled);
    frame();
    ASSERT_EQ(application.views().size(), 2U);
    const auto apart = [&] { // the nodes go with the ring
        const Points &one = *shown(0).scene.physical, &other = *shown(1).scene.physical;
        double farthest = 0;
        for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
            farthest = std::max(farthest, norm(one[i] - other[i]));
        return farthest;
    };
    EXPECT_GT(apart(), 0.02) << "the newest ones, of t = 0.5 and 1";
    application.perform("first-tangled");
    frame();
    EXPECT_EQ(status_of("Time t"), "0.5");
    EXPECT_LT(apart(), 0.002) << "both of t = 0.5";
}

TEST_F(TimeApplicationTest, UndoAfterGoingOnLeavesTheRunThatWasKept) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 12.0);
    application.document().change(run().id, changed);
    application.document().end_gesture();
    application.perform("run-again");
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    for (int i = 0; i < 20; ++i) application.perform("step-back");
    frame();
    ASSERT_TRUE(application.press_key("Ctrl+G"));
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().history.size() == 1; }));
    set_value(*catalogue, changed, "monitor.radius", 0.3);
    application.document().change(run().id, changed);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    const auto kept = [&] {
        return application.document().runs().size() == 2u &&
               application.document().runs()[1].recording != nullptr;
    };
    ASSERT_TRUE(kept());
    const auto amplitude = [&] { return run().scenario.monitor.values.real("amplitude"); };
    application.perform("undo");
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_NE(run().scenario.monitor.values.real("radius"), 0.3);
    EXPECT_EQ(amplitude(), 12.0) << "one thing at a time";
    EXPECT_TRUE(kept());
    application.perform("undo");
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_NE(amplitude(), 12.0);
    ASSERT_TRUE(kept()) << "what was solved after that time would be lost";
    EXPECT_FALSE(application.document().edits().can_undo());
    const DocumentRun& other = application.document().runs()[1];
    EXPECT_EQ(time_of(other.history.back()), 1.0);
    EXPECT_GT(other.recording->iterations().size(), 40u);
    application.document().remove(other.id); // by its cross
    EXPECT_EQ(application.document().runs().size(), 1u);
    application.perform("undo");
    EXPECT_EQ(application.document().runs().size(), 2u);
}

TEST_F(TimeApplicationTest, AValueChangesWhileTimePasses) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "time.end", 2.0);
    set_value(*catalogue, changed, "time.monitor.center_x", std::string("center_x + t/2"));
    application.document().change(run().id, changed);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_EQ(time_of(run().history.back()), 2.0);
    EXPECT_GT(*time_of(run().history.front()), 0.9) << "it goes on from where it was";
    application.perform("undo");
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_EQ(run().scenario.time.real("end"), 1.0);
}

TEST_F(TimeApplicationTest, APathThatIsDrawnMovesTheMonitor) {
    Scenario still = run().scenario;
    set_value(*catalogue, still, "time.end", 0.0);
    set_value(*catalogue, still, "time.monitor.center_x", std::string());
    application.document().change(run().id, still);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    frame();
    EXPECT_TRUE(application.press_key("Ctrl+M"));
    const ItemRectangle centre = item("handle.center_x");
    ui.move(centre.left, centre.top);
    frame();
    ui.button(true);
    frame();
    for (int i = 1; i <= 60; ++i) { // a frame is a sixtieth of a second
        ui.move(centre.left + static_cast<float>(2 * i), centre.top);
        frame();
    }
    ui.button(false);
    for (int i = 0; i < 3; ++i) frame();
    ASSERT_TRUE(has_time(run().scenario.time)) << application.messages().last().text;
    EXPECT_NEAR(run().scenario.time.real("end"), 1, 0.3);
    EXPECT_EQ(run().scenario.monitor, still.monitor);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_EQ(run().status.run, RunStatus::converged);
    EXPECT_EQ(time_of(run().history.back()), run().scenario.time.real("end"));
    application.perform("undo");
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(run().scenario.time, still.time) << "drag and path are one edit";
    EXPECT_EQ(run().scenario.monitor, still.monitor);
    application.perform("redo");
    frame();
    EXPECT_EQ(application.items().count("handle.center_x"), 0u);
    EXPECT_TRUE(application.press_key("Ctrl+M")) << "another path";
    for (int i = 0; i < 3; ++i) frame();
    EXPECT_EQ(application.items().count("handle.center_x"), 1u);
}

TEST_F(TimeApplicationTest, EscapeOrTheSameKeyLeavesPathDrawing) {
    Scenario still = run().scenario; // its centre can be dragged in any case
    set_value(*catalogue, still, "time.end", 0.0);
    application.document().change(run().id, still);
    application.document().end_gesture();
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    const Scenario before = run().scenario;
    const auto said = [&] { return application.messages().last().text; };
    for (const char* key : {"Escape", "Ctrl+M"}) {
        ASSERT_TRUE(application.press_key("Ctrl+M"));
        frame(), frame();
        EXPECT_NE(said().find("along a path"), std::string::npos);
        EXPECT_TRUE(application.press_key(key));
        frame(), frame();
        EXPECT_EQ(said(), "") << key;
        ASSERT_TRUE(application.press_key("Ctrl+M")); // in the middle of the drag
        frame(), frame();
        const ItemRectangle centre = item("handle.center_x");
        ui.move(centre.left, centre.top);
        frame();
        ui.button(true);
        frame();
        for (int i = 1; i <= 60; ++i) {
            ui.move(centre.left + static_cast<float>(i), centre.top);
            frame();
            if (i == 30) {
                EXPECT_TRUE(application.press_key(key));
            }
        }
        ui.button(false);
        frame(), frame();
        ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
        EXPECT_EQ(run().scenario.monitor, before.monitor) << key;
        EXPECT_EQ(run().scenario.time, before.time) << key;
    }
}

TEST_F(TimeApplicationTest, AMovingCentreIsWhereItIsAtTheTimeThatIsShown) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    ASSERT_TRUE(application.press_key("Ctrl+M"));
    frame(), frame();
    const float at_end = item("handle.center_x").left;
    application.perform("to-start");
    for (int i = 0; i < 3; ++i) frame();
    const float at_start = item("handle.center_x").left;
    const double width = static_cast<double>(shown().rectangle.width());
    EXPECT_GT(at_end - at_start, 0.1 * width) << "a quarter of the square";
}

} // namespace
} // namespace gaspard
