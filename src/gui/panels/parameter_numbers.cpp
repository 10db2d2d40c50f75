// The numbers of a parameter panel: fields to drag, and text fields in their place while a number is typed.
#include "gui/base/plot_text.hpp"
#include "gui/base/value_text.hpp"
#include "gui/panels/panel_columns.hpp"
#include "gui/panels/parameter_panel.hpp"
#include "gui/panels/slider_scale.hpp"
#include "gui/panels/value_field.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <optional>

namespace gaspard {

// A check box for "auto" after the field, which is empty while it is ticked. Unticked, it restores the number
// that was there before, or with which the scenario was opened.
void ParameterPanel::draw_number_or_auto(const PanelContext& context, const ParameterRow& row,
                                         const std::string& key, const Values* opened, Values& values) {
    const PanelColumns c = columns();
    const float em = ImGui::GetFontSize();
    const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + text_size("auto").x;
    const float width = std::max(4 * em, c.end - c.field - box - 0.4F * em);
    const std::optional<double> number = values.real_or_auto(row.key);
    if (number) {
        before_auto_[key] = *number;
        double shown = *number;
        if (draw_number(context, row, key, shown, width)) values.set(row.key, shown);
    } else {
        draw_value_field("##field", {row.label, row.symbol, ""}, width, context.theme);
        remember_item(context.items, key);
    }
    ImGui::SameLine(0, 0.4F * em);
    bool automatic = !number;
    const bool switched = ImGui::Checkbox("auto", &automatic);
    remember_item(context.items, key + ".auto");
    if (!switched) return;
    if (number) return values.set(row.key, std::string("auto"));
    const std::optional<double> at_first = opened ? opened->real_or_auto(row.key) : std::nullopt;
    double restored = at_first.value_or(rounded(row, slider_ends(row), value_at(row, slider_ends(row), 0.5)));
    if (const auto before = before_auto_.find(key); before != before_auto_.end()) restored = before->second;
    values.set(row.key, std::clamp(restored, row.minimum, row.maximum));
}

/// The ends of a row's slider; a value beyond them widens it for good.
SliderRange ParameterPanel::ends_of(const ParameterRow& row, const std::string& key, double value) {
    const SliderRange said = slider_ends(row);
    if (!row.slider) return said;
    Widened& known = widened_[key];
    if (known.said != said) known = {said, said};
    return known.ends = widened(known.ends, value);
}

/// One step of wheel or keys: a hundredth of the range, or one at least of whole numbers.
static double stepped(const ParameterRow& row, SliderRange ends, double value, int steps) {
    const double position = position_of(row, ends, value);
    double next = rounded(row, ends, value_at(row, ends, std::clamp(position + 0.01 * steps, 0.0, 1.0)));
    if (row.kind == ParameterKind::integer && std::abs(next - value) < std::abs(steps)) next = value + steps;
    return next;
}

void ParameterPanel::begin_frame(bool takes_keys) {
    monitors_.begin_frame();
    takes_keys_ = takes_keys;
    if (ImGui::GetIO().MouseWheel != 0 && !pointed_) scrolled_ = ImGui::GetTime();
}

/// Of the field that was clicked last: the wheel steps it while the pointer is on it, but not if it came
/// there by scrolling, since the same turn of the wheel goes on.
void ParameterPanel::follow_pointer(bool clicked, bool hovered) {
    constexpr double burst = 0.5; // seconds between two steps of one turn of the wheel
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (clicked)
        pointed_ = true;
    else if (!hovered)
        pointed_ = false;
    else if ((moved.x != 0 || moved.y != 0) && ImGui::GetTime() - scrolled_ > burst)
        pointed_ = true;
}

bool ParameterPanel::draw_number(const PanelContext& context, const ParameterRow& row, const std::string& key,
                                 double& value, float width) {
    if (typing_ == key || focus_.expects(key)) return draw_typed(context, row, key, value, width);
    const SliderRange ends = ends_of(row, key, value);
    const bool bounded = std::isfinite(ends.minimum) && std::isfinite(ends.maximum);
    ValueField field{.label = row.label,
                     .symbol = row.symbol,
                     .value = number_text(row, value) + unit_text(row),
                     .focused = focused_ == key,
                     .keys = takes_keys_,
                     .wheel = pointed_};
    if (bounded) field.position = position_of(row, ends, value);
    const ValueFieldAnswer answer = draw_value_field("##field", field, width, context.theme);
    remember_item(context.items, key);
    if (answer.clicked) focused_ = key;
    if (focused_ == key) follow_pointer(answer.clicked, answer.hovered);
    if (answer.type) {
        focus_.want(key);
        return false;
    }
    double next = value;
    if (answer.position) next = rounded(row, ends, value_at(row, ends, *answer.position));
    if (answer.steps != 0 && bounded) next = stepped(row, ends, value, answer.steps);
    next = std::clamp(next, row.minimum, row.maximum);
    const bool changed = (answer.position || answer.steps != 0) && next != value;
    value = changed ? next : value;
    return changed;
}

/// In the place of the field, until the keyboard leaves it.
bool ParameterPanel::draw_typed(const PanelContext& context, const ParameterRow& row, const std::string& key,
                                double& value, float width) {
    const bool typing = typing_ == key;
    double shown = typing ? typed_value_ : value;
    const bool outside = !(shown >= row.minimum && shown <= row.maximum);
    if (focus_.wanted(key) && !ImGui::IsMouseDown(0)) focus_.ask();
    if (outside) ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(context.theme.bad));
    ImGui::SetNextItemWidth(width);
    const bool edited =
        ImGui::InputScalar("##typed", ImGuiDataType_Double, &shown, nullptr, nullptr, "%.6g",
                           ImGuiInputTextFlags_CharsScientific | ImGuiInputTextFlags_AutoSelectAll);
    if (outside) ImGui::PopStyleColor();
    focus_.note(key, ImGui::IsItemActive());
    remember_item(context.items, key + ".input");
    if (ImGui::IsItemActive() && !typing) typing_ = key, typed_value_ = value;
    if (edited) typed_value_ = shown;
    if (typing_ != key || ImGui::IsItemActive()) return false;
    typing_.clear();
    if (!std::isfinite(typed_value_)) return false;
    const double taken = std::clamp(typed_value_, row.minimum, row.maximum);
    const bool changed = taken != value;
    value = taken;
    return changed;
}

} // namespace gaspard
