// The user's own monitors in the window: typed formulas, dropped files, packed data.
#include "core/io/image.hpp"
#include "gui/app/file_kinds.hpp"
#include "gui/application_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <imgui.h>
#include <iterator>

namespace gaspard {
namespace {

class DataTest : public ApplicationTest {
  protected:
    /// A disc on white.
    std::filesystem::path picture(const std::string& name, std::uint8_t dark = 40) const {
        constexpr std::uint8_t white = 230, opaque = 255;
        Image image{32, 32, {}};
        for (int y = -16; y < 16; ++y)
            for (int x = -16; x < 16; ++x) {
                const std::uint8_t grey = x * x + y * y < 60 ? dark : white;
                image.rgba.insert(image.rgba.end(), {grey, grey, grey, opaque});
            }
        write_png(folder / name, image);
        return folder / name;
    }
    const ItemRectangle& item(const std::string& key) {
        const auto found = application.items().find(key);
        if (found == application.items().end()) {
            static const ItemRectangle nowhere;
            ADD_FAILURE() << key << " is not shown";
            return nowhere;
        }
        return found->second;
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }
    void use_formula(const std::string& text) {
        Scenario scenario = run().scenario;
        set_value(*catalogue, scenario, "monitor.type", std::string("formula"));
        set_value(*catalogue, scenario, "monitor.expression", text);
        application.document().change(run().id, scenario);
        application.document().end_gesture();
        ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
        frames(2);
    }
    /// Into the formula's field, instead of what it holds.
    void type_formula(const std::string& text) {
        replace_text(item("monitor.expression"), text);
        frames(45); // longer than a pause
    }
    std::string formula() { return run().scenario.monitor.values.text("expression"); }
};

TEST_F(DataTest, ATypedFormulaIsSolvedForAndUndoneAsOneEdit) {
    use_formula("1 + x^2*0");
    const std::size_t before = application.document().edits().undo_count();
    type_formula("2 + sin(2*pi*x)");
    EXPECT_EQ(formula(), "2 + sin(2*pi*x)");
    EXPECT_EQ(application.document().edits().undo_count(), before + 1);
    ui.type("+0*y", drawing());
    frames(45);
    EXPECT_EQ(formula(), "2 + sin(2*pi*x)+0*y");
    EXPECT_EQ(application.document().edits().undo_count(), before + 2) << "one edit for each pause";
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(solved_scenario().monitor.values.text("expression"), "2 + sin(2*pi*x)+0*y");
    ui.click(item("monitor.type"), drawing()); // the field is left
    application.perform("cancel");
    frames(3);
    EXPECT_TRUE(application.document().undo());
    EXPECT_EQ(formula(), "2 + sin(2*pi*x)");
    EXPECT_TRUE(application.document().redo());
    EXPECT_EQ(formula(), "2 + sin(2*pi*x)+0*y");
}

TEST_F(DataTest, AMistakeInAFormulaInterruptsNothing) {
    use_formula("2 + x*0");
    const std::string title = application.title();
    type_formula("2 + sine(x)");
    EXPECT_EQ(formula(), "2 + x*0") << "the last good one";
    EXPECT_TRUE(application.items().count("monitor.expression.complaint"));
    EXPECT_FALSE(application.messages().error().open());
    type_formula("0 - 3"); // a formula, but no monitor: only the solver knows
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && formula() == "2 + x*0"; })) << formula();
    frames(3);
    EXPECT_TRUE(application.items().count("monitor.expression.complaint"));
    EXPECT_FALSE(application.messages().error().open());
    EXPECT_TRUE(ImGui::GetIO().WantTextInput) << "one can go on typing";
    EXPECT_EQ(solved_scenario().monitor.values.text("expression"), "2 + x*0");
    type_formula("3 + cos(2*pi*y)");
    EXPECT_EQ(formula(), "3 + cos(2*pi*y)");
    EXPECT_FALSE(application.items().count("monitor.expression.complaint"));
}

TEST_F(DataTest, TextThatIsWrongLeavesMenusAndComparisonsUsable) {
    use_formula("1 + q*x*0");
    Scenario wrong = run().scenario; // until the solver refuses it
    wrong.monitor.values.set("ranges", std::string("q 0"));
    for (const char* menu : {"method.type", "domain.type", "monitor.type"}) {
        application.document().change(run().id, wrong);
        ui.click(item(menu), drawing());
        frames(2);
        application.perform("cancel");
        frames(2);
    }
    EXPECT_FALSE(methods_for(*catalogue, wrong).empty());
    EXPECT_THROW(update_rows(*catalogue, wrong), InputError);
    const auto changed = with_type(*catalogue, run().opened, wrong, SectionKind::method, "newton");
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->method.type, "newton");
    EXPECT_TRUE(changed->monitor.values.has("q")) << "the rows that it had";
}

