#include "core/diagnostics/quality.hpp"
#include "core/method/method.hpp"
#include "gui/application_fixture.hpp"
#include "gui/panels/status_bar.hpp"
#include "support/sanitizers.hpp"

#include <algorithm>
#include <random>

namespace gaspard {
namespace {

TEST_F(ApplicationTest, EveryPartHasItsPlaceInTheWindow) {
    for (const auto& [width, height] : {std::pair{1400.0F, 900.0F}, {900.0F, 600.0F}, {640.0F, 480.0F}}) {
        ImGui::GetIO().DisplaySize = {width, height};
        frame();
        frame();
        for (const char* key :
             {"action.run", "action.step", "action.reset", "action.home", "action.figure", "action.export-to",
              "scenario", "monitor.type", "monitor.amplitude", "viewport", "plot.first", "plot.second",
              "status.0", "playback.scrubber", "playback.position"}) {
            ASSERT_TRUE(application.items().count(key)) << key;
            const ItemRectangle& item = application.items().find(key)->second;
            EXPECT_GT(item.width(), 10) << key << " at " << width;
            EXPECT_GE(item.left, 0) << key;
            EXPECT_LE(item.right, width + 1) << key << " at " << width;
        }
        EXPECT_GT(application.viewport_rectangle().height(), 100);
    }
}

TEST_F(ApplicationTest, ADraggedSliderReachesTheSolver) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    const double before = solved_scenario().monitor.values.real("amplitude");
    ui.drag(application.items().find("monitor.amplitude")->second, 0.4F, 0.6F, drawing());
    const double shown = run().scenario.monitor.values.real("amplitude");
    EXPECT_GT(shown, before);
    EXPECT_EQ(solved_scenario().monitor.values.real("amplitude"), shown);
}

TEST_F(ApplicationTest, SpacePausesAndGoesOnOncePerPress) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    EXPECT_TRUE(application.press_key("Space"));
    ASSERT_TRUE(wait_until([&] { return run().status.paused; }));
    const auto count = run().history.size();
    frame();
    EXPECT_EQ(run().history.size(), count);
    EXPECT_TRUE(application.press_key("N"));
    ASSERT_TRUE(wait_until([&] { return run().history.size() == count + 1; }));
    EXPECT_TRUE(application.press_key("Space"));
    ASSERT_TRUE(wait_until([&] { return run().history.size() > count + 5; }));
    EXPECT_FALSE(application.press_key("Ctrl+J"));
}

TEST_F(ApplicationTest, KeysAreNotShortcutsWhileTyping) {
    frame();
    ui.double_click(application.items().find("monitor.amplitude")->second, drawing());
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    const std::string theme = application.window_state().theme_name;
    for (const char* key : {"T", "Space", "Escape", "Ctrl+C", "Ctrl+V"})
        EXPECT_FALSE(application.press_key(key));
    EXPECT_EQ(application.window_state().theme_name, theme);
    EXPECT_TRUE(application.press_key("F4")) << "no letter, nor what a field knows";
    EXPECT_TRUE(application.press_key("Ctrl+Q"));
    EXPECT_TRUE(application.window_state().quit);
    ui.click(application.items().find("viewport")->second, drawing());
    frame();
    EXPECT_TRUE(application.press_key("T"));
    EXPECT_NE(application.window_state().theme_name, theme);
}

TEST_F(ApplicationTest, ButtonsDoWhatKeysDo) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3; }));
    ui.click(application.items().find("action.run")->second, drawing());
    EXPECT_FALSE(run().wants_to_run);
    ASSERT_TRUE(wait_until([&] { return run().status.paused; }));
    ui.click(application.items().find("action.reset")->second, drawing());
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    application.perform("screenshot");
    bool taken = application.take_screenshot_request();
    for (int frame = 0; frame < 3 && !taken; ++frame) {
        ui.frame(drawing());
        taken = application.take_screenshot_request();
    }
    EXPECT_TRUE(taken);
    EXPECT_FALSE(application.take_screenshot_request());
}

