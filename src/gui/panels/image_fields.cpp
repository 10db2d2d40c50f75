#include "gui/panels/image_fields.hpp"

#include <imgui.h>
#include <utility>

namespace gaspard {

void label_before(const char* label) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(8 * ImGui::GetFontSize());
}

bool number_field(const char* id, double& value, const char* format) {
    ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
    return ImGui::InputDouble(id, &value, 0, 0, format);
}

void draw_shown_parts(Values& view, const std::string& keys, ItemRectangles& items) {
    label_before("Show");
    for (const auto& [key, label] : {std::pair("axes", "Axes"), std::pair("legend", "Legend"),
                                     std::pair("caption", "Caption"), std::pair("note", "Notes")}) {
        bool shown = view.boolean(key);
        if (ImGui::Checkbox(label, &shown)) view.set(key, shown);
        remember_item(items, keys + "." + key);
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

} // namespace gaspard
