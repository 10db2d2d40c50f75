#include "core/scenario/toml.hpp"
#include "gui/headless_ui.hpp"
#include "gui/panels/parameter_panel.hpp"

#include <gtest/gtest.h>
#include <imgui_internal.h>

namespace gaspard {
namespace {

/// One window with the sections of a scenario, as the program shows them.
class PanelTest : public testing::Test {
  protected:
    explicit PanelTest()
        : catalogue(builtin_catalogue()), opened(find_scenario(catalogue, "plane-ring")), scenario(opened) {}

    void draw() {
        items.clear();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({380, 900});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        for (const auto kind : all_sections)
            if (has_section(scenario, kind) &&
                panel.draw_section(kind, {catalogue, opened, theme, items, {}, patches, report}, scenario))
                ++changes;
        ImGui::End();
    }
    std::function<void()> drawing() {
        return [this] { draw(); };
    }
    void settle() {
        for (int i = 0; i < 3; ++i) ui.frame(drawing());
    }
    void pick(const std::string& combo, const std::string& choice) {
        ui.click(items.at(combo), drawing());
        settle();
        ASSERT_TRUE(items.count(combo + "=" + choice)) << "the list did not open";
        ui.click(items.at(combo + "=" + choice), drawing());
        settle();
    }

    HeadlessUi ui;
    Catalogue catalogue;
    Scenario opened, scenario;
    Theme theme = dark_theme();
    ParameterPanel panel;
    ItemRectangles items;
    const PatchList* patches = nullptr;
    const MonitorReport* report = nullptr;
    int changes = 0;
};

TEST_F(PanelTest, ATimeOfTheMonitorIsThatOfTheMeshWhileTimePasses) {
    scenario = opened = find_scenario(catalogue, "burgers-1d");
    Values now = scenario.monitor.values;
    bool plain = false;                  // whether a part of it is as in other rows
    const auto draw_at = [&](double t) { // what is drawn in the row, and the tooltip over its label
        now.set("t", t);
        const PanelContext context{
            .catalogue = catalogue, .opened = opened, .theme = theme, .items = items, .monitor_now = &now};
        std::string drawn;
        for (int i = 0; i < 3; ++i)
            ui.frame([&] {
                items.clear(), drawn.clear(), plain = false;
                ImGui::SetNextWindowPos({0, 0});
                ImGui::SetNextWindowSize({380, 900});
                ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
                if (panel.draw_section(SectionKind::monitor, context, scenario)) ++changes;
                const ItemRectangle row = items.at("monitor.t");
                for (const ImDrawVert& one : ImGui::GetWindowDrawList()->VtxBuffer)
                    if (one.pos.y >= row.top && one.pos.y <= row.bottom) {
                        drawn.append(reinterpret_cast<const char*>(&one.uv), sizeof(one.uv));
                        plain = plain || one.col == packed(theme.text);
                    }
                ImGui::End();
            });
        return drawn;
    };
    const std::string at_start = draw_at(0);
    EXPECT_EQ(draw_at(0), at_start);
    EXPECT_NE(draw_at(0.5), at_start);
    EXPECT_FALSE(plain) << "it is greyed out";
    EXPECT_FALSE(items.count("monitor.t.reset")) << "there is nothing to go back to";
    const ItemRectangle row = items.at("monitor.t");
    ui.move(row.center_x(), row.center_y());
    ui.button(true);
    for (int i = 0; i < 20; ++i)
        ui.move(row.center_x() + 5.0F * static_cast<float>(i), row.center_y()), draw_at(0.5);
    ui.button(false);
    draw_at(0.5);
    EXPECT_EQ(changes, 0) << "it cannot be dragged";
}

TEST_F(PanelTest, EveryRowHasItsItem) {
    settle();
    EXPECT_FALSE(items.count("method.tolerance")) << "a detail";
    ui.click(items.at("method.more"), drawing());
    settle();
    for (const Values* values : {&scenario.domain.values, &scenario.monitor.values, &scenario.method.values})
        for (const auto& row : values->rows())
            EXPECT_TRUE(items.count(values->section() + "." + row.key)) << row.key;
    EXPECT_EQ(changes, 0);
    EXPECT_EQ(scenario, opened);
    ui.click(items.at("method.more"), drawing());
    settle();
    EXPECT_FALSE(items.count("method.tolerance"));
    EXPECT_FALSE(items.count("monitor.more")) << "it has no details";
    scenario.method.values.set("tolerance", 1e-6);
    settle();
    EXPECT_TRUE(items.count("method.tolerance")) << "what is changed is in sight";
}

TEST_F(PanelTest, ColoursAreListedByTheirLabels) {
    std::string text;
    scenario.view.set("color", std::string("aspect_ratio"));
    const auto rows = [&] {
        items.clear();
        ImGui::SetNextWindowSize({380, 900});
        ImGui::Begin("panel");
        ImGui::LogToBuffer();
        panel.draw_rows({catalogue, opened, theme, items}, opened.view, scenario.view, {"color"});
        if (ImGui::GetCurrentContext()->LogEnabled) // not if the list is open, which is a window of its own
            text = ImGui::GetCurrentContext()->LogBuffer.c_str();
        ImGui::LogFinish();
        ImGui::End();
    };
    ui.frame(rows);
    ui.frame(rows);
    EXPECT_NE(text.find("aspect ratio"), std::string::npos) << text;
    EXPECT_EQ(text.find("aspect_ratio"), std::string::npos) << text;
    ui.click(items.at("view.color"), rows);
    for (int i = 0; i < 3; ++i) ui.frame(rows);
    ui.click(items.at("view.color=interpolation_error"), rows);
    EXPECT_EQ(scenario.view.text("color"), "interpolation_error") << "files keep the key";
}

TEST_F(PanelTest, DraggingASliderChangesTheValueAndStaysInRange) {
    settle();
    ui.drag(items.at("monitor.amplitude"), 0.1F, 0.6F, drawing());
    const double middle = scenario.monitor.values.real("amplitude");
    EXPECT_GT(middle, opened.monitor.values.real("amplitude"));
    EXPECT_GT(changes, 0);
    ui.drag(items.at("monitor.amplitude"), 0.5F, 3.0F, drawing()); // far beyond the end
    const auto& row = scenario.monitor.values.rows().front();
    ASSERT_EQ(row.key, "amplitude");
    EXPECT_EQ(scenario.monitor.values.real("amplitude"), row.maximum);
    ui.drag(items.at("monitor.amplitude"), 0.5F, -3.0F, drawing());
    EXPECT_EQ(scenario.monitor.values.real("amplitude"), row.minimum);
}

TEST_F(PanelTest, ALogarithmicSliderHasTheGeometricMeanInItsMiddle) {
    settle();
    ui.drag(items.at("monitor.sharpness"), 0.9F, -3.0F, drawing()); // to the left end
    ui.drag(items.at("monitor.sharpness"), 0.1F, 0.6F, drawing());
    const double value = scenario.monitor.values.real("sharpness"), mean = std::sqrt(1.0 * 2000.0);
    EXPECT_NEAR(value, mean, 0.1 * mean);
}

TEST_F(PanelTest, ADragMovesTheValueAsFarAsTheMouse) {
    settle();
    ui.click(items.at("monitor.radius"), drawing());
    EXPECT_EQ(scenario, opened) << "a click changes nothing";
    for (int i = 0; i < 30; ++i) ui.frame(drawing());
    const auto& rows = scenario.monitor.values.rows();
    const auto row =
        std::find_if(rows.begin(), rows.end(), [](const auto& one) { return one.key == "radius"; });
    const double whole = row->maximum - row->minimum, before = scenario.monitor.values.real("radius");
    ui.drag(items.at("monitor.radius"), 0.8F, 0.9F, drawing());
    const double moved = scenario.monitor.values.real("radius") - before;
    EXPECT_NEAR(moved, 0.1 * whole, 0.01 * whole) << "wherever it began";
    for (int i = 0; i < 30; ++i) ui.frame(drawing());
    ui.shift(true);
    ui.drag(items.at("monitor.radius"), 0.9F, 0.8F, drawing());
    ui.shift(false);
    EXPECT_NEAR(scenario.monitor.values.real("radius"), before + 0.9 * moved, 0.002 * whole) << "finely";
}

TEST_F(PanelTest, WheelAndArrowKeysStepTheFieldThatWasClicked) {
    settle();
    const auto turn = [&](float by) {
        ui.wheel(by);
        ui.frame(drawing());
        ui.wheel(0);
        settle();
    };
    const ItemRectangle cells = items.at("domain.cells");
    ui.move(cells.center_x(), cells.center_y());
    settle();
    turn(1);
    EXPECT_EQ(scenario, opened) << "the wheel scrolls until the field was clicked";
    ui.click(cells, drawing());
    turn(1);
    const auto more = scenario.domain.values.integer("cells");
    EXPECT_GT(more, 60);
    turn(-1);
    EXPECT_EQ(scenario.domain.values.integer("cells"), 60);
    ui.key(ImGuiKey_UpArrow, true);
    ui.frame(drawing());
    ui.key(ImGuiKey_UpArrow, false);
    settle();
    EXPECT_EQ(scenario.domain.values.integer("cells"), more);
    scenario.domain.values.set("cells", std::int64_t{4}); // the least
    settle();
    turn(-1);
    EXPECT_EQ(scenario.domain.values.integer("cells"), 4);
    turn(1);
    EXPECT_EQ(scenario.domain.values.integer("cells"), 5) << "one at least";
}

TEST_F(PanelTest, ScrollingThePanelChangesNoFieldThatComesUnderThePointer) {
    const float height = 180; // less than all rows
    const auto draw = [&] {
        items.clear();
        panel.begin_frame(true);
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({380, height});
        ImGui::Begin("low panel", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove);
        for (const auto kind : all_sections)
            if (has_section(scenario, kind))
                panel.draw_section(kind, {catalogue, opened, theme, items, {}, patches, report}, scenario);
        ImGui::End();
    };
    const auto turn = [&](float by) {
        ui.wheel(by);
        ui.frame(draw);
        ui.wheel(0);
        ui.frame(draw);
    };
    for (int i = 0; i < 3; ++i) ui.frame(draw);
    const auto cells = [&] { return items.at("domain.cells"); };
    const ItemRectangle at_first = cells();
    ui.click(at_first, draw);
    ui.move(at_first.center_x(), height - 5); // away from the field that was clicked
    for (int i = 0; i < 3; ++i) ui.frame(draw);
    for (int i = 0; i < 20; ++i) turn(-1); // to the end
    const float scrolled = at_first.top - cells().top;
    ASSERT_GT(scrolled, 60) << "the panel scrolls";
    EXPECT_EQ(scenario, opened);
    for (int i = 0; i < 60; ++i) ui.frame(draw);       // a second
    ui.move(at_first.center_x(), at_first.center_y()); // where the field will come back to
    for (int i = 0; i < 3; ++i) ui.frame(draw);
    for (int i = 0; i < 20; ++i) {
        turn(1);
        ui.move(at_first.center_x() + static_cast<float>(i % 2), at_first.center_y()); // a hand trembles
    }
    EXPECT_EQ(scenario, opened) << "the field came under the pointer by scrolling";
    EXPECT_EQ(cells().top, at_first.top) << "the panel scrolled on";
    for (int i = 0; i < 60; ++i) ui.frame(draw);
    turn(1);
    EXPECT_EQ(scenario, opened) << "the pointer has not moved since";
    for (int i = 0; i < 60; ++i) ui.frame(draw);
    ui.move(at_first.center_x() + 9, at_first.center_y());
    for (int i = 0; i < 3; ++i) ui.frame(draw);
    turn(1);
    EXPECT_GT(scenario.domain.values.integer("cells"), 60) << "it was pointed at";
    const auto stepped = scenario.domain.values.integer("cells");
    turn(-1);
    EXPECT_LT(scenario.domain.values.integer("cells"), stepped);
    EXPECT_EQ(cells().top, at_first.top) << "the panel does not scroll meanwhile";
}

TEST_F(PanelTest, AWholeNumberStaysWhole) {
    settle();
    ui.drag(items.at("domain.cells"), 0.2F, 0.7F, drawing());
    EXPECT_NE(scenario.domain.values.integer("cells"), opened.domain.values.integer("cells"));
    EXPECT_GT(scenario.domain.values.integer("cells"), 60);
}

TEST_F(PanelTest, ResetIsThereOnlyWhenChangedAndRestoresTheOpenedValue) {
    settle();
    EXPECT_FALSE(items.count("monitor.radius.reset"));
    scenario.monitor.values.set("radius", 0.4);
    settle();
    ASSERT_TRUE(items.count("monitor.radius.reset"));
    ui.click(items.at("monitor.radius.reset"), drawing());
    EXPECT_EQ(scenario, opened);
    settle();
    EXPECT_FALSE(items.count("monitor.radius.reset"));
}

TEST_F(PanelTest, ATypedValueIsTakenExactlyWhenTheFieldIsLeft) {
    settle();
    ui.double_click(items.at("monitor.amplitude"), drawing());
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    ui.type("12.345", drawing());
    EXPECT_EQ(changes, 0) << "a half-typed number was taken";
    ui.click(items.at("domain.cells"), drawing()); // an item drawn earlier
    settle();
    EXPECT_EQ(scenario.monitor.values.real("amplitude"), 12.345);
    EXPECT_EQ(changes, 1);
}

TEST_F(PanelTest, ATypedTextIsTakenWhenTheFieldIsLeft) {
    scenario.domain = domain_section(catalogue, "spline-patch");
    settle();
    ui.click(items.at("domain.control_points"), drawing());
    ui.type("0 0, 1 0", drawing());
    EXPECT_EQ(changes, 0) << "half a text was taken";
    EXPECT_EQ(scenario.domain.values.text("control_points"), "");
    ui.click(items.at("domain.cells"), drawing());
    settle();
    EXPECT_EQ(scenario.domain.values.text("control_points"), "0 0, 1 0");
    EXPECT_EQ(changes, 1);
}

TEST_F(PanelTest, AFileIsNamedAndAskedFor) {
    EXPECT_EQ(file_label(""), "Choose a file");
    EXPECT_EQ(file_label("/a/b/disk.json"), "disk.json");
    EXPECT_EQ(file_label("gaspard:portrait.png"), "portrait.png (built in)");
    EXPECT_EQ(file_label("{\"degree\": 2}"), "text in the scenario");
    EXPECT_EQ(file_label("data:image/png;base64," + std::string(4000, 'A')), "in the scenario, 4 kB");
    scenario.domain = domain_section(catalogue, "spline-patch");
    scenario.domain.values.set("file", std::string("/a/b/disk.json"));
    settle();
    EXPECT_FALSE(panel.take_file_wish());
    ui.click(items.at("domain.file"), drawing());
    const auto wish = panel.take_file_wish();
    ASSERT_TRUE(wish);
    EXPECT_EQ(wish->key, "domain.file");
    EXPECT_EQ(wish->present, "/a/b/disk.json");
    EXPECT_FALSE(panel.take_file_wish()) << "once";
    EXPECT_EQ(changes, 0);
}

TEST_F(PanelTest, NotesAndChoicesOfTheMonitorAreShown) {
    scenario = *with_type(catalogue, opened, scenario, SectionKind::monitor, "formula");
    MonitorReport said{{"12 of 3600 values are missing."}, {{"ranges", {"A 0 1", "A 0 2"}}}};
    report = &said;
    settle();
    ASSERT_TRUE(items.count("monitor.note.0"));
    EXPECT_GT(items.at("monitor.note.0").top, items.at("monitor.ranges").bottom) << "below the rows";
    pick("monitor.ranges", "A 0 2");
    EXPECT_EQ(scenario.monitor.values.text("ranges"), "A 0 2");
    pick("monitor.ranges", "");
    EXPECT_EQ(scenario.monitor.values.text("ranges"), "") << "automatic";
}

TEST_F(PanelTest, ThePatchesOfAFileAreAList) {
    scenario.domain = domain_section(catalogue, "spline-patch");
    settle();
    ui.click(items.at("domain.patch"), drawing());
    settle();
    EXPECT_FALSE(items.count("domain.patch=1")) << "a file with one patch has a text field";
    const PatchList list{{"1: TensorNurbs2, id 7", "2: TensorBSpline2, id 8"}, 0, "patch 1 of 2"};
    patches = &list;
    ui.click(items.at("domain.cells"), drawing());
    settle();
    pick("domain.patch", "2");
    EXPECT_EQ(scenario.domain.values.text("patch"), "2");
    EXPECT_EQ(changes, 1);
}

TEST_F(PanelTest, ATypedValueOutOfRangeBecomesTheNearestAllowed) {
    settle();
    ui.double_click(items.at("domain.cells"), drawing());
    ui.type("1e9", drawing());
    ui.click(items.at("monitor.amplitude"), drawing());
    settle();
    EXPECT_EQ(scenario.domain.values.integer("cells"), 480);
}

TEST_F(PanelTest, UntickingAutoRestoresTheNumberThatWasThere) {
    settle();
    const auto tick = [&] {
        ui.click(items.at("method.step_size.auto"), drawing());
        settle();
        return scenario.method.values.real_or_auto("step_size");
    };
    EXPECT_EQ(opened.method.values.real("step_size"), 0.1);
    EXPECT_EQ(tick(), std::nullopt);
    EXPECT_EQ(tick(), 0.1);
    scenario.method.values.set("step_size", 0.037);
    settle();
    EXPECT_EQ(tick(), std::nullopt);
    EXPECT_EQ(tick(), 0.037);

    panel = {};
    scenario.method.values.set("step_size", std::string("auto"));
    settle();
    EXPECT_EQ(tick(), 0.1) << "nothing was there: the value with which the scenario was opened";
}

TEST_F(PanelTest, ControlAndClickOnASliderTypesItsValue) {
    settle();
    ui.control(true);
    ui.click(items.at("monitor.radius"), drawing());
    ui.control(false);
    settle();
    EXPECT_TRUE(ImGui::GetIO().WantTextInput);
    EXPECT_EQ(scenario, opened) << "the slider moved";
    ui.type("0.125", drawing());
    ui.click(items.at("domain.cells"), drawing());
    settle();
    EXPECT_EQ(scenario.monitor.values.real("radius"), 0.125);
}

TEST_F(PanelTest, ARowUnderTheMouseExplainsItselfBesideThePanel) {
    settle();
    EXPECT_EQ(ImGui::FindWindowByName("##Tooltip_00"), nullptr);
    const ItemRectangle slider = items.at("monitor.amplitude");
    ui.move(slider.center_x(), slider.center_y());
    settle();
    const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
    ASSERT_NE(tooltip, nullptr);
    EXPECT_TRUE(tooltip->Active);
    EXPECT_GE(tooltip->Pos.x, 380);
    EXPECT_GT(tooltip->Size.y, 3 * ImGui::GetFontSize());
    ui.move_away();
    settle();
    EXPECT_FALSE(tooltip->Active);
}

TEST_F(PanelTest, AnotherTypeTakesThatTypesRows) {
    settle();
    pick("monitor.type", "bell");
    EXPECT_EQ(scenario.monitor, monitor_section(catalogue, "bell"));
    EXPECT_FALSE(items.count("monitor.radius"));
    scenario.monitor.values.set("sharpness", 7.0);
    pick("monitor.type", "ring");
    EXPECT_EQ(scenario, opened) << "the values it was opened with come back";
}

TEST_F(PanelTest, TheMonitorsRowsFollowTheDomain) {
    scenario.monitor.values.set("amplitude", 3.0);
    settle();
    pick("domain.type", "cubed-sphere");
    EXPECT_EQ(scenario.domain.type, "cubed-sphere");
    EXPECT_EQ(scenario.monitor.values.real("amplitude"), 3);
    settle();
    EXPECT_TRUE(items.count("monitor.center_latitude"));
    EXPECT_FALSE(items.count("monitor.center_x"));
    pick("monitor.type", "x-n");
    EXPECT_EQ(scenario.monitor.type, "x-n");
    pick("monitor.type", "ring"); // as it was opened, but for this domain
    EXPECT_TRUE(scenario.monitor.values.has("center_longitude"));
    pick("monitor.type", "x-n");
    pick("domain.type", "plane"); // which has no such monitor
    EXPECT_EQ(scenario.monitor.type, "ring");
    EXPECT_TRUE(scenario.monitor.values.has("center_x"));
}

TEST_F(PanelTest, WhatDoesNotGoTogetherIsGreyedOut) {
    catalogue.capabilities.front().monitors = {"ring", "constant"};
    settle();
    pick("monitor.type", "bell");
    EXPECT_EQ(scenario, opened);
    ui.click({600, 800, 700, 850}, drawing()); // closes the list
    settle();
    pick("monitor.type", "constant");
    EXPECT_EQ(scenario.monitor.type, "constant");
}

TEST_F(PanelTest, AChoiceThatDoesNotGoWithTheRestIsGreyedOut) {
    catalogue.capabilities.front().boundaries = {"periodic"};
    settle();
    pick("domain.boundary", "walls");
    EXPECT_EQ(scenario.domain.values.text("boundary"), "periodic");
    catalogue.capabilities.front().boundaries = {"periodic", "walls"};
    ui.click({600, 800, 700, 850}, drawing());
    settle();
    pick("domain.boundary", "walls");
    EXPECT_EQ(scenario.domain.values.text("boundary"), "walls");
}

TEST_F(PanelTest, AnotherDomainBringsWhatGoesWithIt) {
    DomainType other = catalogue.domains.front();
    other.name = "other", other.label = "Other";
    Capability capability = catalogue.capabilities.front();
    capability.domain = "other", capability.monitors = {"bell"};
    catalogue.domains.push_back(other);
    catalogue.capabilities.push_back(capability);
    const auto changed = with_type(catalogue, opened, scenario, SectionKind::domain, "other");
    ASSERT_TRUE(changed.has_value());
    EXPECT_EQ(changed->domain.type, "other");
    EXPECT_EQ(changed->monitor.type, "bell");
    EXPECT_EQ(changed->method, scenario.method);
    EXPECT_FALSE(with_type(catalogue, opened, *changed, SectionKind::monitor, "ring").has_value());
}

TEST_F(PanelTest, OptionalSectionsAreThereIfTheProblemHasThem) {
    settle();
    EXPECT_EQ(items.count("pde.type") + items.count("monitor.source.type"), 0U);
    catalogue.pdes.push_back({.name = "heat",
                              .label = "Heat",
                              .help = "diffusion",
                              .equation = "",
                              .rows = {{.key = "conductivity",
                                        .label = "Conductivity",
                                        .minimum = 0.1,
                                        .maximum = 10,
                                        .default_value = 1.0}}});
    catalogue.capabilities.front().pdes = {"heat"};
    catalogue.capabilities.front().sources = {"bell", "constant"};
    update_rows(catalogue, scenario);
    settle();
    EXPECT_EQ(items.count("pde.conductivity"), 1U);
    EXPECT_EQ(items.count("monitor.source.amplitude"), 1U);
    pick("monitor.source.type", "constant");
    EXPECT_EQ(scenario.source.type, "constant");
    EXPECT_EQ(scenario.monitor.type, "ring");
}

} // namespace
} // namespace gaspard
