#include "gui/plot/plot_widget.hpp"

#include "core/tessellate/ticks.hpp"
#include "gui/base/plot_text.hpp"
#include "gui/plot/plot_legend.hpp"
#include "gui/plot/plot_read_out.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <string>

namespace gaspard {

namespace {

constexpr double wheel_step = 1.2; // per notch
constexpr float click_slack = 6;   // how far a mouse may move during a click, in pixels of scale 1

/// A knob on the axis below the line of the mark, and its value beside the upper end.
void draw_handle(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, const MarkView& mark,
                 const Theme& theme, float scale) {
    const ScreenRect& area = frame.area;
    const auto x = static_cast<float>(frame.pixel_x(mark.x));
    if (!(x >= area.min.x && x <= area.max.x)) return;
    list.AddCircleFilled({x, area.max.y}, 5 * scale, packed(theme.accent));
    if (area.height() < 4 * ImGui::GetFontSize()) return; // the curves need it all
    const std::string value = plot.x.before + short_number(mark.x, 4);
    const float pad = 4 * scale;
    const ImVec2 size{text_size(value).x + 2 * pad, ImGui::GetFontSize() + pad};
    const float left = x + size.x + pad <= area.max.x ? x + pad : x - pad - size.x;
    list.AddRectFilled({left, area.min.y}, {left + size.x, area.min.y + size.y}, packed(theme.panel, 0.88F),
                       4 * scale);
    write_text(list, {left + pad, area.min.y + pad / 2}, theme.text, value);
}

void draw_marks(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, const Theme& theme,
                float scale) {
    float last = -FLT_MAX;
    for (const MarkView& mark : plot.marks) {
        const float x = std::round(static_cast<float>(frame.pixel_x(mark.x)));
        if (!(x >= frame.area.min.x && x <= frame.area.max.x) || std::abs(x - last) < 3 * scale) continue;
        last = x;
        if (mark.handle) {
            list.AddLine({x, frame.area.min.y}, {x, frame.area.max.y}, packed(theme.accent), 1.5F * scale);
            continue;
        }
        const ImU32 colour = packed(curve_colour(theme, mark.colour), 0.55F);
        const float dash = 4 * scale;
        for (float y = frame.area.min.y; y < frame.area.max.y; y += 2 * dash)
            list.AddRectFilled({x, y},
                               {x + std::max(1.0F, std::round(scale)), std::min(y + dash, frame.area.max.y)},
                               colour);
    }
}

/// Dashed, each with its label above the left end, which curves that fall to it leave free.
void draw_levels(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, const Theme& theme,
                 float scale) {
    const ScreenRect& area = frame.area;
    for (const LevelView& level : plot.levels) {
        const float y = std::round(static_cast<float>(frame.pixel_y(level.y)));
        if (!(y >= area.min.y && y <= area.max.y)) continue;
        const float dash = 5 * scale, thick = std::max(1.0F, std::round(scale));
        for (float x = area.min.x; x < area.max.x; x += 1.7F * dash)
            list.AddRectFilled({x, y}, {std::min(x + dash, area.max.x), y + thick}, packed(theme.good, 0.8F));
        const ImVec2 size = text_size(level.label);
        const float above = y - size.y - scale >= area.min.y ? y - size.y - scale : y + 2 * scale;
        if (size.x + 4 * scale < area.width() && area.height() > 3 * size.y)
            write_text(list, {area.min.x + 4 * scale, above}, theme.good, level.label);
    }
}

/// Which axes the mouse changes at a position.
struct Steered {
    bool x = false, y = false;
    bool any() const { return x || y; }
};

Steered steered_at(const PlotFrame& frame, ImVec2 place) {
    const ScreenRect& area = frame.area;
    const bool beside = place.x < area.min.x, below = place.y >= area.max.y;
    if (area.contains(place)) return {true, true};
    if (below && !beside && place.x < area.max.x) return {true, false};
    if (beside && !below && place.y >= area.min.y) return {false, true};
    return {};
}

/// Moves ranges, within limits that `home` sets.
class Steering {
  public:
    Steering(const PlotView& plot, const PlotFrame& frame, PlotZoom& zoom)
        : plot_(plot), frame_(frame), zoom_(zoom) {}

