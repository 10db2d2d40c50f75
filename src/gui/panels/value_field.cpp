#include "gui/panels/value_field.hpp"

#include "gui/base/plot_text.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <imgui_internal.h> // the owner of the wheel

namespace gaspard {

namespace {

constexpr float drag_begins = 3; // pixels of the theme; a shorter one is a click
constexpr double finely = 0.1;

/// The panel does not scroll while the pointer is over the item.
void keep_the_wheel() {
#if IMGUI_VERSION_NUM >= 18920
    ImGui::SetItemKeyOwner(ImGuiKey_MouseWheelY);
#else
    ImGui::SetItemUsingMouseWheel();
#endif
}

/// A click soon after a drag from the same place is not the second of two.
bool double_clicked() {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID dragged = ImGui::GetID("last drag");
    const auto now = static_cast<float>(ImGui::GetTime());
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0)) storage.SetFloat(dragged, now);
    return ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) &&
           now - storage.GetFloat(dragged, -1) > ImGui::GetIO().MouseDoubleClickTime;
}

/// The position when the drag began is kept with the item.
std::optional<double> dragged_position(const ValueField& field, float width, float em) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("position");
    if (ImGui::IsItemActivated()) storage.SetFloat(id, static_cast<float>(*field.position));
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDragging(0, drag_begins * em / 15)) return std::nullopt;
    const double factor = ImGui::GetIO().KeyShift ? finely : 1;
    const auto by = static_cast<double>(ImGui::GetIO().MouseDelta.x / std::max(width, 1.0F)) * factor;
    // The motion before it was clear that this is a drag counts as well.
    const ImVec2 all = ImGui::GetMouseDragDelta(0, 0);
    const bool begins = std::abs(all.x - ImGui::GetIO().MouseDelta.x) < drag_begins * em / 15;
    const double start = static_cast<double>(storage.GetFloat(id, static_cast<float>(*field.position)));
    const double moved =
        begins ? start + static_cast<double>(all.x / std::max(width, 1.0F)) * factor : start + by;
    storage.SetFloat(id, static_cast<float>(moved)); // beyond the ends, so that the way back is as long
    return std::clamp(moved, 0.0, 1.0);
}

int steps_asked(bool wheel) {
    int steps = 0;
    if (wheel && ImGui::GetIO().MouseWheel != 0) steps = ImGui::GetIO().MouseWheel > 0 ? 1 : -1;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) ++steps;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) --steps;
    return ImGui::GetIO().KeyShift ? 10 * steps : steps;
}

void draw_field(const ValueField& field, ImVec2 low, ImVec2 high, bool lit, const Theme& theme) {
    const float em = ImGui::GetFontSize(), rounding = ImGui::GetStyle().FrameRounding;
    const float pad = 0.55F * em, top = low.y + ImGui::GetStyle().FramePadding.y;
    const bool disabled = ImGui::GetStyle().Alpha < 1;
    const Colour colour = disabled ? theme.faint_text : theme.text;
    const float strength = disabled ? 0.2F : lit ? 0.55F : 0.42F;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, packed(theme.frame), rounding);
    if (field.position) {
        const float fill = static_cast<float>(std::clamp(*field.position, 0.0, 1.0)) * (high.x - low.x);
        list.PushClipRect(low, {low.x + std::max(fill, 2.0F), high.y}, true);
        list.AddRectFilled(low, high, packed(theme.accent, strength), rounding);
        list.PopClipRect();
    }
    if (field.focused) list.AddRect(low, high, packed(theme.accent), rounding);
    const float value = text_size(field.value).x;
    const float label = high.x - low.x - 3 * pad - value;
    const std::string text = shortened(field.label, std::max(label, 2 * em));
    write_text(list, {low.x + pad, top}, colour, text);
    const float after = text_size(text).x + 0.5F * em;
    if (!field.symbol.empty() && after + text_size(field.symbol).x < label)
        write_text(list, {low.x + pad + after, top}, theme.faint_text, field.symbol);
    write_text(list, {high.x - pad - value, top}, colour, field.value);
}

} // namespace

ValueFieldAnswer draw_value_field(const char* id, const ValueField& field, float width, const Theme& theme) {
    const float em = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + width, low.y + ImGui::GetFrameHeight()};
    const bool takes_keys = field.focused && field.keys, takes_wheel = takes_keys && field.wheel;
    ValueFieldAnswer answer;
    ImGui::InvisibleButton(id, {std::max(width, 1.0F), ImGui::GetFrameHeight()});
    const bool hovered = ImGui::IsItemHovered();
    if (field.position) answer.position = dragged_position(field, width, em);
    answer.clicked = ImGui::IsItemActivated();
    answer.type =
        (answer.clicked && ImGui::GetIO().KeyCtrl) || double_clicked() ||
        (takes_keys && !ImGui::IsAnyItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)));
    answer.hovered = hovered;
    if (takes_wheel && hovered) keep_the_wheel();
    if (takes_keys && !ImGui::GetIO().WantTextInput) answer.steps = steps_asked(takes_wheel && hovered);
    if (hovered && field.position) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    draw_field(field, low, high, hovered || ImGui::IsItemActive(), theme);
    return answer;
}

} // namespace gaspard
