#include "gui/panels/file_row.hpp"

#include "core/base/read_data_file.hpp"
#include "core/base/user_path.hpp"

#include <algorithm>
#include <imgui.h>

namespace gaspard {

namespace {

/// The text with its middle left out so that it fits; names differ at both ends.
std::string shortened(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    for (std::size_t kept = text.size(); kept > 2; --kept) {
        std::size_t head = kept / 2, tail = text.size() - (kept - head);
        const auto inside = [&](std::size_t at) {
            return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U;
        };
        while (head > 0 && inside(head)) --head;
        while (inside(tail)) ++tail;
        const std::string one = text.substr(0, head) + "…" + text.substr(tail);
        if (ImGui::CalcTextSize(one.c_str()).x <= width) return one;
    }
    return "…";
}

} // namespace

std::string file_label(std::string_view value) {
    if (value.find_first_not_of(" \t\r\n") == std::string_view::npos) return "Choose a file";
    if (is_data_uri(value)) {
        const std::size_t kilobytes = (value.size() * 3 / 4 + 999) / 1000; // base64
        return "in the scenario, " + std::to_string(kilobytes) + " kB";
    }
    if (is_shipped_data(value)) return std::string(value.substr(value.find(':') + 1)) + " (built in)";
    if (!is_path(value)) return "text in the scenario";
    const std::string name = std::filesystem::path(value).filename().string();
    return name.empty() ? std::string(value) : name;
}

bool draw_file(const std::string& key, std::string_view value, float width, ItemRectangles& items) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight(), em = ImGui::GetFontSize();
    const bool pressed = ImGui::Button("##file", {width, height});
    remember_item(items, key);
    const bool empty = value.empty();
    if (ImGui::IsItemHovered() && !empty && is_path(value))
        ImGui::SetTooltip("%s", std::string(value).c_str());
    const float padding = ImGui::GetStyle().FramePadding.x, room = width - 2 * padding - 1.4F * em;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText({corner.x + padding, corner.y + ImGui::GetStyle().FramePadding.y},
                 ImGui::GetColorU32(empty ? ImGuiCol_TextDisabled : ImGuiCol_Text),
                 shortened(file_label(value), room).c_str());
    const float dot = std::max(1.0F, 0.08F * em), middle = corner.y + height / 2;
    for (const float at : {0.35F, 0.7F, 1.05F}) // as on a button that opens a dialog
        list.AddCircleFilled({corner.x + width - padding - 1.4F * em + at * em, middle}, dot,
                             ImGui::GetColorU32(ImGuiCol_Text), 8);
    return pressed;
}

} // namespace gaspard
