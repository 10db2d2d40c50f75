#include "gui/headless_ui.hpp"
#include "gui/panels/formula_field.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {
namespace {

TEST(FormulaText, IsBrokenAtBlanksOnly) {
    EXPECT_EQ(broken_at_blanks("1 + 10*exp(-50*r) + sin(x)", 12), "1 +\n10*exp(-50*r)\n+ sin(x)");
    EXPECT_EQ(broken_at_blanks("1+10*exp(-50*r)", 5), "1+10*exp(-50*r)") << "there is no blank";
    EXPECT_EQ(broken_at_blanks("a\nb c", 3), "a\nb c") << "a line that fits";
    EXPECT_EQ(broken_at_blanks("αβγδ εζ", 5), "αβγδ\nεζ") << "letters, not bytes";
    const std::string formula = "1 + A*sech(B*(dist(x0, y0)^2 - r^2))^2 + sin(pi*x)";
    for (const std::size_t columns : {4U, 10U, 30U, 100U})
        EXPECT_EQ(in_one_line(broken_at_blanks(formula, columns)), formula) << columns;
}

TEST(FormulaText, AnExcerptShowsThePlace) {
    const FormulaExcerpt sine = excerpt_at("1 + 10*sine(x)", 8, 4);
    EXPECT_EQ(sine.before, "... 10*");
    EXPECT_EQ(sine.place, "sine");
    EXPECT_EQ(sine.after, "(x)");
    EXPECT_EQ(excerpt_at("α + )", 5, 10).place, ")");
    EXPECT_EQ(excerpt_at("1 +", 4, 10).place, " ") << "the end";
    EXPECT_EQ(excerpt_at("1 +", 4, 10).before, "1 +");
    EXPECT_EQ(excerpt_at("(1 + 2 + 3 + 4", 1, 3).after, "1 +...");
}

TEST(FormulaText, AFunctionIsInsertedUpToItsParenthesis) {
    EXPECT_EQ(inserted_text({"atan2(y, x)", "", true}), "atan2(");
    EXPECT_EQ(inserted_text({"lat", "", false}), "lat");
}

/// A field whose formulas must not have the word "bad" unless it is known.
class FormulaFieldTest : public testing::Test {
  protected:
    std::optional<FormulaComplaint> check(const std::string& text) const {
        const auto at = text.find("bad");
        ++checks;
        if (at == std::string::npos || bad_is_known) return std::nullopt;
        return FormulaComplaint{"bad is unknown", at + 1};
    }
    void draw() {
        items.clear();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({380, 600});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
        const FormulaField::Context context{.theme = theme,
                                            .items = items,
                                            .words = words,
                                            .check = [this](const auto& text) { return check(text); },
                                            .situation = bad_is_known ? 1U : 0U};
        field.draw_help("f", context);
        if (const auto applied = field.draw("f", value, context)) {
            value = *applied;
            edits.push_back(*applied);
        }
        ImGui::Button("elsewhere");
        remember_item(items, "elsewhere");
        ImGui::End();
    }
    std::function<void()> drawing() {
        return [this] { draw(); };
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) ui.frame(drawing());
    }
    void rest() { frames(45); } // longer than the pause
    /// Into the field, instead of what it holds.
    void begin() {
        frames(2);
        ui.click(items.at("f"), drawing());
        ui.control(true);
        ui.key(ImGuiKey_A, true);
        frames(1);
        ui.key(ImGuiKey_A, false);
        ui.control(false);
        frames(1);
    }

    HeadlessUi ui;
    Theme theme = dark_theme();
    ItemRectangles items;
    FormulaField field;
    std::string value = "1 + x";
    bool bad_is_known = false;
    mutable int checks = 0;
    std::vector<std::string> edits;
    std::vector<FormulaWord> words = {{"lat", "latitude", false}, {"sin(t)", "sine", true}};
};

TEST_F(FormulaFieldTest, APauseInTypingAppliesTheFormulaOnce) {
    begin();
    ui.type("2*y", drawing());
    EXPECT_TRUE(edits.empty()) << "while one types";
    EXPECT_TRUE(field.waiting());
    rest();
    EXPECT_EQ(edits, std::vector<std::string>{"2*y"});
    EXPECT_FALSE(field.waiting()) << "nothing is to come";
    ui.type("+1", drawing());
    rest();
    EXPECT_EQ(edits, (std::vector<std::string>{"2*y", "2*y+1"})) << "the field kept the keyboard";
}