TEST_F(DataTest, ParametersOfAFormulaAreSlidersThatATypedValueWidens) {
    use_formula("1 + q*exp(-(x-0.5)^2)");
    const ParameterRow* row = nullptr;
    for (const ParameterRow& one : run().scenario.monitor.values.rows())
        if (one.key == "q") row = &one;
    ASSERT_NE(row, nullptr);
    ASSERT_TRUE(row->slider.has_value());
    const double most = row->slider->maximum;
    ui.drag(item("monitor.q"), 0.5F, 3.0F, drawing());
    EXPECT_EQ(run().scenario.monitor.values.real("q"), most) << "the end of the slider";
    frames(30); // what follows is no second click
    ui.double_click(item("monitor.q"), drawing());
    ui.type(std::to_string(4 * most), drawing());
    ui.click(item("domain.cells"), drawing());
    frames(3);
    EXPECT_DOUBLE_EQ(run().scenario.monitor.values.real("q"), 4 * most);
    ui.drag(item("monitor.q"), 0.9F, 0.4F, drawing());
    EXPECT_NEAR(run().scenario.monitor.values.real("q"), 2 * most, 0.4 * most)
        << "the middle of a wider slider";
}

TEST_F(DataTest, ABuiltInMonitorBecomesAFormulaWithItsValues) {
    ASSERT_TRUE(wait_until([&] { return run().snapshot != nullptr; }));
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 7.0);
    application.document().change(run().id, changed);
    EXPECT_TRUE(application.press_key("Ctrl+E"));
    EXPECT_EQ(run().scenario.monitor.type, "formula");
    EXPECT_EQ(run().scenario.monitor.values.real("amplitude"), 7);
    frames(2);
    EXPECT_TRUE(application.items().count("monitor.expression"));
    EXPECT_TRUE(application.items().count("monitor.amplitude"));
    EXPECT_FALSE(application.press_key("Ctrl+E"));
    EXPECT_EQ(application.messages().last().text, "Edit as formula: the monitor is a formula already.");
    EXPECT_TRUE(application.document().undo());
    EXPECT_EQ(run().scenario.monitor.type, "ring");
    ui.click(item("monitor.as-formula"), drawing());
    EXPECT_EQ(run().scenario.monitor.type, "formula") << "the button in the heading";
}

TEST_F(DataTest, EditAsFormulaLetsOneTypeAtOnce) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    application.perform("sidebar"); // hidden: it is shown again
    frame();
    EXPECT_TRUE(application.press_key("Ctrl+E"));
    const std::string before = formula();
    for (int i = 0; i < 8; ++i, frame())
        for (const char* letter : {"E", "L", "R", "T", "Space"})
            EXPECT_FALSE(application.press_key(letter)) << letter << " in frame " << i;
    EXPECT_TRUE(ImGui::GetIO().WantTextInput);
    EXPECT_FALSE(application.window_state().awaits_text);
    ui.type("+7", drawing());
    frames(45);
    EXPECT_EQ(formula(), before + "+7") << "at the end";
}

TEST_F(DataTest, AKeyRightAfterAClickOnATextFieldIsForTheField) {
    use_formula("2 + x*0");
    ui.move(item("monitor.expression").center_x(), item("monitor.expression").center_y());
    frame();
    ui.button(true);
    frame();
    EXPECT_FALSE(application.press_key("T"));
    ui.button(false);
    frame();
    EXPECT_FALSE(application.press_key("1"));
    ui.click(item("domain.cells"), drawing());
    ui.click(item("domain.cells"), drawing()); // a double click
    for (int i = 0; i < 4; ++i, frame()) EXPECT_FALSE(application.press_key("1")) << i;
    ui.control(true); // on a slider: one types its value
    ui.click(item("monitor.floor"), drawing());
    ui.control(false);
    for (int i = 0; i < 4; ++i, frame()) EXPECT_FALSE(application.press_key("L")) << i;
}

TEST_F(DataTest, ADroppedImageBecomesTheMonitorInOneEdit) {
    const auto file = picture("face.png");
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 2; }));
    const std::size_t before = application.document().edits().undo_count();
    application.open_file(file);
    ASSERT_TRUE(wait_until([&] { return run().scenario.monitor.type == "image"; }));
    EXPECT_EQ(run().scenario.monitor.values.text("file"), file.string());
    EXPECT_EQ(application.document().edits().undo_count(), before + 1);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_FALSE(application.messages().error().open()) << application.messages().error().sentence();
    EXPECT_EQ(solved_scenario().monitor.type, "image");
    EXPECT_EQ(run().snapshot->tangled ? run().snapshot->tangled->size() : 0U, 0U);
    EXPECT_TRUE(application.document().undo());
    EXPECT_EQ(run().scenario.monitor.type, "ring");
}

