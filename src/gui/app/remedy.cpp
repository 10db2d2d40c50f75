#include "gui/app/remedy.hpp"

#include "gui/base/part_window.hpp"

#include <algorithm>
#include <imgui.h>

namespace gaspard {

bool draw_remedy(const std::string& text, const Action& action, const ItemRectangle& viewport,
                 const FrameContext& context) {
    if (text.empty()) return false;
    const float em = ImGui::GetFontSize();
    const std::string label = std::string(action.label) + " (" + describe_keys(action) + ")";
    const float button = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    const float widest = std::max(12 * em, viewport.width() - 4 * em);
    const float wanted = ImGui::CalcTextSize(text.c_str()).x + button + 4 * em;
    const float width = std::min(wanted, widest);
    const float wrap = width - button - 3.4F * em;
    const float height = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap).y + 1.6F * em;
    const float left = (viewport.left + viewport.right - width) / 2, bottom = viewport.bottom - 3.2F * em;
    begin_part("##remedy", {left, bottom - height, left + width, bottom}, ImGuiWindowFlags_NoScrollbar, true);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    list.AddRect({left, bottom - height}, {left + width, bottom}, packed(context.theme.warning), 0, 0,
                 1.5F * context.scale);
    list.PopClipRect();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wrap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SetCursorPos({width - button - em, (height - ImGui::GetFrameHeight()) / 2});
    const bool pressed = ImGui::Button(label.c_str());
    remember_item(context.items, "remedy");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%.*s", static_cast<int>(action.help.size()), action.help.data());
    ImGui::End();
    return pressed;
}

} // namespace gaspard