TEST_F(FormulaFieldTest, EnterAppliesAtOnce) {
    begin();
    ui.type("3", drawing());
    ui.key(ImGuiKey_Enter, true);
    frames(1);
    ui.key(ImGuiKey_Enter, false);
    frames(1);
    EXPECT_EQ(edits, std::vector<std::string>{"3"});
}

TEST_F(FormulaFieldTest, AWrongFormulaIsSaidBelowTheFieldAndTheValueStays) {
    begin();
    ui.type("1+bad", drawing());
    frames(3);
    EXPECT_FALSE(items.count("f.complaint")) << "not while one types";
    rest();
    ASSERT_TRUE(items.count("f.complaint"));
    EXPECT_GE(items.at("f.complaint").top, items.at("f").bottom);
    EXPECT_EQ(value, "1 + x");
    ui.click(items.at("elsewhere"), drawing());
    rest();
    EXPECT_TRUE(items.count("f.complaint")) << "it is still in the field";
    EXPECT_TRUE(field.has_draft("f"));
    begin();
    ui.type("1+good", drawing());
    rest();
    EXPECT_FALSE(items.count("f.complaint"));
    EXPECT_EQ(edits, std::vector<std::string>{"1+good"});
}

TEST_F(FormulaFieldTest, WhatTheSolverRefusesStaysInTheFieldWithItsReason) {
    begin();
    ui.type("-1", drawing());
    rest();
    ASSERT_EQ(value, "-1");
    value = "1 + x"; // as the document takes it back
    field.refuse("f: m must be positive");
    frames(2);
    EXPECT_TRUE(items.count("f.complaint"));
    EXPECT_TRUE(field.has_draft("f"));
    field.restore("f");
    frames(2);
    EXPECT_FALSE(items.count("f.complaint"));
    EXPECT_EQ(edits.size(), 1U);
}

TEST_F(FormulaFieldTest, OtherValuesMakeAFormulaValidAndEnterAppliesIt) {
    begin();
    ui.type("1+bad", drawing());
    rest();
    ui.click(items.at("elsewhere"), drawing());
    rest();
    ASSERT_TRUE(items.count("f.complaint"));
    const int before = checks;
    rest();
    EXPECT_EQ(checks, before) << "it is checked only when something changes";
    bad_is_known = true;
    frames(2);
    EXPECT_FALSE(items.count("f.complaint"));
    EXPECT_TRUE(items.count("f.valid"));
    rest();
    EXPECT_TRUE(edits.empty()) << "an edit made now would end what can be redone";
    bad_is_known = false;
    frames(2);
    EXPECT_TRUE(items.count("f.complaint"));
    EXPECT_FALSE(items.count("f.valid"));
    bad_is_known = true;
    ui.click(items.at("f"), drawing());
    ui.key(ImGuiKey_Enter, true);
    frames(1);
    ui.key(ImGuiKey_Enter, false);
    rest();
    EXPECT_EQ(edits, std::vector<std::string>{"1+bad"});
    EXPECT_FALSE(items.count("f.valid"));
}

TEST_F(FormulaFieldTest, UndoShowsTheFormulaBefore) {
    begin();
    ui.type("5", drawing());
    rest();
    ui.click(items.at("elsewhere"), drawing());
    frames(2);
    EXPECT_FALSE(field.has_draft("f"));
    value = "1 + x";
    rest();
    EXPECT_EQ(edits.size(), 1U) << "it is not applied again";
}

TEST_F(FormulaFieldTest, AWordOfTheListIsInsertedWhereTheCursorWas) {
    begin();
    ui.type("2*", drawing());
    rest();
    ui.click(items.at("f.help"), drawing());
    frames(2);
    ASSERT_TRUE(items.count("f+sin(t)"));
    ui.click(items.at("f+sin(t)"), drawing());
    frames(4);
    ui.type("x)", drawing());
    rest();
    ASSERT_FALSE(edits.empty());
    EXPECT_EQ(edits.back(), "2*sin(x)");
}

} // namespace
} // namespace gaspard
