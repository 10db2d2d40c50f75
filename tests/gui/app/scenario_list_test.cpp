#include "core/scenario/toml.hpp"
#include "gui/app/scenario_list.hpp"
#include "gui/application_fixture.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(ScenarioList, EveryBuiltInScenarioHasAGroupAndASentence) {
    const Catalogue catalogue = builtin_catalogue();
    for (const BuiltinScenario& one : builtin_scenarios()) {
        EXPECT_NE(scenario_group(one.name), "Others") << one.name;
        const std::string text =
            short_description(find_scenario(catalogue, std::string(one.name)).description);
        EXPECT_FALSE(text.empty()) << one.name;
        EXPECT_EQ(text.find("McRae"), std::string::npos) << text << ": sources are in the tooltip";
    }
    EXPECT_EQ(short_description("Rings around the middle (Bahari, example 7.3)."), "Rings around the middle");
}

class ScenarioListTest : public ApplicationTest {};

TEST_F(ScenarioListTest, WhatIsTypedNarrowsItDown) {
    frame();
    ui.click(application.items().find("scenario")->second, drawing());
    for (int i = 0; i < 4; ++i) frame();
    EXPECT_TRUE(application.items().count("scenario=plane-bell"));
    EXPECT_TRUE(application.items().count("scenario=sphere-x4"));
    ASSERT_TRUE(ImGui::GetIO().WantTextInput) << "one can type at once";
    ui.type("mobius", drawing());
    frame();
    EXPECT_TRUE(application.items().count("scenario=spline-moebius")) << "without the dots, too";
    EXPECT_FALSE(application.items().count("scenario=plane-bell"));
}

TEST_F(ScenarioListTest, AScenarioIsFoundByItsNameAndOpened) {
    frame();
    ui.click(application.items().find("scenario")->second, drawing());
    for (int i = 0; i < 4; ++i) frame();
    ui.type("X16", drawing());
    frame();
    frame();
    EXPECT_FALSE(application.items().count("scenario=plane-bell"));
    ASSERT_TRUE(application.items().count("scenario=sphere-x16"));
    ui.click(application.items().find("scenario=sphere-x16")->second, drawing());
    ASSERT_TRUE(wait_until([&] { return run().scenario.name == "sphere-x16"; }));
}

TEST_F(ScenarioListTest, ArrowKeysAndEnterChoose) {
    frame();
    ui.click(application.items().find("scenario")->second, drawing());
    for (int i = 0; i < 4; ++i) frame();
    const auto press = [&](ImGuiKey key) {
        ui.key(key, true);
        frame();
        ui.key(key, false);
        frame();
    };
    const auto place = [&](const char* name) { return application.items().find(name)->second; };
    const ItemRectangle bell = place("scenario=plane-bell"), combine = place("scenario=plane-combine");
    EXPECT_EQ(bell.top, combine.top) << "cards beside each other";
    EXPECT_GT(combine.left, bell.center_x());
    EXPECT_GT(place("scenario=walls-ring").top, bell.center_y());
    for (const ImGuiKey key :
         {ImGuiKey_DownArrow, ImGuiKey_RightArrow, ImGuiKey_RightArrow, ImGuiKey_LeftArrow, ImGuiKey_UpArrow})
        press(key);
    press(ImGuiKey_Enter);
    ASSERT_TRUE(wait_until([&] { return run().scenario.name == "plane-combine"; })) << run().scenario.name;
    EXPECT_FALSE(application.items().count("scenario=plane-bell")) << "the list is closed";
}

TEST_F(ScenarioListTest, TheFirstKeyMarksTheFirstCardAlsoIfFramesAreSlow) {
    frame();
    ui.click(application.items().find("scenario")->second, drawing());
    for (int i = 0; i < 4; ++i) frame();
    ImGui::GetIO().DeltaTime = 0.6F; // longer than a key is held before it repeats
    ui.key(ImGuiKey_DownArrow, true);
    frame();
    frame();
    ui.key(ImGuiKey_DownArrow, false);
    frame();
    ImGui::GetIO().DeltaTime = 1.0F / 60;
    ui.key(ImGuiKey_Enter, true);
    frame();
    ui.key(ImGuiKey_Enter, false);
    const std::string first = "plane-bell";
    ASSERT_TRUE(wait_until([&] { return run().scenario.name == first; })) << run().scenario.name;
}

TEST_F(ScenarioListTest, EnterOpensTheFirstThatMatches) {
    frame();
    ui.click(application.items().find("scenario")->second, drawing());
    for (int i = 0; i < 4; ++i) frame();
    ui.type("x16", drawing());
    frame();
    ui.key(ImGuiKey_Enter, true);
    frame();
    ui.key(ImGuiKey_Enter, false);
    ASSERT_TRUE(wait_until([&] { return run().scenario.name == "sphere-x16"; }));
}

TEST_F(ScenarioListTest, OneEscapeClosesIt) {
    frame();
    EXPECT_FALSE(application.window_state().awaits_text);
    ui.click(application.items().find("scenario")->second, drawing());
    bool awaited = application.window_state().awaits_text;
    for (int i = 0; i < 4; ++i) {
        frame();
        awaited = awaited || application.window_state().awaits_text;
    }
    EXPECT_TRUE(awaited) << "letters wait until its field takes them";
    EXPECT_FALSE(application.window_state().awaits_text);
    ASSERT_TRUE(application.items().count("scenario.search"));
    ui.key(ImGuiKey_Escape, true);
    frame();
    ui.key(ImGuiKey_Escape, false);
    frame();
    EXPECT_FALSE(application.items().count("scenario.search"));
}

TEST_F(ScenarioListTest, KeysAreNotMeantForTheNumberBehindIt) {
    ASSERT_TRUE(wait_until([&] { return run().snapshot != nullptr; }));
    frame();
    ui.click(application.items().find("monitor.sharpness")->second, drawing());
    frame();
    const double before = run().scenario.monitor.values.real("sharpness");
    const auto press_down = [&] {
        for (int i = 0; i < 2; ++i) {
            ui.key(ImGuiKey_DownArrow, true);
            frame();
            ui.key(ImGuiKey_DownArrow, false);
            frame();
        }
    };
    ui.click(application.items().find("monitor.type")->second, drawing()); // a list without a text field
    for (int i = 0; i < 4; ++i) frame();
    press_down();
    EXPECT_EQ(run().scenario.monitor.values.real("sharpness"), before);
    application.press_key("Escape");
    for (int i = 0; i < 3; ++i) frame();
    press_down();
    EXPECT_LT(run().scenario.monitor.values.real("sharpness"), before) << "now they are";
}

TEST_F(ScenarioListTest, PicturesComeWithinAFewFrames) {
    frame();
    ui.click(application.items().find("scenario")->second, drawing());
    int frames = 0;
    for (frame(); application.window_state().animating && frames < 30; ++frames) frame();
    EXPECT_LT(frames, 10);
}

} // namespace
} // namespace gaspard
