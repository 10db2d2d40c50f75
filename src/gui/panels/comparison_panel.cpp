#include "gui/panels/comparison_panel.hpp"

#include "gui/panels/status_bar.hpp"

#include <imgui.h>

namespace gaspard {

namespace {

void draw_table(const std::vector<ComparisonRow>& rows, const Theme& theme, ItemRectangles& items) {
    const auto heads = comparison_heads();
    if (!ImGui::BeginTable("methods", static_cast<int>(heads.size()),
                           ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg))
        return;
    for (const std::string& head : heads) ImGui::TableSetupColumn(head.c_str());
    ImGui::TableHeadersRow();
    for (const ComparisonRow& row : rows) {
        const auto cells = comparison_cells(row);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            ImGui::TableNextColumn();
            if (i + 1 < cells.size()) {
                ImGui::TextUnformatted(cells[i].c_str());
                continue;
            }
            SolverStatus status;
            status.run = row.status;
            ImGui::TextColored(tone_colour(theme, describe_state(status, true).tone), "%s", cells[i].c_str());
        }
        remember_item(items, "compare.row." + row.method);
    }
    ImGui::EndTable();
}

/// Whether the same mesh is to be found, by whatever method.
bool same_problem(const Scenario& a, const Scenario& b) {
    return a.domain == b.domain && a.monitor == b.monitor && a.source == b.source && a.pde == b.pde;
}

} // namespace

std::vector<std::string> ComparisonPanel::chosen(const Document& document, const Catalogue& catalogue) const {
    std::vector<std::string> names;
    for (std::string& name : methods_for(catalogue, document.active().scenario))
        if (left_out_.count(name) == 0) names.push_back(std::move(name));
    return names;
}

ComparisonPanel::Wish ComparisonPanel::draw(const Document& document, const Catalogue& catalogue,
                                            const Theme& theme, ItemRectangles& items) {
    if (!open_) return Wish::none;
    Wish wish = Wish::none;
    const float em = ImGui::GetFontSize();
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x / 2, 0.7F * size.y}, ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({20 * em, 5 * em}, {0.95F * size.x, 0.9F * size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    if (ImGui::Begin("Compare methods", &open_,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoSavedSettings)) {
        ImGui::BeginDisabled(document.comparison().running());
        for (const std::string& name : methods_for(catalogue, document.active().scenario)) {
            bool ticked = left_out_.count(name) == 0;
            if (ImGui::Checkbox(name.c_str(), &ticked)) {
                if (ticked)
                    left_out_.erase(name);
                else
                    left_out_.insert(name);
            }
            remember_item(items, "compare." + name);
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", catalogue.method(name).help.c_str());
            ImGui::SameLine(0, 1.2F * em);
        }
        ImGui::EndDisabled();
        ImGui::NewLine();
        const auto button = [&](const char* label, const char* key, Wish meaning) {
            if (ImGui::Button(label)) wish = meaning;
            remember_item(items, key);
            ImGui::SameLine();
        };
        if (document.comparison().running()) {
            button("Cancel", "compare.cancel", Wish::cancel);
            ImGui::ProgressBar(static_cast<float>(document.comparison().progress()), {14 * em, 0});
            ImGui::SameLine();
        } else {
            ImGui::BeginDisabled(chosen(document, catalogue).empty() || !document.active().live());
            button("Solve with each method", "compare.begin", Wish::begin);
            ImGui::EndDisabled();
        }
        const auto rows = document.comparison().rows();
        ImGui::BeginDisabled(rows.empty());
        button("Meshes side by side", "compare.meshes", Wish::meshes);
        button("Copy as CSV", "compare.copy", Wish::copy);
        ImGui::EndDisabled();
        ImGui::NewLine();
        if (!rows.empty()) {
            const Scenario& compared = document.comparison().scenario();
            if (!same_problem(compared, document.active().scenario)) {
                ImGui::TextColored(tone_colour(theme, Tone::warning),
                                   "For the values compared, not the present ones: %s",
                                   scenario_title(compared).c_str());
                remember_item(items, "compare.other");
            }
            draw_table(rows, theme, items);
        }
        const ImVec2 low = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
        items["compare"] = {low.x, low.y, low.x + extent.x, low.y + extent.y};
    }
    ImGui::End();
    ImGui::PopStyleVar();
    return wish;
}

} // namespace gaspard
