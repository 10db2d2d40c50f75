// Undo and redo in the window: which input becomes one edit, keys and the menu.
#include "gui/application_fixture.hpp"
#include "gui/base/actions.hpp"

#include <algorithm>

namespace gaspard {
namespace {

class UndoTest : public ApplicationTest {
  protected:
    void wait_for_mesh() {
        ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
        frame();
    }
    ItemRectangle item(const std::string& key) {
        const auto found = application.items().find(key);
        EXPECT_NE(found, application.items().end()) << key;
        return found == application.items().end() ? ItemRectangle{} : found->second;
    }
    void drag(const std::string& key, float from, float to) { ui.drag(item(key), from, to, drawing()); }
    double amplitude() { return run().scenario.monitor.values.real("amplitude"); }
    std::size_t undo_count() { return application.document().edits().undo_count(); }
    std::string undo_label() { return application.document().edits().undo_label(); }
};

TEST_F(UndoTest, EveryDragOfASliderIsOneEdit) {
    wait_for_mesh();
    const double start = amplitude();
    drag("monitor.amplitude", 0.4F, 0.6F);
    const double between = amplitude();
    drag("monitor.amplitude", 0.6F, 0.7F);
    EXPECT_EQ(undo_count(), 2U) << "eleven frames each";
    EXPECT_EQ(undo_label(), "amplitude");
    EXPECT_TRUE(application.press_key("Ctrl+Z"));
    EXPECT_EQ(amplitude(), between);
    EXPECT_EQ(application.messages().last().text, "Undone: amplitude");
    EXPECT_TRUE(application.press_key("Ctrl+Z"));
    EXPECT_EQ(amplitude(), start);
    EXPECT_EQ(solved_scenario().monitor.values.real("amplitude"), start) << "the solver follows";
    EXPECT_FALSE(application.press_key("Ctrl+Z"));
    EXPECT_EQ(application.messages().last().text, "There is nothing to undo.");
    EXPECT_TRUE(application.press_key("Ctrl+Shift+Z"));
    EXPECT_EQ(application.messages().last().text, "Redone: amplitude");
    EXPECT_EQ(solved_scenario().monitor.values.real("amplitude"), between);
    EXPECT_TRUE(application.press_key("Ctrl+Y"));
    EXPECT_FALSE(application.press_key("Ctrl+Y"));
    EXPECT_EQ(application.messages().last().text, "There is nothing to redo.");
    EXPECT_EQ(undo_count(), 2U);
}

TEST_F(UndoTest, ADragOfAHandleIsOneEdit) {
    wait_for_mesh();
    const ItemRectangle centre = item("handle.center_x");
    const Scenario before = run().scenario;
    for (int drags = 1; drags <= 2; ++drags) {
        const ItemRectangle from = item("handle.center_x");
        ui.move(from.left, from.top);
        frame();
        ui.button(true);
        frame();
        for (int i = 1; i <= 10; ++i) { // along x first, then along y
            ui.move(from.left + static_cast<float>(std::min(i, 5)) * 8,
                    from.top - static_cast<float>(std::max(i - 5, 0)) * 8);
            frame();
        }
        ui.button(false);
        frame(), frame();
        EXPECT_EQ(undo_count(), static_cast<std::size_t>(drags));
    }
    application.press_key("Ctrl+Z"), application.press_key("Ctrl+Z");
    EXPECT_EQ(run().scenario.monitor, before.monitor);
    frame();
    EXPECT_EQ(item("handle.center_x").left, centre.left);
}

TEST_F(UndoTest, DragsOfTheCameraAndBurstsOfTheWheelAreEdits) {
    wait_for_mesh();
    const Camera home = shown().camera;
    drag("viewport", 0.5F, 0.6F);
    frame();
    const Camera panned = shown().camera;
    EXPECT_EQ(undo_count(), 1U);
    EXPECT_EQ(undo_label(), "camera");
    const ItemRectangle view = item("viewport");
    const auto turn_wheel = [&] {
        ui.move(view.left + 0.3F * view.width(), view.center_y());
        for (int i = 0; i < 5; ++i) {
            ui.wheel(1);
            frame();
            frame(); // steps do not come in every frame
        }
    };
    turn_wheel();
    EXPECT_EQ(undo_count(), 2U) << "a burst";
    for (int i = 0; i < 60; ++i) frame(); // a second
    turn_wheel();
    EXPECT_EQ(undo_count(), 3U) << "after a pause another one";
    turn_wheel();
    drag("viewport", 0.3F, 0.35F);
    EXPECT_EQ(undo_count(), 4U);
    for (int i = 0; i < 3; ++i) application.press_key("Ctrl+Z");
    frame();
    EXPECT_EQ(shown().camera.scale, panned.scale);
    EXPECT_EQ(shown().camera.centre, panned.centre);
    application.press_key("Ctrl+Z");
    frame();
    EXPECT_EQ(shown().camera, home);
    frame();
    EXPECT_TRUE(application.document().edits().can_redo()) << "what undo does is no edit";
}

TEST_F(UndoTest, KeysThatChangeTheViewAreEditsAndAPickIsNot) {
    wait_for_mesh();
    const std::string theme = application.window_state().theme_name;
    application.press_key("L");
    application.press_key("T");
    frame();
    ui.click(item("viewport"), drawing());
    EXPECT_NE(look().text("pick"), "");
    EXPECT_EQ(undo_count(), 2U);
    application.press_key("Ctrl+Z");
    frame();
    EXPECT_EQ(application.window_state().theme_name, theme);
    application.press_key("Ctrl+Z");
    EXPECT_TRUE(look().boolean("lines"));
    EXPECT_NE(look().text("pick"), "");
    application.press_key("L"), application.press_key("L");
    frame();
    EXPECT_EQ(look().boolean("lines"), true);
    EXPECT_FALSE(application.document().edits().can_redo());
}

TEST_F(UndoTest, AShortcutIsUndoneBeforeTheNextFrame) {
    wait_for_mesh();
    application.press_key("A");
    EXPECT_TRUE(application.press_key("Ctrl+Z"));
    EXPECT_FALSE(look().boolean("arrows"));
}

TEST_F(UndoTest, InATextFieldCtrlZBelongsToTheField) {
    wait_for_mesh();
    drag("monitor.amplitude", 0.4F, 0.6F);
    const double dragged = amplitude();
    for (int i = 0; i < 30; ++i) frame();
    ui.double_click(item("monitor.amplitude"), drawing());
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    for (const char* key : {"Ctrl+Z", "Ctrl+Y", "Ctrl+Shift+Z"}) EXPECT_FALSE(application.press_key(key));
    EXPECT_EQ(amplitude(), dragged);
    EXPECT_EQ(undo_count(), 1U);
}

TEST_F(UndoTest, StepsByKeysInOneBurstAreOneEdit) {
    wait_for_mesh();
    ui.click(item("monitor.amplitude"), drawing());
    for (int i = 0; i < 40; ++i) frame();
    const double before = amplitude();
    for (int i = 0; i < 5; ++i) {
        ui.key(ImGuiKey_UpArrow, true);
        frame();
        ui.key(ImGuiKey_UpArrow, false);
        for (int k = 0; k < 3; ++k) frame();
    }
    EXPECT_GT(amplitude(), before);
    EXPECT_EQ(undo_count(), 1U);
    for (int i = 0; i < 60; ++i) frame();
    application.press_key("Ctrl+Z");
    EXPECT_EQ(amplitude(), before);
}

TEST_F(UndoTest, TheMenuNamesTheEdit) {
    wait_for_mesh();
    const Action& undo = find_action(application.actions(), "undo");
    const Action& redo = find_action(application.actions(), "redo");
    EXPECT_FALSE(undo.is_enabled());
    EXPECT_EQ(undo.current_label(), "Undo");
    drag("monitor.amplitude", 0.4F, 0.6F);
    EXPECT_EQ(undo.current_label(), "Undo amplitude");
    ui.click(item("menu.Edit"), drawing());
    frame();
    ui.click(item("menu.undo"), drawing());
    EXPECT_EQ(amplitude(), 10);
    EXPECT_EQ(redo.current_label(), "Redo amplitude");
    frame();
    EXPECT_TRUE(redo.is_enabled()) << "the click itself is no edit";
}

TEST_F(UndoTest, KeepingRenamingAndRemovingInTheListAreEdits) {
    wait_for_mesh();
    application.press_key("K");
    frame(), frame();
    ui.click(item("runs.1.name"), drawing());
    ui.type("abc", drawing());
    ui.click(item("viewport"), drawing()); // leaves the field
    frame();
    EXPECT_EQ(undo_count(), 2U) << "three letters";
    const std::string renamed = application.document().runs()[1].name;
    ui.click(item("runs.1.remove"), drawing());
    EXPECT_EQ(application.document().runs().size(), 1U);
    application.press_key("Ctrl+Z");
    ASSERT_EQ(application.document().runs().size(), 2U);
    EXPECT_EQ(application.document().runs()[1].name, renamed);
    application.press_key("Ctrl+Z");
    EXPECT_EQ(application.document().runs()[1].name, "Ring");
    application.press_key("Ctrl+Z");
    EXPECT_EQ(application.document().runs().size(), 1U);
}

TEST_F(UndoTest, WhatTheSolverRefusesLeavesNoEdit) {
    wait_for_mesh();
    Scenario impossible = run().scenario;
    impossible.method.type = "no-such-method";
    application.document().change(run().id, impossible);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && application.messages().error().open(); }));
    EXPECT_EQ(undo_count(), 0U);
    EXPECT_EQ(run().scenario, small_ring());
}

