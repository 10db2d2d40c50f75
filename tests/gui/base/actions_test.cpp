#include "gui/base/actions.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <set>
#include <string>

namespace gaspard {
namespace {

TEST(Actions, EveryActionHasNameLabelMenuKeyAndHelp) {
    ASSERT_FALSE(actions().empty());
    for (const Action& row : actions()) {
        EXPECT_FALSE(row.name.empty());
        EXPECT_FALSE(row.label.empty()) << row.name;
        EXPECT_FALSE(row.menu.empty()) << row.name;
        EXPECT_FALSE(row.keys.empty()) << row.name;
        EXPECT_GT(row.help.size(), 10U) << row.name;
        EXPECT_EQ(row.help.back(), '.') << row.name;
    }
}

TEST(Actions, NoKeyNameOrIdIsTakenTwice) {
    std::set<std::string_view> keys, names;
    std::set<ActionId> ids;
    for (const Action& row : actions()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_TRUE(ids.insert(row.id).second) << row.name;
        for (const auto key : row.keys) EXPECT_TRUE(keys.insert(key).second) << key;
    }
}

TEST(Actions, KeysFindTheirAction) {
    for (const Action& row : actions())
        for (const auto key : row.keys) {
            ASSERT_NE(action_for_key(key), nullptr) << key;
            EXPECT_EQ(action_for_key(key)->id, row.id) << key;
        }
    EXPECT_EQ(action_for_key("Ctrl+J"), nullptr);
    EXPECT_EQ(action(ActionId::run_pause).keys.front(), "Space");
    EXPECT_EQ(describe_keys(action(ActionId::step)), "N or Right");
}

TEST(Actions, MarkdownHasOneRowPerAction) {
    const std::string table = actions_markdown();
    for (const Action& row : actions())
        EXPECT_NE(table.find("| " + describe_keys(row) + " | " + std::string(row.label) + " | "),
                  std::string::npos)
            << row.name;
}

TEST(Actions, TheDocumentationHasTheTable) {
    std::ifstream file(GASPARD_SOURCE_DIR "/docs/window.md");
    const std::string page((std::istreambuf_iterator<char>(file)), {});
    EXPECT_NE(page.find(actions_markdown()), std::string::npos)
        << "docs/window.md should contain:\n"
        << actions_markdown();
}

} // namespace
} // namespace gaspard
