#include "gui/app/menus.hpp"

#include "core/io/formats.hpp"
#include "core/scenario/toml.hpp"
#include "gui/base/icons.hpp"
#include "gui/base/part_window.hpp"

#include <algorithm>
#include <imgui.h>

namespace gaspard {

namespace {

using Choice = std::optional<MenuChoice>;
using Kind = MenuChoice::Kind;

Choice draw_recent(const MenuContext& context) {
    if (!ImGui::BeginMenu("Open recent", !context.recent.empty())) return {};
    Choice chosen;
    for (std::size_t i = 0; i < context.recent.size(); ++i) {
        if (ImGui::MenuItem(context.recent[i].c_str())) chosen = {Kind::file, context.recent[i]};
        remember_item(context.frame.items, "recent." + std::to_string(i));
    }
    ImGui::EndMenu();
    return chosen;
}

Choice draw_formats(const MenuContext& context) {
    if (!ImGui::BeginMenu("Export as", context.run.live())) return {};
    Choice chosen;
    for (const Format& format : formats()) {
        if (ImGui::MenuItem(format.name.c_str(), nullptr, exports(context.run.scenario, format.name)))
            chosen = {Kind::format, format.name};
        remember_item(context.frame.items, "format." + format.name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", format.help.c_str());
    }
    ImGui::EndMenu();
    return chosen;
}

Choice draw_menu(const MenuContext& context, std::string_view menu) {
    Choice chosen;
    const auto take = [&chosen](Choice one) {
        if (one) chosen = std::move(one);
    };
    for (const Action& row : context.actions) {
        if (row.menu != menu) continue;
        if (ImGui::MenuItem(row.current_label().c_str(), describe_keys(row).c_str(), row.is_checked(),
                            row.is_enabled()))
            chosen = {Kind::action, std::string(row.name)};
        remember_item(context.frame.items, "menu." + std::string(row.name));
        if (row.name == "open") take(draw_recent(context));
        if (row.name == "export") take(draw_formats(context));
    }
    return chosen;
}

bool draw_button(const MenuContext& context, const Action& row) {
    const bool main = row.name == "run"; // highlighted, because users look for it first
    if (main) {
        const Theme& theme = context.frame.theme;
        const ImVec4 accent = to_imgui(theme.accent);
        ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(theme.background));
        ImGui::PushStyleColor(ImGuiCol_Button, accent);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrabActive));
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, accent);
    }
    ImGui::BeginDisabled(!row.is_enabled());
    const std::string id = "##" + std::string(row.name);
    const Icon icon = main && context.run.solving() ? Icon::pause : row.icon;
    const bool pressed =
        icon_button(id.c_str(), icon, row.current_label().c_str(), main ? 7.5F * ImGui::GetFontSize() : 0);
    ImGui::EndDisabled();
    if (main) ImGui::PopStyleColor(4);
    remember_item(context.frame.items, "action." + std::string(row.name));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltip_of(row).c_str());
    return pressed;
}

} // namespace

std::optional<MenuChoice> Menus::draw_menu_bar(const MenuContext& context) {
    if (!ImGui::BeginMainMenuBar()) return {};
    Choice chosen;
    for (const char* menu : {"File", "Edit", "Solve", "View", "Help"}) {
        const bool open = ImGui::BeginMenu(menu);
        remember_item(context.frame.items, "menu." + std::string(menu));
        if (!open) continue;
        if (auto one = draw_menu(context, menu)) chosen = std::move(one);
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
    return chosen;
}

std::optional<MenuChoice> Menus::draw_toolbar(const MenuContext& context, const ItemRectangle& place) {
    begin_part("##toolbar", place);
    const float em = ImGui::GetFontSize();
    Choice chosen;
    int group = 0;
    for (const Action& row : context.actions) {
        if (row.toolbar == 0) continue;
        if (group != 0) ImGui::SameLine(0, row.toolbar == group ? 0.5F * em : 1.6F * em);
        if (draw_button(context, row)) chosen = {Kind::action, std::string(row.name)};
        group = row.toolbar;
    }
    ImGui::SameLine(0, 0.5F * em);
    if (auto one = draw_scenarios(context)) chosen = std::move(one);
    ImGui::End();
    return chosen;
}

std::optional<MenuChoice> Menus::draw_scenarios(const MenuContext& context) {
    const float em = ImGui::GetFontSize();
    const float right = ImGui::GetWindowContentRegionMax().x;
    ImGui::SameLine(std::max(ImGui::GetCursorPosX(), right - 19 * em));
    ImGui::SetNextItemWidth(std::max(4 * em, right - ImGui::GetCursorPosX()));
    const bool open = ImGui::BeginCombo("##scenario", context.run.title.c_str());
    remember_item(context.frame.items, "scenario");
    if (!open) return {};
    if (shipped_.empty())
        for (const BuiltinScenario& one : builtin_scenarios())
            shipped_.push_back(find_scenario(context.catalogue, std::string(one.name)));
    float widest = 0;
    for (const Scenario& one : shipped_) widest = std::max(widest, ImGui::CalcTextSize(one.title.c_str()).x);
    Choice chosen;
    for (const Scenario& one : shipped_) {
        const std::string id = "##" + one.name;
        if (ImGui::Selectable(id.c_str(),
                              context.run.scenario.name == one.name && context.run.scenario.modified.empty()))
            chosen = {Kind::scenario, one.name};
        remember_item(context.frame.items, "scenario=" + one.name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", one.description.c_str());
        ImGui::SameLine(0, 0);
        ImGui::TextUnformatted(one.title.c_str());
        ImGui::SameLine(widest + 2 * em);
        ImGui::TextDisabled("%s", one.name.c_str());
    }
    if (!context.recent.empty()) ImGui::Separator();
    for (const std::string& file : context.recent)
        if (ImGui::Selectable(file.c_str())) chosen = {Kind::file, file};
    ImGui::EndCombo();
    return chosen;
}

} // namespace gaspard