TEST_F(ApplicationTest, AnEndedRunRunsAgain) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const int last = run().history.back().iteration;
    EXPECT_FALSE(application.press_key("N")) << "there is no step beyond the end";
    EXPECT_TRUE(application.press_key("Ctrl+R"));
    ASSERT_TRUE(wait_until([&] { return !run().ended(); }));
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_EQ(run().history.back().iteration, last);
    EXPECT_TRUE(application.press_key("R"));
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    frame();
    EXPECT_FALSE(run().wants_to_run);
    EXPECT_TRUE(application.press_key("Space"));
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    EXPECT_EQ(run().history.back().iteration, last);
}

TEST_F(ApplicationTest, ASolveIsLookedAtAgainAndReplayed) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    frame();
    const int last = run().history.back().iteration;
    const auto shown = [&] {
        frame();
        return application.views().front().scene.physical;
    };
    const auto end = shown();
    EXPECT_TRUE(application.press_key("Home"));
    EXPECT_NE(shown(), end);
    EXPECT_EQ(application.items().count("playback.scrubber"), 1U);
    const auto value = [&](std::size_t cell) { return application.status()[cell].value; };
    EXPECT_EQ(value(1), "0") << "the numbers are those of the picture";
    EXPECT_TRUE(application.press_key("Right"));
    frame();
    EXPECT_EQ(value(1), "1");
    EXPECT_TRUE(application.press_key("Left"));
    frame();
    EXPECT_EQ(value(1), "0");
    EXPECT_FALSE(application.press_key("Left")) << "there is none before it";
    ui.drag(application.items().find("playback.scrubber")->second, 0.2F, 0.5F, drawing());
    EXPECT_NEAR(std::stod(value(1)), 0.5 * last, 0.03 * last);
    EXPECT_TRUE(application.press_key("Space"));
    frame();
    EXPECT_TRUE(application.window_state().animating);
    EXPECT_EQ(find_action(application.actions(), "run").current_label(), "Pause");
    const double before = std::stod(value(1));
    for (int i = 0; i < 60; ++i) frame();
    EXPECT_NEAR(std::stod(value(1)), before + 10, 2) << "ten iterations a second";
    EXPECT_TRUE(application.press_key("Space"));
    frame();
    EXPECT_FALSE(application.window_state().animating);
    EXPECT_TRUE(application.press_key("End"));
    shown();
    EXPECT_EQ(value(1), std::to_string(last));
    EXPECT_EQ(run().status.run, RunStatus::converged) << "nothing was solved";
}

TEST_F(ApplicationTest, AChangeWhileAnOldIterateIsShownShowsTheNewest) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    frame();
    application.press_key("Home");
    frame();
    EXPECT_EQ(application.status()[1].value, "0");
    Scenario changed = run().scenario;
    set_value(*catalogue, changed, "monitor.amplitude", 15.0);
    application.document().change(run().id, changed);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    frame();
    EXPECT_EQ(application.status()[1].value, std::to_string(run().history.back().iteration));
}

TEST_F(ApplicationTest, TheFirstTangledIterationIsOneKeyAway) {
    EXPECT_FALSE(application.press_key("G"));
    Scenario wild = run().scenario;
    set_value(*catalogue, wild, "method.diagnostics_every", std::int64_t{1});
    set_value(*catalogue, wild, "method.step_size", 3.0);
    application.document().change(run().id, wild);
    ASSERT_TRUE(wait_until([&] { return run().changes.settled() && run().ended(); }));
    frame();
    const auto ranges = tangled_ranges(run().history);
    ASSERT_FALSE(ranges.empty());
    frame();
    ASSERT_TRUE(application.items().count("remedy")) << "the message offers it";
    ui.click(application.items().find("remedy")->second, drawing());
    frame();
    EXPECT_EQ(application.status()[1].value, std::to_string(ranges.front().first));
    EXPECT_NE(application.status()[5].value, "0");
    EXPECT_EQ(application.status()[5].tone, Tone::bad);
    ASSERT_NE(application.views().front().scene.tangled, nullptr);
    EXPECT_TRUE(application.press_key("Left"));
    frame();
    EXPECT_EQ(application.status()[5].value, "0");
    EXPECT_EQ(application.views().front().scene.tangled, nullptr);
}

