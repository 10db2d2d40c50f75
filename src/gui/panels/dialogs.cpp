#include "gui/panels/dialogs.hpp"

#include "gui/panels/modal.hpp"

#include <algorithm>
#include <imgui.h>

namespace gaspard {

namespace {

void help_line(const Theme& theme, const std::string& what, std::string_view help) {
    ImGui::TableNextColumn();
    ImGui::TextColored(to_imgui(theme.accent), "%s", what.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(help.data(), help.data() + help.size());
}

} // namespace

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

void draw_help(bool& open, std::span<const Action> actions, const Theme& theme) {
    if (!open) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({10 * em, 5 * em}, {0.95F * size.x, 0.9F * size.y});
    const ModalFrame frame;
    if (ImGui::Begin("Keys and mouse", &open,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoSavedSettings)) {
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0.6F * em, 0.25F * em});
        if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
            for (const Action& row : actions) help_line(theme, describe_keys(row), row.help);
            for (const MouseHelp& row : mouse_help()) help_line(theme, std::string(row.what), row.help);
            ImGui::EndTable();
        }
        ImGui::PopStyleVar();
    }
    ImGui::End();
}

bool draw_progress(const std::string& what, double fraction, const ItemRectangle& over,
                   ItemRectangles& items) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({over.left + em, over.bottom - em}, ImGuiCond_Always, {0, 1});
    ImGui::Begin("##progress", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
    ImGui::ProgressBar(static_cast<float>(std::clamp(fraction, 0.0, 1.0)), {20 * em, 1.6F * em},
                       what.c_str());
    remember_item(items, "progress");
    ImGui::SameLine();
    const bool cancel = ImGui::Button("Cancel");
    remember_item(items, "progress.cancel");
    ImGui::End();
    return cancel;
}

} // namespace gaspard
