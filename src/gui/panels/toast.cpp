#include "gui/panels/toast.hpp"

#include "gui/base/part_window.hpp"

#include <algorithm>
#include <imgui.h>

namespace gaspard {

namespace {

std::string label_of(const Action& action) {
    const std::string keys = describe_keys(action);
    return std::string(action.label) + (keys.empty() ? "" : " (" + keys + ")");
}

} // namespace

bool ToastPanel::draw(const Toast& toast, const ItemRectangle& viewport, const FrameContext& context) {
    if (toast.text.empty()) dismissed_.clear();
    if (!shows(toast)) return false;
    const float em = ImGui::GetFontSize(), frame = ImGui::GetFrameHeight();
    const std::string label = toast.action ? label_of(*toast.action) : std::string();
    const float button =
        toast.action ? ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x + em : 0;
    const float close = toast.closable ? frame : 0, sides = 2.2F * em + button + close;
    const float widest = std::max(12 * em, viewport.width() - 4 * em);
    const float width = std::min(ImGui::CalcTextSize(toast.text.c_str()).x + sides + 2, widest);
    const float wrap = width - sides;
    const float text = ImGui::CalcTextSize(toast.text.c_str(), nullptr, false, wrap).y;
    const float height = std::max(text, frame) + 1.0F * em;
    // Above the notes of the view.
    const float left = (viewport.left + viewport.right - width) / 2, bottom = viewport.bottom - 3 * em;
    const float top = bottom - height;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 5 * context.scale);
    begin_part("##toast", {left, top, left + width, bottom}, ImGuiWindowFlags_NoScrollbar, true);
    ImGui::PopStyleVar(2);
    context.items["message"] = {left, top, left + width, bottom};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 colour = ImGui::GetColorU32(tone_colour(context.theme, toast.tone));
    list.AddRect({left, top}, {left + width, bottom}, packed(context.theme.border), 5 * context.scale);
    list.AddRectFilled({left, top}, {left + 0.3F * em, bottom}, colour, 5 * context.scale,
                       ImDrawFlags_RoundCornersLeft);
    ImGui::SetCursorPos({1.1F * em, (height - text) / 2});
    ImGui::PushTextWrapPos(1.1F * em + wrap + 1);
    ImGui::TextUnformatted(toast.text.c_str());
    ImGui::PopTextWrapPos();
    bool pressed = false;
    const float middle = (height - frame) / 2;
    if (toast.action) {
        ImGui::SetCursorPos({width - button - close, middle});
        pressed = ImGui::Button(label.c_str());
        remember_item(context.items, "remedy");
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(toast.action->help).c_str());
    }
    if (toast.closable) {
        ImGui::SetCursorPos({width - close - 0.2F * em, middle});
        ImGui::PushStyleColor(ImGuiCol_Button, {0, 0, 0, 0});
        if (ImGui::Button("×", {frame, frame})) this->close(toast);
        ImGui::PopStyleColor();
        remember_item(context.items, "message.close");
    }
    ImGui::End();
    return pressed;
}

} // namespace gaspard