TEST_F(ApplicationTest, TheBlendLoopMovesThePictureAndChangesNothing) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    frame();
    const std::size_t edits = application.document().edits().undo_count();
    EXPECT_TRUE(application.press_key("O"));
    double least = 1;
    for (int i = 0; i < 150; ++i) {
        frame();
        least = std::min(least, application.views().front().scene.blend);
    }
    EXPECT_EQ(least, 0);
    EXPECT_EQ(application.document().viewports().front().view.real("blend"), 1);
    EXPECT_EQ(application.document().edits().undo_count(), edits);
    EXPECT_TRUE(application.press_key("O"));
    frame();
    EXPECT_EQ(application.views().front().scene.blend, 1);
}

TEST_F(ApplicationTest, ATangledRunIsRedAndSaysHowToGoOn) {
    Scenario wild = run().scenario;
    set_value(*catalogue, wild, "monitor.amplitude", 500.0);
    set_value(*catalogue, wild, "method.step_size", 5.0);
    application.document().change(run().id, wild);
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    const auto cells = status_cells(run());
    EXPECT_EQ(cells[0].tone, Tone::bad) << cells[0].value;
    EXPECT_EQ(cells[5].label, "Tangled cells");
    EXPECT_EQ(cells[5].tone, Tone::bad) << cells[5].value;
    EXPECT_NE(
        closing_note(run(), find_action(application.actions(), "reset")).find("R starts from the beginning"),
        std::string::npos)
        << closing_note(run(), find_action(application.actions(), "reset"));
    EXPECT_TRUE(application.press_key("R"));
    ASSERT_TRUE(wait_until([&] { return run().history.size() == 1; }));
    EXPECT_TRUE(closing_note(run(), find_action(application.actions(), "reset")).empty());
    EXPECT_EQ(status_cells(run())[5].value, "0");
    EXPECT_EQ(status_cells(run())[5].tone, Tone::plain);
}

TEST_F(ApplicationTest, CellsThatFoldWhereTheMapDoesNotAreInParentheses) {
    ASSERT_TRUE(wait_until([&] { return run().ended(); }));
    std::vector<SeriesInfo> diagnostics = quality_series();
    diagnostics.push_back(folded_drawn_cells_series());
    StepReport& last = run().history.back(); // as if of a patch
    last.series =
        std::make_shared<const SeriesTable>(normalised_residual(), diagnostics, std::vector<SeriesInfo>{});
    last.values.clear();
    EXPECT_EQ(status_cells(run())[5].value, "0");
    last.set("folded_drawn_cells", 8);
    EXPECT_EQ(status_cells(run())[5].value, "0 (8 drawn fold)");
    EXPECT_EQ(status_cells(run())[5].tone, Tone::plain);
}

TEST_F(ApplicationTest, WhatTheSolverRefusesIsASentenceAndThePictureStays) {
    ASSERT_TRUE(wait_until([&] { return run().history.size() > 3 && !application.views().empty(); }));
    Scenario impossible = run().scenario;
    impossible.method.type = "no-such-method";
    application.document().change(run().id, impossible);
    ASSERT_TRUE(wait_until([&] { return application.messages().last().error; }));
    EXPECT_NE(application.messages().last().text.find("no-such-method"), std::string::npos)
        << application.messages().last().text;
    EXPECT_FALSE(application.views().empty());
    EXPECT_NE(run().status.run, RunStatus::failed);
}

TEST_F(ApplicationTest, PartsAreShownHiddenAndMadeWider) {
    for (const char* key : {"F2", "F3", "F4"}) application.press_key(key);
    frame();
    EXPECT_EQ(application.items().count("monitor.type"), 0U);
    EXPECT_EQ(application.items().count("plot.first"), 0U);
    EXPECT_EQ(application.items().count("log"), 1U);
    EXPECT_EQ(application.viewport_rectangle().width(), ImGui::GetIO().DisplaySize.x);
    for (const char* key : {"F2", "F3", "F4"}) application.press_key(key);
    frame();
    const auto drag_edge = [&](const char* name, float by) {
        const ItemRectangle edge = application.items().find(name)->second;
        ui.move(edge.center_x(), edge.center_y());
        frame();
        ui.button(true);
        frame();
        ui.move(edge.center_x() + by, edge.center_y());
        frame();
        ui.button(false);
        frame();
    };
    const ItemRectangle before = application.viewport_rectangle();
    drag_edge("edge.sidebar", 50);
    EXPECT_NEAR(application.viewport_rectangle().left, before.left + 50, 5);
    const ItemRectangle between = application.viewport_rectangle();
    drag_edge("edge.plots", -60);
    EXPECT_NEAR(application.viewport_rectangle().right, between.right - 60, 6);
    for (int i = 0; i < 10; ++i) drag_edge("edge.sidebar", -500);
    EXPECT_GT(application.viewport_rectangle().left, 100) << "the sliders stay within reach";
}

