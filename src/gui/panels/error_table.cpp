#include "gui/panels/error_table.hpp"

#include "core/base/number_text.hpp"
#include "core/io/study_files.hpp"
#include "core/tessellate/ticks.hpp"

#include <cmath>
#include <imgui.h>
#include <string>

namespace gaspard {

namespace {

void draw_cell(const StudyPoint* point, const std::string& measure, const std::string& key,
               ItemRectangles& items) {
    ImGui::TableNextColumn();
    if (!point) return;
    const double error = study_value(*point, measure);
    ImGui::TextUnformatted(std::isfinite(error) ? short_number(error, 3).c_str() : "–");
    remember_item(items, key);
    const std::string note = study_note(*point);
    if (ImGui::IsItemHovered() && !note.empty()) ImGui::SetTooltip("%s", note.c_str());
}

} // namespace

void draw_error_table(const ErrorStudy& study, ItemRectangles& items) {
    const StudyPlan* plan = study.plan();
    if (!plan) return ImGui::TextDisabled("Computed when the run rests.");
    const ErrorStudy::Result result = study.result();
    const auto columns = static_cast<int>(plan->line_count()) + 1;
    if (!ImGui::BeginTable("table", columns, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", study_row(plan->scenario, plan->over.key)->symbol.c_str());
    for (std::size_t line = 0; line < plan->line_count(); ++line) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", line_label(*plan, line).c_str());
    }
    for (std::size_t place = 0; place < plan->over.values.size(); ++place) {
        ImGui::TableNextColumn();
        const auto number = parse_number(plan->over.values[place]);
        ImGui::TextDisabled("%s", number ? short_number(*number).c_str() : plan->over.values[place].c_str());
        for (std::size_t line = 0; line < plan->line_count(); ++line)
            draw_cell(find_point(result.points, line, place), plan->measure,
                      "errors." + std::to_string(place) + "." + std::to_string(line), items);
    }
    ImGui::EndTable();
    if (!study.current()) ImGui::TextDisabled("Of earlier values; computed again when the run rests.");
}

} // namespace gaspard