    void wheel(ImVec2 pointer, float turns, Steered which) {
        const double factor = std::pow(wheel_step, -static_cast<double>(turns));
        if (which.x) set_x(scaled(frame_.x_range, frame_.position_x(static_cast<double>(pointer.x)), factor));
        if (which.y) set_y(scaled(frame_.y_range, frame_.position_y(static_cast<double>(pointer.y)), factor));
    }
    void pan(ImVec2 by, Steered which) {
        const auto moved = [](AxisRange range, double fraction) {
            return AxisRange{range.low - fraction * range.span(), range.high - fraction * range.span()};
        };
        const double right = frame_.x.reversed ? -1 : 1, up = frame_.y.reversed ? -1 : 1;
        if (which.x) {
            const AxisRange to =
                moved(frame_.x_range, right * static_cast<double>(by.x / frame_.area.width()));
            set_x(begins_below_zero(to) ? AxisRange{0, to.span()} : to);
        }
        if (which.y) set_y(moved(frame_.y_range, -up * static_cast<double>(by.y / frame_.area.height())));
    }
    void show(ScreenRect rect) {
        const auto range = [](double one, double other) {
            return AxisRange{std::min(one, other), std::max(one, other)};
        };
        set_x(range(frame_.position_x(static_cast<double>(rect.min.x)),
                    frame_.position_x(static_cast<double>(rect.max.x))));
        set_y(range(frame_.position_y(static_cast<double>(rect.max.y)),
                    frame_.position_y(static_cast<double>(rect.min.y))));
    }
    void reset(Steered which) {
        if (which.x) zoom_.x.reset();
        if (which.y) zoom_.y.reset();
    }

  private:
    /// Of counts there are none.
    bool begins_below_zero(AxisRange x) const { return frame_.x.whole && !frame_.x.logarithmic && x.low < 0; }
    void set_x(AxisRange range) {
        const AxisRange home = home_range(plot_, false);
        range = limited(range, home, frame_.x.logarithmic);
        if (begins_below_zero(range)) range = range.high > 0 ? AxisRange{0, range.high} : home;
        zoom_.x = range;
    }
    void set_y(AxisRange range) { zoom_.y = limited(range, home_range(plot_, true), frame_.y.logarithmic); }

    const PlotView& plot_;
    const PlotFrame& frame_;
    PlotZoom& zoom_;
};

/// What the right button has drawn so far, within the area; nothing while that is still a click.
std::optional<ScreenRect> dragged_rectangle(const PlotFrame& frame, float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 from = io.MouseClickedPos[1], to = io.MousePos;
    if (!frame.area.contains(from) || !ImGui::IsMousePosValid(&to)) return std::nullopt;
    ScreenRect rect{{std::min(from.x, to.x), std::min(from.y, to.y)},
                    {std::max(from.x, to.x), std::max(from.y, to.y)}};
    rect.min = {std::max(rect.min.x, frame.area.min.x), std::max(rect.min.y, frame.area.min.y)};
    rect.max = {std::min(rect.max.x, frame.area.max.x), std::min(rect.max.y, frame.area.max.y)};
    if (std::min(rect.width(), rect.height()) < click_slack * scale) return std::nullopt;
    return rect;
}

/// The value of x at the pointer.
double value_at_pointer(const PlotFrame& frame) {
    const float pixel = std::clamp(ImGui::GetIO().MousePos.x, frame.area.min.x, frame.area.max.x);
    return from_axis(frame.x, frame.position_x(static_cast<double>(pixel)));
}

/// The value of x to which the left button has been dragged, from a place within the area.
std::optional<double> swept_value(const PlotFrame& frame, float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDragging(0, click_slack * scale)) return std::nullopt;
    if (!frame.area.contains(io.MouseClickedPos[0]) || !ImGui::IsMousePosValid()) return std::nullopt;
    return value_at_pointer(frame);
}

/// Whether a mark with a handle is near a position.
bool on_handle(const PlotView& plot, const PlotFrame& frame, ImVec2 at, float scale) {
    if (!frame.area.contains(at)) return false;
    return std::any_of(plot.marks.begin(), plot.marks.end(), [&](const MarkView& mark) {
        const double away = std::abs(frame.pixel_x(mark.x) - static_cast<double>(at.x));
        return mark.handle && away < static_cast<double>(click_slack * scale);
    });
}

/// Whether the left button holds a handle; the plot remembers where the button was pressed.
bool holds_handle(const PlotView& plot, const PlotFrame& frame, float scale) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID held = ImGui::GetID("held handle"); // one plot per window has one
    if (ImGui::IsItemActivated())
        storage.SetBool(held,
                        ImGui::IsMouseDown(0) && on_handle(plot, frame, ImGui::GetIO().MousePos, scale));
    return ImGui::IsItemActive() && storage.GetBool(held);
}

/// The value of x that was clicked, or to which a handle is dragged.
std::optional<double> pointed_value(const PlotFrame& frame, float scale, bool holds) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsMousePosValid()) return std::nullopt;
    if (holds && io.MouseDelta.x != 0) return value_at_pointer(frame);
    const ImVec2 from = io.MouseClickedPos[0];
    const bool clicked = ImGui::IsItemDeactivated() && io.MouseClickedLastCount[0] == 1 &&
                         ImGui::IsMouseReleased(0) && frame.area.contains(from) &&
                         std::hypot(io.MousePos.x - from.x, io.MousePos.y - from.y) < click_slack * scale;
    return clicked ? std::optional(value_at_pointer(frame)) : std::nullopt;
}

