#include "gui/headless_ui.hpp"
#include "gui/panels/run_list.hpp"
#include "gui/run_fixtures.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

const Action keep_action{.name = "keep", .label = "Keep", .keys = {"K"}, .help = "Keep this run."};

class RunListTest : public testing::Test {
  protected:
    RunListTest() {
        for (const char* name : {"first", "second", "third"}) add_made_up_run(document, name, 5);
    }
    std::function<void()> drawing() {
        return [this] {
            items.clear();
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({400, 600});
            ImGui::Begin("runs", nullptr, ImGuiWindowFlags_NoDecoration);
            keep = list.draw(document, keep_action, {theme, 1, items}) || keep;
            ImGui::End();
        };
    }
    void frame() { ui.frame(drawing()); }
    void click(const std::string& key) {
        const auto found = items.find(key);
        ASSERT_NE(found, items.end()) << key;
        ui.click(found->second, drawing());
    }
    void press(ImGuiKey key) {
        ui.key(key, true);
        frame();
        ui.key(key, false);
        frame();
    }
    const std::string& name(std::size_t run) { return document.runs()[run].name; }

    Theme theme = dark_theme();
    HeadlessUi ui{900, 900, &theme};
    Document document{std::make_shared<Catalogue>(builtin_catalogue()), {}};
    ItemRectangles items;
    RunList list;
    bool keep = false;
};

TEST_F(RunListTest, HidesAndShows) {
    frame(), frame();
    click("runs.1.eye");
    EXPECT_TRUE(document.runs()[1].hidden);
    EXPECT_FALSE(document.runs()[0].hidden);
    click("runs.1.eye");
    EXPECT_FALSE(document.runs()[1].hidden);
}

TEST_F(RunListTest, RenamesInPlace) {
    frame(), frame();
    click("runs.1.name");
    press(ImGuiKey_End);
    ui.type(" try", drawing());
    EXPECT_EQ(name(1), "second try") << "while it is being typed";
    press(ImGuiKey_Enter);
    EXPECT_EQ(name(1), "second try");
    EXPECT_EQ(name(0), "first");
}

TEST_F(RunListTest, ARunIsNeverWithoutAName) {
    document.runs()[1].name.assign(1, 'x');
    frame(), frame();
    click("runs.1.name");
    press(ImGuiKey_End);
    press(ImGuiKey_Backspace);
    press(ImGuiKey_Enter);
    frame();
    EXPECT_EQ(name(1), "x");
}

TEST_F(RunListTest, RemovesTheOneThatIsMeant) {
    frame(), frame();
    click("runs.1.remove");
    ASSERT_EQ(document.runs().size(), 2U);
    EXPECT_EQ(name(0), "first");
    EXPECT_EQ(name(1), "third");
}

TEST_F(RunListTest, AsksToKeepTheLiveRun) {
    frame(), frame();
    EXPECT_FALSE(keep);
    click("runs.keep");
    EXPECT_TRUE(keep);
}

TEST_F(RunListTest, NamesOfAnyLengthAndKindAreFine) {
    document.runs()[0].name = std::string(5000, 'a');
    document.runs()[1].name.clear();
    for (int i = 0; i < 300; ++i) document.runs()[1].name += "ä";
    document.runs()[2].name.clear();
    frame(), frame();
    click("runs.1.name");
    press(ImGuiKey_End);
    ui.type("b", drawing());
    EXPECT_FALSE(name(1).empty());
}

} // namespace
} // namespace gaspard