TEST_F(DataTest, TheMessageOfADroppedFileIsTrueOnceItWasRead) {
    application.open_file(picture("face.png"));
    ASSERT_TRUE(wait_until([&] { return run().scenario.monitor.type == "image"; }));
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    EXPECT_EQ(application.messages().last().text, "Using " + (folder / "face.png").string());
}

TEST_F(DataTest, AFileThatHasChangedIsReadAgain) {
    EXPECT_FALSE(application.press_key("F5")) << "a ring has no file";
    const auto file = picture("face.png");
    application.open_file(file);
    ASSERT_TRUE(wait_until([&] { return run().scenario.monitor.type == "image"; }));
    const auto rests = [&] { return run().changes.settled() && run().ended(); };
    ASSERT_TRUE(wait_until(rests));
    const auto before = run().snapshot;
    const std::size_t edits = application.document().edits().undo_count();
    picture("face.png", 225); // much paler
    EXPECT_TRUE(application.press_key("F5"));
    ASSERT_TRUE(wait_until([&] { return rests() && run().snapshot != before; }));
    double moved = 0;
    for (const double one : (run().snapshot->x - before->x).x) moved = std::max(moved, std::abs(one));
    EXPECT_GT(moved, 1e-3);
    EXPECT_EQ(application.document().edits().undo_count(), edits) << "no value has changed";
    std::filesystem::remove(file);
    const auto paler = run().snapshot;
    EXPECT_TRUE(application.press_key("F5"));
    ASSERT_TRUE(wait_until([&] { return application.messages().error().open(); }));
    EXPECT_NE(application.messages().error().sentence().find("face.png"), std::string::npos);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    EXPECT_EQ(run().snapshot->x, paler->x) << "the mesh stays";
    EXPECT_EQ(run().scenario.monitor.type, "image");
}

TEST_F(DataTest, WhatCannotBeDroppedIsToldWhatCan) {
    std::ofstream(folder / "letter.pdf") << "%PDF-1.4";
    application.open_file(folder / "letter.pdf");
    ASSERT_TRUE(wait_until([&] { return application.messages().error().open(); }));
    const std::string said = application.messages().error().sentence();
    EXPECT_NE(said.find("letter.pdf"), std::string::npos) << said;
    EXPECT_NE(said.find(what_opens()), std::string::npos) << said;
    EXPECT_EQ(run().scenario.monitor.type, "ring");
}

TEST_F(DataTest, AnImageThatCannotBeReadLeavesTheMeshAlone) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    std::ofstream(folder / "broken.png") << "\x89PNG\r\n\x1a\nno more";
    application.open_file(folder / "broken.png");
    ASSERT_TRUE(wait_until([&] { return application.messages().error().open(); }));
    EXPECT_NE(application.messages().error().sentence().find("broken.png"), std::string::npos)
        << application.messages().error().sentence();
    ASSERT_TRUE(wait_until([&] { return run().scenario.monitor.type == "ring"; }));
    EXPECT_FALSE(application.document().edits().can_undo());
}

TEST_F(DataTest, TheButtonOfAFileOpensAChooser) {
    const auto first = picture("first.png"), second = picture("second.png", 90);
    std::filesystem::create_directories(folder / "inside");
    std::ofstream(folder / "notes.md") << "not listed";
    application.open_file(first);
    ASSERT_TRUE(
        wait_until([&] { return run().scenario.monitor.type == "image" && run().changes.settled(); }));
    frames(2);
    ui.click(item("monitor.file"), drawing());
    ASSERT_TRUE(wait_until([&] { return application.items().count("open.entry.second.png") == 1; }))
        << "the folder of the present file";
    EXPECT_TRUE(application.items().count("open.entry.inside"));
    EXPECT_FALSE(application.items().count("open.entry.notes.md"));
    const std::size_t before = application.document().edits().undo_count();
    ui.double_click(item("open.entry.second.png"), drawing());
    frames(2);
    EXPECT_EQ(run().scenario.monitor.values.text("file"), second.string());
    EXPECT_EQ(application.document().edits().undo_count(), before + 1);
}

