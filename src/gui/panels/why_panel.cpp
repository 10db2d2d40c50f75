#include "gui/panels/why_panel.hpp"

#include "core/tessellate/ticks.hpp"

#include <cmath>
#include <imgui.h>

namespace gaspard {

namespace {

void draw_lines(const InterpolationComparison& errors, ItemRectangles& items) {
    if (!ImGui::BeginTable("errors", 4, ImGuiTableFlags_SizingStretchProp)) return;
    for (const char* head : {"Error", "Uniform", "Adapted", "Adapted is"}) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", head);
    }
    for (const ErrorNorm norm : error_norms) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(std::string(norm_label(norm)).c_str());
        remember_item(items, "why." + std::string(norm_name(norm)));
        for (const InterpolationError* error : {errors.uniform.get(), errors.adapted.get()}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(short_number(error->of(norm), 3).c_str());
        }
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(factor_text(errors.ratio(norm)).c_str());
    }
    ImGui::EndTable();
}

void draw_wrapped(const char* text) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x);
    ImGui::TextDisabled("%s", text);
    ImGui::PopTextWrapPos();
}

} // namespace

std::string factor_text(double ratio) {
    if (!std::isfinite(ratio) || ratio <= 0) return "–";
    if (std::abs(ratio - 1) < 5e-4) return "the same";
    return ratio > 1 ? short_number(ratio, 3) + "× smaller" : short_number(1 / ratio, 3) + "× larger";
}

WhyWish draw_why(const Snapshot* snapshot, bool measured, ItemRectangles& items) {
    WhyWish wish = WhyWish::none;
    if (!measured) {
        draw_wrapped(
            "How well the function can be interpolated on the uniform and on the adapted mesh, with as "
            "many cells.");
        if (ImGui::Button("Measure the errors")) wish = WhyWish::measure;
        remember_item(items, "why.measure");
        return wish;
    }
    if (!snapshot || !snapshot->interpolation) {
        draw_wrapped("The errors are measured when the run rests.");
        return wish;
    }
    draw_lines(*snapshot->interpolation, items);
    if (snapshot->interpolation->version != snapshot->version) draw_wrapped("Of an earlier iterate.");
    if (ImGui::Button("Maps side by side")) wish = WhyWish::maps;
    remember_item(items, "why.maps");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Colour both meshes by the error of each cell, on one scale");
    ImGui::SameLine();
    if (ImGui::Button("Gain by cell")) wish = WhyWish::factors;
    remember_item(items, "why.factors");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Colour the cells by the error before over the error after");
    return wish;
}

} // namespace gaspard
