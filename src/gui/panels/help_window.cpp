#include "gui/panels/help_window.hpp"

#include "core/base/join.hpp"
#include "core/base/version.hpp"

#include <algorithm>
#include <cctype>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace gaspard {

namespace {

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

bool has_all_words(const std::string& text, std::string_view search) {
    const std::string lower = lower_case(text), wanted = lower_case(search);
    for (const std::string_view word : split(wanted, " "))
        if (lower.find(word) == std::string::npos) return false;
    return true;
}

/// In the middle of the screen when it appears.
bool begin_help_window(const char* title, bool& open) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({10 * em, 5 * em}, {0.95F * size.x, 0.9F * size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.5F * em);
    ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    const bool visible = ImGui::Begin(title, &open,
                                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                                          ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    return visible;
}

void draw_rows(std::span<const std::pair<std::string, std::string>> rows, Colour first, float width) {
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding,
                        {0.6F * ImGui::GetFontSize(), 0.2F * ImGui::GetFontSize()});
    if (ImGui::BeginTable("rows", 2, ImGuiTableFlags_SizingFixedFit)) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, width);
        for (const auto& [what, help] : rows) {
            ImGui::TableNextColumn();
            ImGui::TextColored(to_imgui(first), "%s", what.c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(help.c_str());
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

float widest_first(std::span<const std::pair<std::string, std::string>> rows) {
    float width = 0;
    for (const auto& row : rows) width = std::max(width, ImGui::CalcTextSize(row.first.c_str()).x);
    return width;
}

} // namespace

std::vector<HelpGroup> help_groups(std::span<const Action> actions, std::string_view search) {
    std::vector<HelpGroup> groups;
    for (const char* menu : {"File", "Edit", "Solve", "View", "Help"}) groups.push_back({menu, {}});
    for (const Action& action : actions) {
        const std::string keys = describe_keys(action), help(action.help);
        if (!has_all_words(keys + " " + std::string(action.label) + " " + help, search)) continue;
        auto group = std::ranges::find(groups, action.menu, &HelpGroup::title);
        if (group == groups.end()) group = groups.insert(groups.end(), {action.menu, {}});
        group->rows.emplace_back(keys, help);
    }
    HelpGroup mouse{"Mouse", {}};
    for (const MouseHelp& row : mouse_help())
        if (has_all_words(std::string(row.what) + " mouse " + std::string(row.help), search))
            mouse.rows.emplace_back(row.what, row.help);
    groups.push_back(std::move(mouse));
    std::erase_if(groups, [](const HelpGroup& group) { return group.rows.empty(); });
    return groups;
}

void HelpWindow::draw(std::span<const Action> actions, const Theme& theme, ItemRectangles& items) {
    if (!open_) return;
    if (begin_help_window("Keys and mouse", open_)) {
        if (std::exchange(fresh_, false)) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(18 * ImGui::GetFontSize());
        ImGui::InputTextWithHint("##search", "Search", &search_);
        remember_item(items, "help.search");
        // The field takes this key, which is meant for the window.
        if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) close();
        const std::vector<HelpGroup> all = help_groups(actions, {}), found = help_groups(actions, search_);
        float width = 0; // of the first column of all groups, whatever is searched for
        for (const HelpGroup& group : all) width = std::max(width, widest_first(group.rows));
        for (const HelpGroup& group : found) {
            ImGui::Spacing();
            ImGui::TextColored(to_imgui(theme.faint_text), "%s",
                               group.title.empty() ? "Others" : std::string(group.title).c_str());
            remember_item(items, "help." + std::string(group.title));
            ImGui::Separator();
            ImGui::PushID(std::string(group.title).c_str());
            draw_rows(group.rows, theme.accent, width);
            ImGui::PopID();
        }
        if (found.empty()) ImGui::TextDisabled("Nothing found.");
    }
    ImGui::End();
}

std::vector<std::pair<std::string, std::string>> about_lines() {
    return {{"Gaspard", std::string(version())},
            {"", "Adaptive meshes by the Monge–Ampère equation"},
            {"Licence", "MIT; fonts: Roboto (Apache 2.0), JetBrains Mono (OFL 1.1)"},
            {"Documentation", "the folder docs of the sources, or /usr/share/doc/gaspard; gaspard --help"},
            {"Dear ImGui", IMGUI_VERSION}};
}

void AboutWindow::draw(const Theme& theme, ItemRectangles& items) {
    if (!open_) return;
    if (begin_help_window("About Gaspard", open_)) {
        const auto lines = about_lines();
        draw_rows(lines, theme.accent, widest_first(lines));
        ImGui::Spacing();
        if (ImGui::Button("Copy")) {
            std::string text;
            for (const auto& [name, value] : lines) text += name + (name.empty() ? "" : ": ") + value + '\n';
            ImGui::SetClipboardText(text.c_str());
        }
        remember_item(items, "about.copy");
    }
    ImGui::End();
}

} // namespace gaspard