TEST_F(ApplicationTest, ThemeAndSizeAreChangedByKeysAndRemembered) {
    EXPECT_EQ(application.window_state().theme.background, dark_theme().background);
    application.press_key("T");
    EXPECT_EQ(application.window_state().theme.background, light_theme().background);
    EXPECT_EQ(application.settings().window.text("theme"), "light");
    application.press_key("F10");
    EXPECT_NEAR(application.window_state().text_size, 1.7, 1e-6);
    application.press_key("F10");
    EXPECT_EQ(application.window_state().text_size, 1);
    for (int i = 0; i < 30; ++i) application.press_key("Ctrl+=");
    EXPECT_EQ(application.window_state().text_size, 3);
    for (int i = 0; i < 60; ++i) application.press_key("Ctrl+-");
    EXPECT_NEAR(application.window_state().text_size, 0.6, 1e-6);
    application.press_key("F11");
    EXPECT_TRUE(application.window_state().fullscreen);
}

TEST_F(ApplicationTest, EverythingHasRoomAtTheSizeForProjectors) {
    ui.scale(1.7F);
    application.set_scale(1.7F);
    for (const ImVec2 size : {ImVec2{1920, 1080}, {1400, 900}}) {
        ImGui::GetIO().DisplaySize = size;
        for (int i = 0; i < 3; ++i) frame();
        for (const char* key : {"action.run", "action.export-to", "scenario", "monitor.amplitude", "viewport",
                                "plot.first", "plot.second", "plot.first.menu", "plot.second.menu",
                                "status.0", "playback.scrubber", "action.step"}) {
            ASSERT_TRUE(application.items().count(key)) << key;
            const ItemRectangle item = application.items().find(key)->second;
            EXPECT_LE(item.right, size.x + 1) << key;
            EXPECT_LE(item.bottom, size.y + 1) << key;
        }
        const float right = application.items().find("action.home")->second.left;
        EXPECT_LT(application.items().find("scenario")->second.right, right);
        EXPECT_GT(application.viewport_rectangle().width(), 500);
        EXPECT_GT(application.items().find("plot.first.curves")->second.height(), 100);
    }
}

struct InputCase {
    const char* name;
    std::vector<std::string> settings;
    int frames;
};

class RandomInput : public ApplicationFixture, public testing::WithParamInterface<InputCase> {
  protected:
    RandomInput() : RandomInput(std::make_shared<Catalogue>(builtin_catalogue())) {}

  private:
    explicit RandomInput(const std::shared_ptr<const Catalogue>& of)
        : ApplicationFixture(of, opened(*of, GetParam())) {}
    static Scenario opened(const Catalogue& catalogue, const InputCase& input) {
        Scenario scenario = find_scenario(catalogue, input.name);
        apply_settings(catalogue, scenario, input.settings);
        return scenario;
    }
};

/// What a row allows, written out again.
testing::AssertionResult is_allowed(const ParameterRow& row, const Value& value) {
    const auto in_range = [&](double number) { return number >= row.minimum && number <= row.maximum; };
    const auto* real = std::get_if<double>(&value);
    const auto* whole = std::get_if<std::int64_t>(&value);
    const auto* text = std::get_if<std::string>(&value);
    bool allowed = false;
    switch (row.kind) {
    case ParameterKind::real:
        allowed = real && in_range(*real);
        break;
    case ParameterKind::real_or_auto:
        allowed = (real && in_range(*real)) || (text && *text == "auto");
        break;
    case ParameterKind::integer:
        allowed = whole && in_range(static_cast<double>(*whole));
        break;
    case ParameterKind::boolean:
        allowed = std::holds_alternative<bool>(value);
        break;
    case ParameterKind::choice:
        allowed = text && std::count(row.choices.begin(), row.choices.end(), *text) == 1;
        break;
    case ParameterKind::text:
        allowed = text != nullptr;
        break;
    }
    if (allowed) return testing::AssertionSuccess();
    return testing::AssertionFailure() << row.key << " = " << format_value(value) << " is not allowed";
}