TEST_F(DataTest, ASavedScenarioMovesWithItsDataOrCarriesThem) {
    const auto file = picture("face.png");
    application.open_file(file);
    ASSERT_TRUE(
        wait_until([&] { return run().scenario.monitor.type == "image" && run().changes.settled(); }));
    const auto save = [&](const std::string& name, bool packed) {
        application.perform("save-as");
        frames(3);
        replace_text(item("save.path"), (folder / name).string());
        if (packed) ui.click(item("save.pack"), drawing());
        ui.click(item("save.ok"), drawing());
        ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(folder / name); }));
        ASSERT_TRUE(wait_until([&] { return run().scenario.modified.empty(); })) << "it has the saved name";
    };
    save("beside.toml", false);
    save("packed.toml", true);
    EXPECT_EQ(load_scenario(*catalogue, folder / "beside.toml").monitor.values.text("file"), "face.png");
    const auto moved = folder / "other machine";
    std::filesystem::create_directories(moved);
    for (const char* name : {"beside.toml", "face.png"}) std::filesystem::rename(folder / name, moved / name);
    std::filesystem::create_directories(moved / "alone");
    std::filesystem::rename(folder / "packed.toml", moved / "alone" / "packed.toml");
    for (const auto& one : {moved / "beside.toml", moved / "alone" / "packed.toml"}) {
        const std::uint64_t openings = run().openings;
        application.open_file(one);
        ASSERT_TRUE(
            wait_until([&] { return run().openings > openings || application.messages().error().open(); }));
        EXPECT_FALSE(application.messages().error().open()) << application.messages().error().sentence();
        EXPECT_TRUE(wait_until([&] { return run().snapshot && run().changes.settled(); }));
        EXPECT_EQ(solved_scenario().monitor.type, "image");
    }
}

TEST_F(DataTest, StagesOfADerivedMonitorAreShownAndSwitched) {
    Scenario derived = run().scenario;
    set_value(*catalogue, derived, "monitor.type", std::string("derived"));
    set_value(*catalogue, derived, "monitor.u.expression", std::string("sin(2*pi*x)*cos(2*pi*y)"));
    application.document().change(run().id, derived);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    frames(3);
    EXPECT_TRUE(application.items().count("monitor.u.expression"));
    ui.click(item("monitor.stage.Indicator"), drawing());
    frames(2);
    EXPECT_EQ(look().text("color"), "indicator");
    ASSERT_TRUE(wait_until([&] { return run().snapshot && run().snapshot->field("indicator") != nullptr; }));
    EXPECT_TRUE(run().scenario.monitor.values.boolean("average"));
    ui.click(item("monitor.average"), drawing());
    EXPECT_FALSE(run().scenario.monitor.values.boolean("average"));
    ui.drag(item("monitor.fraction"), 0.2F, 0.8F, drawing());
    EXPECT_EQ(run().scenario.monitor.values.real("fraction"), derived.monitor.values.real("fraction"))
        << "a stage that is switched off cannot be turned";
}

TEST_F(DataTest, PartsOfACombinedMonitorHaveTypesOfTheirOwn) {
    Scenario combined = run().scenario;
    set_value(*catalogue, combined, "monitor.type", std::string("combine"));
    application.document().change(run().id, combined);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled(); }));
    frames(3);
    const std::string before = run().scenario.monitor.values.text("a.type");
    const std::string other = before == "bell" ? "ring" : "bell";
    ui.click(item("monitor.a.type"), drawing());
    frames(2);
    ui.click(item("monitor.a.type=" + other), drawing());
    frames(2);
    EXPECT_EQ(run().scenario.monitor.values.text("a.type"), other);
    EXPECT_TRUE(application.items().count("monitor.a.amplitude"));
    EXPECT_TRUE(application.items().count("monitor.stage.Part a"));
}

TEST_F(DataTest, WhyAdaptShowsBothErrorsAndTheirMaps) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().snapshot->interpolation != nullptr; }));
    ui.click(item("why"), drawing());
    frames(2);
    for (const char* norm : {"why.l2", "why.maximum", "why.h1"})
        EXPECT_TRUE(application.items().count(norm)) << norm;
    ui.click(item("why.maps"), drawing());
    frames(3);
    ASSERT_EQ(application.views().size(), 2U);
    const Colouring &uniform = *shown(0).scene.colouring, &adapted = *shown(1).scene.colouring;
    EXPECT_EQ(uniform.range.low, adapted.range.low) << "one scale";
    EXPECT_EQ(uniform.range.high, adapted.range.high);
    EXPECT_NE(uniform.values, adapted.values);
    EXPECT_EQ(shown(0).scene.blend, 0);
}

TEST_F(DataTest, WhyAdaptPlotsTheErrorsAgainstTheNumberOfCells) {
    ASSERT_TRUE(wait_until([&] { return run().ended() && run().changes.settled(); }));
    ui.click(item("why"), drawing());
    frames(2);
    EXPECT_FALSE(application.items().count("why.study.plot"));
    ui.click(item("why.study"), drawing());
    frames(2);
    EXPECT_TRUE(application.items().count("why.study.plot"));
    EXPECT_TRUE(wait_until([&] { return application.items().count("why.study.order") == 1; }))
        << "once two meshes are solved";
    ui.click(item("why.study.h1"), drawing());
    frames(2);
    EXPECT_TRUE(application.items().count("why.study.order"));
    EXPECT_TRUE(run().ended()) << "the run itself is left alone";
}

} // namespace
} // namespace gaspard