TEST_F(UndoTest, OpeningAScenarioIsUndoneWithItsView) {
    wait_for_mesh();
    application.press_key("T");
    drag("viewport", 0.5F, 0.6F);
    frame();
    const std::string camera = look().text("camera");
    application.document().replace(run().id, find_scenario(*catalogue, "plane-bell"));
    ASSERT_TRUE(wait_until([&] { return run().openings == 1; }));
    frame();
    EXPECT_EQ(application.window_state().theme_name, "light") << "kept";
    EXPECT_EQ(look().text("camera"), "");
    EXPECT_EQ(undo_count(), 3U) << "theme, camera and the opening";
    application.press_key("Ctrl+Z");
    ASSERT_TRUE(wait_until([&] { return run().openings == 2; }));
    frame();
    EXPECT_EQ(application.title(), small_ring().title);
    EXPECT_EQ(look().text("camera"), camera);
    EXPECT_EQ(undo_count(), 2U);
    EXPECT_TRUE(application.document().edits().can_redo());
}

class SpinningUndoTest : public ApplicationFixture {
  protected:
    SpinningUndoTest() : SpinningUndoTest(std::make_shared<Catalogue>(builtin_catalogue())) {}

  private:
    explicit SpinningUndoTest(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, globe(*of)) {}
    static Scenario globe(const Catalogue& catalogue) {
        Scenario scenario = find_scenario(catalogue, "sphere-x2");
        apply_settings(catalogue, scenario, {"domain.cells=4"});
        return scenario;
    }
};

TEST_F(SpinningUndoTest, AMeshThatHasTurnedIsBackWhereItWas) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    frame();
    const Camera before = shown().camera;
    const EditHistory& edits = application.document().edits();
    application.press_key("S");
    for (int i = 0; i < 10; ++i) frame();
    EXPECT_NE(shown().camera, before);
    EXPECT_EQ(edits.undo_count(), 1U) << "the motion is no edit";
    application.press_key("Ctrl+Z");
    frame(), frame();
    EXPECT_EQ(shown().camera, before);
    EXPECT_TRUE(edits.can_redo());

    application.press_key("S");
    for (int i = 0; i < 10; ++i) frame();
    application.press_key("S");
    frame(), frame();
    EXPECT_EQ(edits.undo_count(), 2U) << "stopping keeps the camera, which is one edit";
    application.press_key("Ctrl+Z"), application.press_key("Ctrl+Z");
    frame(), frame();
    EXPECT_EQ(shown().camera, before);
    EXPECT_EQ(look().real("spin"), 0);
}

} // namespace
} // namespace gaspard
