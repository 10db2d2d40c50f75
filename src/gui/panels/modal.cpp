#include "gui/panels/modal.hpp"

#include <algorithm>
#include <imgui.h>

namespace gaspard {

namespace {

constexpr ImGuiWindowFlags modal_flags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;

void place_modal(const char* title) {
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
}

} // namespace

ModalFrame::ModalFrame() {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.5F * ImGui::GetFontSize());
    ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
}

ModalFrame::~ModalFrame() {
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

bool begin_modal(const char* title) {
    place_modal(title);
    const ModalFrame frame;
    return ImGui::BeginPopupModal(title, nullptr, modal_flags | ImGuiWindowFlags_AlwaysAutoResize);
}

bool begin_modal(const char* title, float width, float height) {
    place_modal(title);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSize({std::min(width, 0.96F * size.x), std::min(height, 0.94F * size.y)},
                             ImGuiCond_Always);
    const ModalFrame frame;
    return ImGui::BeginPopupModal(title, nullptr, modal_flags | ImGuiWindowFlags_NoResize);
}

float modal_text_width() { return std::min(34 * ImGui::GetFontSize(), 0.85F * ImGui::GetIO().DisplaySize.x); }

ModalAnswer draw_modal_buttons(const std::string& keys, const char* accept, bool enabled,
                               ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    auto answer = ModalAnswer::none;
    ImGui::BeginDisabled(!enabled);
    if (ImGui::Button(accept, {6 * em, 0})) answer = ModalAnswer::accept;
    ImGui::EndDisabled();
    remember_item(items, keys + ".ok");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {6 * em, 0})) answer = ModalAnswer::cancel;
    remember_item(items, keys + ".cancel");
    return answer;
}

} // namespace gaspard
