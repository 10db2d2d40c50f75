#include "gui/viewport/legend_control.hpp"

#include "core/base/number_text.hpp"
#include "core/tessellate/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui_stdlib.h>

namespace gaspard {

namespace {

constexpr const char *field_id = "##legend value", *legend_menu_id = "##legend menu";
constexpr float handle_size = 9; // pixels at scale 1

void set_range(Values& view, double low, double high) {
    if (!(low < high) || !std::isfinite(low) || !std::isfinite(high)) return;
    view.set("range", std::string("fixed"));
    view.set("low", low);
    view.set("high", high);
}

/// A number of few digits, as a hand cannot choose more.
double few_digits(double value, double span) {
    const double step = std::pow(10, std::floor(std::log10(span)) - 2);
    return step > 0 && std::isfinite(step) ? std::round(value / step) * step : value;
}

void draw_swatch(const ColourMap& map, float width, float height) {
    constexpr int pieces = 24;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    for (int i = 0; i < pieces; ++i) {
        const auto colour = colour_at(map, (i + 0.5) / pieces);
        const float left = at.x + width * static_cast<float>(i) / pieces,
                    right = at.x + width * static_cast<float>(i + 1) / pieces;
        ImGui::GetWindowDrawList()->AddRectFilled({left, at.y}, {right, at.y + height},
                                                  IM_COL32(colour[0], colour[1], colour[2], 255));
    }
    ImGui::Dummy({width, height});
}

} // namespace

double value_on_bar(const ColourRange& range, double place) {
    if (range.logarithmic) return range.low * std::pow(range.high / range.low, place);
    return range.low + place * (range.high - range.low);
}

LegendControl::Part LegendControl::part_at(const LegendPlaces& places, ImVec2 at, float scale) {
    const float reach = handle_size * scale;
    const auto near_end = [&](float y) {
        return std::abs(at.y - y) <= reach && at.x >= places.bar.min.x - reach / 2 &&
               at.x <= places.bar.max.x + 1.5F * reach;
    };
    if (near_end(places.bar.min.y)) return Part::high;
    if (near_end(places.bar.max.y)) return Part::low;
    if (places.high_value.contains(at)) return Part::high_value;
    if (places.low_value.contains(at)) return Part::low_value;
    return places.all.contains(at) ? Part::rest : Part::none;
}

/// A handle stays at its end of the bar, which shows the range that is being dragged.
void LegendControl::drag(Values& view, const LegendPlaces& places) {
    const ImGuiIO& io = ImGui::GetIO();
    const double height = std::max(1.0, static_cast<double>(places.bar.height()));
    const double moved = static_cast<double>(io.MouseClickedPos[0].y - io.MousePos.y) / height;
    if (moved == 0) return;
    double low = before_.low, high = before_.high;
    constexpr double least = 0.01; // of the range is left
    if (held_ == Part::high)
        high = value_on_bar(before_, std::max(1 + moved, least));
    else
        low = value_on_bar(before_, std::min(moved, 1 - least));
    double& dragged = held_ == Part::high ? high : low;
    dragged = few_digits(dragged, before_.logarithmic ? dragged : before_.high - before_.low);
    if (before_.logarithmic && !(low > 0)) return;
    set_range(view, low, high);
}

bool LegendControl::interact(Values& view, const Colouring& colouring, const LegendPlaces& places,
                             float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool ranges = colouring.range.low < colouring.range.high;
    const Part under = ImGui::IsItemHovered() ? part_at(places, io.MousePos, scale) : Part::none;
    if (ImGui::IsItemActivated()) {
        held_ = Part::none;
        for (const int button : {0, 1})
            if (ImGui::IsMouseDown(button)) held_ = part_at(places, io.MouseClickedPos[button], scale);
        before_ = colouring.range;
    }
    const bool number = under == Part::low_value || under == Part::high_value;
    if (under != Part::none && ImGui::IsMouseDoubleClicked(0)) {
        if (number) {
            typed_ = under, opens_field_ = true;
            text_ = format_number(under == Part::low_value ? colouring.range.low : colouring.range.high);
        } else {
            view.set("range", std::string("automatic"));
            held_ = Part::rest; // what follows is no drag
        }
    }
    if (held_ == Part::none) return false;
    const bool is_handle = held_ == Part::low || held_ == Part::high;
    if (is_handle && ranges && ImGui::IsMouseDown(0)) drag(view, places);
    if (ImGui::IsItemDeactivated()) {
        if (ImGui::IsMouseReleased(1)) opens_menu_ = true;
        held_ = Part::none;
    }
    return true;
}

/// Two triangles that point at the ends of the bar.
void LegendControl::draw(Values& view, const Colouring& colouring, const LegendPlaces& places,
                         const FrameContext& context) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Part under =
        ImGui::IsItemHovered() ? part_at(places, ImGui::GetIO().MousePos, context.scale) : Part::none;
    const float size = handle_size * context.scale;
    const auto remember = [&](const char* key, ScreenRect r) {
        context.items[key] = {r.min.x, r.min.y, r.max.x, r.max.y};
    };
    for (const Part end : {Part::low, Part::high}) {
        const float y = end == Part::high ? places.bar.min.y : places.bar.max.y, x = places.bar.max.x;
        const bool lit = held_ == end || (held_ == Part::none && under == end);
        const ImVec2 tip{x - 0.9F * size, y}, above{x + 0.2F * size, y - 0.6F * size},
            below{x + 0.2F * size, y + 0.6F * size}; // on the bar, beside the numbers
        list.AddTriangleFilled(tip, above, below, packed(context.theme.accent, lit ? 1.0F : 0.9F));
        list.AddTriangle(tip, above, below, packed(context.theme.background), context.scale);
        remember(end == Part::high ? "legend.high" : "legend.low",
                 {{x - 0.8F * size, y - 0.6F * size}, {x + 0.2F * size, y + 0.6F * size}});
    }
    remember("legend", places.all);
    remember("legend.low.value", places.low_value);
    remember("legend.high.value", places.high_value);
    if (held_ == Part::low || held_ == Part::high || under == Part::low || under == Part::high)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    else if (under == Part::low_value || under == Part::high_value)
        ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    if (under != Part::none && held_ == Part::none && !ImGui::IsPopupOpen(legend_menu_id))
        ImGui::SetTooltip("%s", under == Part::low_value || under == Part::high_value
                                    ? "Double-click to type a value."
                                    : "Drag the ends of the bar to set the range; double-click to show all "
                                      "values.\nRight-click for colour maps and scales.");
    draw_field(view, colouring, places, context);
    draw_menu(view, colouring, context);
}

