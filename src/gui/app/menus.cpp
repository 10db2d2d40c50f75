#include "gui/app/menus.hpp"

#include "core/io/formats.hpp"
#include "gui/base/icons.hpp"
#include "gui/base/part_window.hpp"

#include <algorithm>
#include <cmath>
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

bool has_splines(const MenuContext& context) {
    return context.catalogue.domain(context.run.scenario.domain.type).spline_patch;
}

/// Selecting one exports the run in this format alone.
Choice draw_formats(const MenuContext& context) {
    const bool open = ImGui::BeginMenu("Export as", context.run.live());
    remember_item(context.frame.items, "menu.export-as");
    if (!open) return {};
    Choice chosen;
    for (const Format& format : formats()) {
        const bool possible = !format.splines_only || has_splines(context);
        if (ImGui::MenuItem(format.name.c_str(), nullptr, false, possible))
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
        if (row.name == "export-to") take(draw_formats(context));
    }
    return chosen;
}

/// `label`: whether there is space for it beside the icon.
bool draw_button(const MenuContext& context, const Action& row, bool label) {
    ImGui::BeginDisabled(!row.is_enabled());
    const std::string id = "##" + std::string(row.name);
    const std::string text(label ? row.label : std::string_view());
    const bool pressed = icon_button(id.c_str(), row.icon, text.c_str());
    ImGui::EndDisabled();
    remember_item(context.frame.items, "action." + std::string(row.name));
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("%s", row.is_enabled() ? (row.current_label() + "\n" + tooltip_of(row)).c_str()
                                                 : row.why_disabled().c_str());
    return pressed;
}

float button_width(const Action& row, bool label) {
    return icon_button_width(label ? std::string(row.label).c_str() : "");
}

/// The height of the bar, and where its buttons begin below its upper edge.
struct BarSizes {
    float padding, button_padding, offset;
    BarSizes()
        : padding(std::round(0.55F * ImGui::GetFontSize())),
          button_padding(std::round(0.27F * ImGui::GetFontSize())), offset(padding - button_padding) {}
};

} // namespace

std::optional<MenuChoice> Menus::draw_bar(const MenuContext& context) {
    const BarSizes sizes;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.6F * ImGui::GetFontSize(), sizes.padding});
    const bool drawn = ImGui::BeginMainMenuBar();
    height_ = std::round(ImGui::GetFrameHeight());
    Choice chosen;
    if (drawn) {
        for (const char* menu : {"File", "Edit", "Solve", "View", "Help"}) {
            const bool open = ImGui::BeginMenu(menu);
            remember_item(context.frame.items, "menu." + std::string(menu));
            if (!open) continue;
            ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                                {0.6F * ImGui::GetFontSize(), sizes.button_padding});
            if (auto one = draw_menu(context, menu)) chosen = std::move(one);
            ImGui::PopStyleVar();
            ImGui::EndMenu();
        }
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.6F * ImGui::GetFontSize(), sizes.button_padding});
    if (drawn) {
        if (auto one = draw_buttons(context)) chosen = std::move(one);
        ImGui::EndMainMenuBar();
    }
    ImGui::PopStyleVar(2);
    return chosen;
}

/// The list of scenarios after the menus, and the buttons at the right end; labels as far as there is space.
std::optional<MenuChoice> Menus::draw_buttons(const MenuContext& context) {
    const float em = ImGui::GetFontSize(), gap = 0.5F * em, top = BarSizes().offset;
    const float left = ImGui::GetCursorPosX() + em, right = ImGui::GetWindowWidth() - 0.6F * em;
    const auto all = [&](bool labels) {
        float sum = 0;
        int group = 0;
        for (const Action& row : context.actions)
            if (row.toolbar > 0) {
                sum += button_width(row, labels) + (group == row.toolbar ? gap : 1.6F * em);
                group = row.toolbar;
            }
        return sum;
    };
    constexpr float least = 9, most = 24; // in widths of the font
    const bool labels = right - left - all(true) >= least * em;
    const float list = std::clamp(right - left - all(labels), 4 * em, most * em);
    Choice chosen;
    ImGui::SetCursorPos({left, top});
    if (auto one = draw_scenarios(context, list)) chosen = std::move(one);
    float at = right - all(labels);
    int group = 0;
    for (const Action& row : context.actions) {
        if (row.toolbar == 0 || at + button_width(row, labels) < left + list) continue; // no space
        at += row.toolbar == group ? gap : 1.6F * em;
        group = row.toolbar;
        ImGui::SetCursorPos({at, top});
        if (draw_button(context, row, labels)) chosen = {Kind::action, std::string(row.name)};
        at += button_width(row, labels);
    }
    return chosen;
}

std::optional<MenuChoice> Menus::draw_scenarios(const MenuContext& context, float width) {
    const auto chosen = scenarios_.draw(context.catalogue, context.run, context.recent, width, context.frame);
    if (!chosen) return {};
    return MenuChoice{chosen->file ? Kind::file : Kind::scenario, chosen->name};
}

} // namespace gaspard