/// True when a menu is asked for.
bool steer(const PlotView& plot, const PlotFrame& frame, PlotZoom& zoom, float scale, bool sweeps) {
    const ImGuiIO& io = ImGui::GetIO();
    Steering steering(plot, frame, zoom);
    if (ImGui::IsItemHovered()) {
        Steered which = steered_at(frame, io.MousePos);
        if (io.MouseWheel != 0 && which.any()) {
            if (io.KeyShift) which = {true, false};
            if (io.KeyCtrl) which = {false, true};
            steering.wheel(io.MousePos, io.MouseWheel, which);
        }
        if (ImGui::IsMouseDoubleClicked(0)) {
            steering.reset(steered_at(frame, io.MousePos));
            return false;
        }
    }
    const bool pans = !sweeps || !frame.area.contains(io.MouseClickedPos[0]);
    if (pans && ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 0) &&
        (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
        steering.pan(io.MouseDelta, steered_at(frame, io.MouseClickedPos[0]));
    if (!ImGui::IsItemDeactivated() || !ImGui::IsMouseReleased(1)) return false;
    if (const auto rect = dragged_rectangle(frame, scale)) {
        steering.show(*rect);
        return false;
    }
    const ImVec2 from = io.MouseClickedPos[1];
    return std::hypot(io.MousePos.x - from.x, io.MousePos.y - from.y) < click_slack * scale;
}

/// Returns what the legend says of the name at the pointer.
std::string draw(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, ScreenRect rect,
                 const Theme& theme, float scale, ImVec2 pointer) {
    draw_frame(list, plot, frame, rect, theme, scale);
    draw_marks(list, plot, frame, theme, scale);
    draw_levels(list, plot, frame, theme, scale);
    const std::vector<PixelPath> paths = pixel_paths(plot, frame);
    draw_curves(list, plot, paths, frame, theme, scale);
    std::string name = draw_legend(list, plot, paths, frame, theme, scale, pointer);
    for (const MarkView& mark : plot.marks)
        if (mark.handle) draw_handle(list, plot, frame, mark, theme, scale);
    return name;
}

} // namespace

void draw_plot(ImDrawList& list, const Plot& plot, ScreenRect rect, const Theme& theme, float scale) {
    draw_plot(list, view_of(plot), rect, {}, theme, scale);
}

void draw_plot(ImDrawList& list, const PlotView& plot, ScreenRect rect, const PlotZoom& zoom,
               const Theme& theme, float scale) {
    const PlotFrame frame = make_frame(plot, rect, zoom, scale);
    if (frame.drawable()) draw(list, plot, frame, rect, theme, scale, {-FLT_MAX, -FLT_MAX});
}

bool plot_widget(const char* id, const PlotView& plot, ImVec2 size, PlotZoom& zoom, const Theme& theme,
                 float scale, PlotPointing* pointing) {
    size = {std::max(size.x, 1.0F), std::max(size.y, 1.0F)};
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const ScreenRect rect{low, {low.x + size.x, low.y + size.y}};
    PlotFrame frame = make_frame(plot, rect, zoom, scale);
    if (!frame.drawable()) return false; // too small
    const PlotZoom before = zoom;
    bool takes_drags = false;
    if (pointing && pointing->use == PlotPointing::Use::sweep) {
        takes_drags = true;
        pointing->x = swept_value(frame, scale);
        if (ImGui::IsItemHovered() && frame.area.contains(ImGui::GetIO().MousePos))
            ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    } else if (pointing) {
        takes_drags = holds_handle(plot, frame, scale);
        pointing->x = pointed_value(frame, scale, takes_drags);
        pointing->double_clicked = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
        if (takes_drags || (ImGui::IsItemHovered() && on_handle(plot, frame, ImGui::GetIO().MousePos, scale)))
            ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    const bool menu = steer(plot, frame, zoom, scale, takes_drags);
    if (zoom != before) frame = make_frame(plot, rect, zoom, scale);
    if (!frame.drawable()) return menu;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const std::string name = draw(list, plot, frame, rect, theme, scale, pointer);
    const bool pointed = ImGui::IsItemHovered() && !ImGui::IsItemActive() && frame.area.contains(pointer);
    if (pointed && !name.empty())
        ImGui::SetTooltip("%s", name.c_str());
    else if (pointed)
        draw_read_out(list, plot, frame, pointer, theme, scale);
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(1))
        if (const auto rectangle = dragged_rectangle(frame, scale)) {
            list.AddRectFilled(rectangle->min, rectangle->max, packed(theme.accent, 0.18F));
            list.AddRect(rectangle->min, rectangle->max, packed(theme.accent), 0, 0, scale);
        }
    return menu;
}

} // namespace gaspard