void LegendControl::draw_field(Values& view, const Colouring& colouring, const LegendPlaces& places,
                               const FrameContext& context) {
    const bool begins = std::exchange(opens_field_, false);
    if (begins) ImGui::OpenPopup(field_id);
    const ScreenRect& at = typed_ == Part::high_value ? places.high_value : places.low_value;
    ImGui::SetNextWindowPos({at.max.x, at.min.y}, ImGuiCond_Appearing, {1, 0.2F});
    if (!ImGui::BeginPopup(field_id, ImGuiWindowFlags_NoMove)) return;
    if (begins) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(8 * ImGui::GetFontSize());
    const bool entered = ImGui::InputText(
        "##value", &text_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    remember_item(context.items, "legend.value");
    if (std::exchange(refused_, false)) ImGui::SetKeyboardFocusHere(-1); // to be corrected
    const auto value = parse_number(text_);
    const bool high = typed_ == Part::high_value;
    const double other = high ? colouring.range.low : colouring.range.high;
    const bool fits =
        value && (high ? *value > other : *value < other) && (*value > 0 || !colouring.range.logarithmic);
    if (!fits)
        ImGui::TextColored(to_imgui(context.theme.warning), "%s",
                           !value                                         ? "a number"
                           : colouring.range.logarithmic && !(*value > 0) ? "above 0 on a log scale"
                           : high                                         ? "above the low end"
                                                                          : "below the high end");
    refused_ = entered && !fits;
    if (entered && fits) {
        set_range(view, high ? other : *value, high ? *value : other);
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void LegendControl::draw_menu(Values& view, const Colouring& colouring, const FrameContext& context) {
    if (std::exchange(opens_menu_, false)) ImGui::OpenPopup(legend_menu_id);
    if (!ImGui::BeginPopup(legend_menu_id)) return;
    const auto entry = [&](const std::string& label, const std::string& key, bool checked) {
        const bool chosen = ImGui::MenuItem(label.c_str(), nullptr, checked);
        remember_item(context.items, "legend.menu." + key);
        return chosen;
    };
    const float em = ImGui::GetFontSize();
    if (entry("automatic", "automatic", view.text("color_map") == "automatic"))
        view.set("color_map", std::string("automatic"));
    for (const ColourMap& map : colour_maps()) {
        draw_swatch(map, 6 * em, em);
        ImGui::SameLine();
        const std::string name(map.name);
        if (entry(name, name, view.text("color_map") == map.name)) view.set("color_map", name);
    }
    ImGui::Separator();
    const bool automatic = view.text("range") == "automatic";
    if (entry("All values", "all", automatic)) {
        if (automatic)
            set_range(view, colouring.range.low, colouring.range.high);
        else
            view.set("range", std::string("automatic"));
    }
    if (entry("Log scale", "log", view.boolean("log"))) view.set("log", !view.boolean("log"));
    ImGui::Separator();
    if (entry("Histogram", "histogram", view.boolean("histogram")))
        view.set("histogram", !view.boolean("histogram"));
    for (const char* counts : {"square-root", "linear", "logarithmic"})
        if (entry(std::string("Counts: ") + counts, counts, view.text("histogram_counts") == counts))
            view.set("histogram_counts", std::string(counts));
    ImGui::EndPopup();
}

} // namespace gaspard
