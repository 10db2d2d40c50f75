#include "gui/panels/study_panel.hpp"

#include "core/io/interpolation_files.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/plot/plot_widget.hpp"

#include <cmath>
#include <imgui.h>
#include <string>
#include <utility>

namespace gaspard {

namespace {

void draw_faint_line(const std::string& text) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x);
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::PopTextWrapPos();
}

/// Both curves of one norm.
Plot plot_of(const std::vector<InterpolationRow>& rows, ErrorNorm norm) {
    Plot plot = why_plot(rows);
    const std::size_t first = 2 * static_cast<std::size_t>(norm);
    plot.title.clear();
    plot.curves = {std::move(plot.curves[first]), std::move(plot.curves[first + 1])};
    plot.curves[0].label = "uniform", plot.curves[1].label = "adapted";
    plot.curves[0].colour = 1, plot.curves[1].colour = 0; // the adapted mesh in the colour of the run
    return plot;
}

std::string state_text(const CellStudy::Result& result, bool current) {
    if (!current) return "Of earlier values; measured again when the run rests.";
    if (!result.complaint.empty()) return result.complaint;
    if (result.done) return {};
    if (result.total == 0) return "Solving on several meshes ...";
    return "Solving on mesh " + std::to_string(result.rows.size() + 1) + " of " +
           std::to_string(result.total) + " ...";
}

} // namespace

std::string order_text(const std::vector<InterpolationRow>& rows, ErrorNorm norm) {
    if (rows.empty()) return {};
    const auto i = static_cast<std::size_t>(norm);
    const double uniform = rows.back().uniform_order[i], adapted = rows.back().adapted_order[i];
    if (!std::isfinite(uniform) || !std::isfinite(adapted)) return {};
    return "Order: " + short_number(uniform, 3) + " uniform, " + short_number(adapted, 3) + " adapted";
}

void StudyPanel::draw_norms(const FrameContext& context) {
    bool first = true;
    for (const ErrorNorm norm : error_norms) {
        if (!std::exchange(first, false)) ImGui::SameLine(0, ImGui::GetStyle().ItemSpacing.x / 2);
        const Colour colour = norm == norm_ ? context.theme.accent : context.theme.faint_text;
        ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(colour));
        if (ImGui::Button(std::string(norm_label(norm)).c_str())) norm_ = norm;
        ImGui::PopStyleColor();
        remember_item(context.items, "why.study." + std::string(norm_name(norm)));
    }
}

void StudyPanel::draw(const CellStudy::Result& result, bool current, const FrameContext& context) {
    ImGui::Checkbox("Plot against the number of cells", &wanted_);
    remember_item(context.items, "why.study");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Solve on coarser and finer meshes in the background, as 'gaspard why' does");
    if (!wanted_) return;
    draw_norms(context);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, 13 * ImGui::GetFontSize()};
    draw_plot(*ImGui::GetWindowDrawList(), plot_of(result.rows, norm_),
              {corner, {corner.x + size.x, corner.y + size.y}}, context.theme, context.scale);
    ImGui::Dummy(size);
    remember_item(context.items, "why.study.plot");
    if (const std::string order = order_text(result.rows, norm_); !order.empty()) {
        draw_faint_line(order);
        remember_item(context.items, "why.study.order");
    }
    if (const std::string state = state_text(result, current); !state.empty()) draw_faint_line(state);
    for (const InterpolationRow& row : result.rows)
        if (const std::string note = interpolation_note(row); !note.empty()) draw_faint_line(note);
}

} // namespace gaspard
