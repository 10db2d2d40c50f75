#include "gui/application_fixture.hpp"
#include "gui/base/actions.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <set>
#include <string>

namespace gaspard {
namespace {

class ActionsTest : public ApplicationTest {
  protected:
    std::span<const Action> actions() const { return application.actions(); }
};

TEST_F(ActionsTest, EveryActionHasNameLabelMenuKeyHelpAndBehaviour) {
    ASSERT_FALSE(actions().empty());
    const std::set<std::string_view> menus = {"File", "Edit", "Solve", "View", "Help"};
    for (const Action& row : actions()) {
        EXPECT_FALSE(row.name.empty());
        EXPECT_FALSE(row.label.empty()) << row.name;
        EXPECT_EQ(menus.count(row.menu), 1U) << row.name;
        EXPECT_FALSE(row.keys.empty()) << row.name;
        EXPECT_GT(row.help.size(), 10U) << row.name;
        EXPECT_EQ(row.help.back(), '.') << row.name;
        EXPECT_EQ(row.toolbar != 0, row.icon != Icon::none) << row.name;
        EXPECT_TRUE(row.run) << row.name;
        EXPECT_FALSE(row.current_label().empty()) << row.name;
        EXPECT_FALSE(row.reason && !row.enabled) << row.name << " has a reason but is never disabled";
    }
}

TEST_F(ActionsTest, NoKeyOrNameIsTakenTwice) {
    std::set<std::string_view> keys, names;
    for (const Action& row : actions()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        for (const auto key : row.keys) EXPECT_TRUE(keys.insert(key).second) << key;
    }
}

TEST_F(ActionsTest, KeysFindTheirAction) {
    for (const Action& row : actions())
        for (const auto key : row.keys) EXPECT_EQ(action_for_key(actions(), key), &row) << key;
    EXPECT_EQ(action_for_key(actions(), "Ctrl+J"), nullptr);
    EXPECT_EQ(find_action(actions(), "run").keys.front(), "Space");
    EXPECT_EQ(describe_keys(find_action(actions(), "step")), "N or Right");
}

TEST_F(ActionsTest, ADisabledActionSaysWhyWhenItsKeyIsPressed) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    int disabled = 0;
    for (const Action& row : actions()) {
        if (row.is_enabled() || !row.reason) continue;
        ++disabled;
        for (const auto key : row.keys) {
            const std::size_t before = application.messages().log().lines().size();
            EXPECT_FALSE(application.press_key(key)) << row.name;
            ASSERT_EQ(application.messages().log().lines().size(), before + 1) << row.name;
            EXPECT_EQ(application.messages().log().lines().back().notice.text, row.why_disabled());
            EXPECT_EQ(application.messages().last().text, row.why_disabled());
            EXPECT_FALSE(application.messages().last().error) << row.name;
            EXPECT_TRUE(row.why_disabled().ends_with(".")) << row.why_disabled();
        }
    }
    EXPECT_GE(disabled, 12)
        << "of a converged run in the plane: six directions, step, runs, projection, spin ...";
}

TEST_F(ActionsTest, ADisabledActionWithoutReasonIsSilent) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    const Action& cancel = find_action(actions(), "cancel");
    ASSERT_FALSE(cancel.is_enabled());
    const std::size_t before = application.messages().log().lines().size();
    EXPECT_FALSE(application.press_key("Escape"));
    EXPECT_EQ(application.messages().log().lines().size(), before);
}

TEST_F(ActionsTest, ToggleActionsChangeTheirCheckMark) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && !application.views().empty(); }));
    for (const char* name : {"sidebar", "plots", "log", "lines", "arrows", "side-by-side", "projector",
                             "fullscreen", "compare"}) {
        const Action& row = find_action(actions(), name);
        const bool before = row.is_checked();
        application.perform(name);
        EXPECT_NE(row.is_checked(), before) << name;
        application.perform(name);
        EXPECT_EQ(row.is_checked(), before) << name;
    }
}

TEST_F(ActionsTest, MarkdownHasOneRowPerAction) {
    const std::string table = actions_markdown(actions());
    for (const Action& row : actions())
        EXPECT_NE(table.find("| " + describe_keys(row) + " | " + std::string(row.label) + " | "),
                  std::string::npos)
            << row.name;
}

TEST_F(ActionsTest, TheDocumentationHasTheTable) {
    std::ifstream file(GASPARD_SOURCE_DIR "/docs/window.md");
    const std::string page((std::istreambuf_iterator<char>(file)), {});
    const std::string table = actions_markdown(actions());
    EXPECT_NE(page.find(table), std::string::npos) << "docs/window.md should contain:\n" << table;
}

} // namespace
} // namespace gaspard