TEST_P(RandomInput, BreaksNothing) {
    std::mt19937 random(8); // the same input every time
    const auto draw_int = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
    std::vector<std::string_view> keys;
    for (const Action& row : application.actions())
        if (row.name != "export" && row.name != "export-to" && row.name != "screenshot")
            keys.insert(keys.end(), row.keys.begin(), row.keys.end());
    int changes = 0;
    Scenario before = run().scenario;
    Values looked = look();
    const int frames = sanitized ? GetParam().frames * 2 / 5 : GetParam().frames;
    const int expected = frames / 500; // more input where the solver's threads are slow to answer
    for (int i = 0; i < frames || (changes <= expected && i < 4 * frames); ++i) {
        ImGuiIO& io = ImGui::GetIO();
        if (draw_int(0, 7) == 0)
            ui.move(static_cast<float>(draw_int(-20, 1420)), static_cast<float>(draw_int(-20, 920)));
        if (const auto& items = application.items(); draw_int(0, 7) == 0 && !items.empty()) {
            const auto item = std::next(items.begin(), draw_int(0, static_cast<int>(items.size()) - 1));
            ui.move(item->second.center_x(), item->second.center_y());
        }
        if (draw_int(0, 2) == 0) ui.button(draw_int(0, 1) == 1, draw_int(0, 2));
        if (draw_int(0, 9) == 0) ui.wheel(static_cast<float>(draw_int(-3, 3)));
        if (draw_int(0, 9) == 0) ui.control(!io.KeyCtrl);
        if (draw_int(0, 4) == 0) io.AddInputCharacter(static_cast<unsigned>(draw_int(32, 126)));
        if (draw_int(0, 19) == 0)
            application.press_key(
                keys[static_cast<std::size_t>(draw_int(0, static_cast<int>(keys.size()) - 1))]);
        if (draw_int(0, 49) == 0)
            io.DisplaySize = {static_cast<float>(draw_int(1, 2000)), static_cast<float>(draw_int(1, 1500))};
        if (i % 40 == 0) application.perform("cancel"); // a dialog would keep the rest away
        if (i % 200 == 0 && application.items().count("monitor.type") == 0) application.perform("sidebar");
        frame();
        if (run().scenario != before) ++changes, before = run().scenario;
        if (look() != looked) ++changes, looked = look();
        for (const Values* values : {&run().scenario.domain.values, &run().scenario.monitor.values})
            for (const auto& row : values->rows()) ASSERT_TRUE(is_allowed(row, values->at(row.key)));
    }
    if (run().status.run == RunStatus::failed) {                  // as with the name of a file that is none
        const auto& lines = application.messages().log().lines(); // the status bar may show a later message
        EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const LogLine& line) {
            return line.notice.error;
        })) << application.messages().log().text();
    }
    EXPECT_GT(changes, expected) << "the input reached hardly anything";
}

INSTANTIATE_TEST_SUITE_P(
    Scenarios, RandomInput,
    testing::Values(InputCase{"plane-ring", {"domain.cells=12"}, 10000},
                    InputCase{"sphere-x4", {"domain.cells=4", "view.layout=front-and-rear"}, 5000},
                    InputCase{"sphere-cross", {"domain.refinements=1", "view.layout=projection"}, 5000},
                    InputCase{"spline-patch", {"domain.cells=8"}, 5000},
                    InputCase{
                        "layer-1d",
                        {"method.interpolation=false", "view.layout=side-by-side", "view.x_axis=log-right"},
                        5000},
                    InputCase{"spline-moebius", {"domain.cells=8", "view.arrows=true"}, 5000}),
    [](const auto& of) {
        std::string name = of.param.name;
        name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
        return name;
    });

} // namespace
} // namespace gaspard
