#include "gui/panels/dialogs.hpp"

#include "gui/panels/modal.hpp"

#include <algorithm>
#include <imgui.h>

namespace gaspard {

void ErrorDialog::draw(ItemRectangles& items) {
    if (!open()) return;
    if (!begin_modal("Error")) return;
    ImGui::PushTextWrapPos(modal_text_width());
    ImGui::TextUnformatted(sentence_.c_str());
    ImGui::PopTextWrapPos();
    remember_item(items, "error");
    ImGui::Spacing();
    const float em = ImGui::GetFontSize();
    if (ImGui::Button("OK", {6 * em, 0}) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter))) close();
    remember_item(items, "error.ok");
    ImGui::SameLine();
    if (ImGui::Button("Copy", {6 * em, 0})) ImGui::SetClipboardText(sentence_.c_str());
    if (!open()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

bool draw_progress(const std::string& what, double fraction, const ItemRectangle& over, ItemRectangles& items,
                   const std::string& key) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({over.left + em, over.bottom - em}, ImGuiCond_Always, {0, 1});
    ImGui::Begin(("##" + key).c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
    ImGui::ProgressBar(static_cast<float>(std::clamp(fraction, 0.0, 1.0)), {20 * em, 1.6F * em},
                       what.c_str());
    remember_item(items, key);
    ImGui::SameLine();
    const bool cancel = ImGui::Button("Cancel");
    remember_item(items, key + ".cancel");
    ImGui::End();
    return cancel;
}

} // namespace gaspard
