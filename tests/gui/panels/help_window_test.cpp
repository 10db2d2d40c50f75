#include "core/base/version.hpp"
#include "gui/headless_ui.hpp"
#include "gui/panels/help_window.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

std::vector<Action> some_actions() {
    return {
        {.name = "save", .label = "Save", .menu = "File", .keys = {"Ctrl+S"}, .help = "Save a scenario."},
        {.name = "undo", .label = "Undo", .menu = "Edit", .keys = {"Ctrl+Z"}, .help = "Take a change back."}};
}

std::vector<std::string_view> titles(std::string_view search) {
    const auto actions = some_actions();
    std::vector<std::string_view> found;
    for (const HelpGroup& group : help_groups(actions, search)) found.push_back(group.title);
    return found;
}

TEST(HelpGroups, AreTheMenusAndTheMouse) {
    using Titles = std::vector<std::string_view>;
    EXPECT_EQ(titles(""), (Titles{"File", "Edit", "Mouse"}));
    EXPECT_EQ(titles("SCENARIO save"), (Titles{"File"})) << "every word, in any case";
    EXPECT_EQ(titles("ctrl+z"), (Titles{"Edit"}));
    EXPECT_EQ(titles("wheel zoom"), (Titles{"Mouse"}));
    EXPECT_TRUE(titles("nothing of the kind").empty());
}

TEST(HelpWindow, FindsWhatIsTyped) {
    HeadlessUi ui;
    ItemRectangles items;
    HelpWindow window;
    const auto actions = some_actions();
    const auto draw = [&] { window.draw(actions, dark_theme(), items); };
    ui.frame(draw);
    EXPECT_FALSE(items.contains("help.search"));
    window.toggle();
    ui.frame(draw);
    ASSERT_TRUE(items.contains("help.search"));
    for (int i = 0; i < 3; ++i) ui.frame(draw);
    ASSERT_TRUE(items.contains("help.Edit"));
    ui.type("save", draw);
    items.clear();
    ui.frame(draw);
    EXPECT_TRUE(items.contains("help.File"));
    EXPECT_FALSE(items.contains("help.Edit")) << "it does not match";
    const auto escape = [&] {
        ui.key(ImGuiKey_Escape, true);
        ui.frame(draw);
        ui.key(ImGuiKey_Escape, false);
        ui.frame(draw);
    };
    escape();
    EXPECT_FALSE(window.open()) << "although the field takes the key as well";
    window.toggle();
    EXPECT_TRUE(window.open());
    window.toggle();
    EXPECT_FALSE(window.open());
}

TEST(AboutWindow, HasTheVersion) {
    const auto lines = about_lines();
    EXPECT_TRUE(std::ranges::any_of(lines, [](const auto& line) { return line.second == version(); }));
    HeadlessUi ui;
    ItemRectangles items;
    AboutWindow window;
    window.toggle();
    ui.frame([&] { window.draw(dark_theme(), items); });
    EXPECT_TRUE(items.contains("about.copy"));
}

} // namespace
} // namespace gaspard
