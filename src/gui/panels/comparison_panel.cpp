#include "gui/panels/comparison_panel.hpp"

#include "core/tessellate/ticks.hpp"
#include "gui/panels/status_bar.hpp"

#include <algorithm>
#include <imgui.h>
#include <utility>

namespace gaspard {

namespace {

StatusCell state_of(const ComparisonRow& row) {
    SolverStatus status;
    status.run = row.status;
    return describe_state(status, true);
}

/// What the table says of a method, in the order of comparison_heads() without the first.
std::vector<std::string> cells_of(const ComparisonRow& row) {
    const std::string status = state_of(row).value;
    if (row.status == RunStatus::preparing) return {"", "", "", "", "", "", "", "", status};
    const std::string criterion = row.criterion == "residual" ? "" : row.criterion + " ";
    return {std::to_string(row.iterations),
            std::to_string(row.coarse_iterations),
            std::to_string(row.inner_iterations),
            short_number(row.cpu_seconds, 3),
            short_number(row.residual, 2),
            criterion + short_number(row.criterion_value, 2),
            row.equidistribution ? short_number(*row.equidistribution, 4) : "",
            row.tangled_cells ? std::to_string(*row.tangled_cells) : "",
            status};
}

/// One column per method, so that the table is narrow enough to stand beside the meshes.
void draw_table(const std::vector<ComparisonRow>& rows, const Catalogue& catalogue, const Theme& theme,
                ItemRectangles& items) {
    const auto heads = comparison_heads();
    const float em = ImGui::GetFontSize();
    const float height = static_cast<float>(heads.size()) * (em + 2 * ImGui::GetStyle().CellPadding.y) +
                         ImGui::GetStyle().ScrollbarSize + 0.5F * em;
    if (!ImGui::BeginTable("methods", static_cast<int>(rows.size()) + 1,
                           ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollX,
                           {0, height}))
        return;
    ImGui::TableSetupScrollFreeze(1, 1);
    ImGui::TableSetupColumn("##quantity");
    for (const ComparisonRow& row : rows) ImGui::TableSetupColumn(catalogue.method(row.method).label.c_str());
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    for (const ComparisonRow& row : rows) {
        ImGui::TableNextColumn();
        ImGui::TableHeader(catalogue.method(row.method).label.c_str());
        remember_item(items, "compare.row." + row.method);
    }
    std::vector<std::vector<std::string>> columns;
    for (const ComparisonRow& row : rows) columns.push_back(cells_of(row));
    for (std::size_t i = 0; i + 1 < heads.size(); ++i) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", heads[i + 1].c_str());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            ImGui::TableNextColumn();
            const bool status = i + 2 == heads.size();
            const Tone tone = status ? state_of(rows[k]).tone : Tone::plain;
            ImGui::TextColored(tone_colour(theme, tone), "%s", columns[k][i].c_str());
        }
    }
    ImGui::EndTable();
}

/// On the line of what was drawn last, if `width` still fits there.
void same_line_if_it_fits(float width) {
    const float spacing = ImGui::GetFontSize();
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + spacing + width < right) ImGui::SameLine(0, spacing);
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

/// A check box for each method.
void ComparisonPanel::draw_methods(const Document& document, const Catalogue& catalogue,
                                   ItemRectangles& items) {
    bool first = true;
    ImGui::BeginDisabled(document.comparison().running());
    for (const std::string& name : methods_for(catalogue, document.active().scenario)) {
        const MethodType& method = catalogue.method(name);
        const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
        if (!std::exchange(first, false))
            same_line_if_it_fits(box + ImGui::CalcTextSize(method.label.c_str()).x);
        bool ticked = left_out_.count(name) == 0;
        if (ImGui::Checkbox(method.label.c_str(), &ticked)) {
            if (ticked)
                left_out_.erase(name);
            else
                left_out_.insert(name);
        }
        remember_item(items, "compare." + name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", method.help.c_str());
    }
    ImGui::EndDisabled();
}

ComparisonPanel::Wish ComparisonPanel::draw_buttons(const Document& document, const Catalogue& catalogue,
                                                    ItemRectangles& items) {
    Wish wish = Wish::none;
    const auto button = [&](const char* label, const char* key, Wish meaning, bool possible = true) {
        ImGui::BeginDisabled(!possible);
        if (ImGui::Button(label)) wish = meaning;
        ImGui::EndDisabled();
        remember_item(items, key);
    };
    if (document.comparison().running()) {
        button("Cancel", "compare.cancel", Wish::cancel);
        ImGui::SameLine();
        ImGui::ProgressBar(static_cast<float>(document.comparison().progress()), {-1, 0});
    } else {
        button("Solve with each method", "compare.begin", Wish::begin,
               !chosen(document, catalogue).empty() && document.active().live());
    }
    const bool any = !document.comparison().rows().empty();
    button("Meshes side by side", "compare.meshes", Wish::meshes, any);
    same_line_if_it_fits(ImGui::CalcTextSize("Copy as CSV").x + 2 * ImGui::GetStyle().FramePadding.x);
    button("Copy as CSV", "compare.copy", Wish::copy, any);
    return wish;
}

ComparisonPanel::Wish ComparisonPanel::draw(const Document& document, const Catalogue& catalogue,
                                            const ItemRectangle& area, const Theme& theme,
                                            ItemRectangles& items) {
    if (!open_) return Wish::none;
    Wish wish = Wish::none;
    const float em = ImGui::GetFontSize();
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float width = std::min(std::max(area.width(), 18 * em), 0.95F * size.x);
    const float height = std::min(26 * em, 0.9F * (size.y - area.top));
    ImGui::SetNextWindowPos({size.x - width, std::min(area.top, size.y - height)}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize({width, height}, ImGuiCond_Appearing);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    if (ImGui::Begin("Compare methods", &open_,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        draw_methods(document, catalogue, items);
        wish = draw_buttons(document, catalogue, items);
        const auto rows = document.comparison().rows();
        if (!rows.empty()) {
            const Scenario& compared = document.comparison().scenario();
            if (!same_problem(compared, document.active().scenario)) {
                ImGui::PushTextWrapPos(0);
                ImGui::TextColored(tone_colour(theme, Tone::warning),
                                   "For the values compared, not the present ones: %s",
                                   scenario_title(compared).c_str());
                ImGui::PopTextWrapPos();
                remember_item(items, "compare.other");
            }
            draw_table(rows, catalogue, theme, items);
        }
        const ImVec2 low = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
        items["compare"] = {low.x, low.y, low.x + extent.x, low.y + extent.y};
    }
    ImGui::End();
    ImGui::PopStyleVar();
    return wish;
}

} // namespace gaspard
