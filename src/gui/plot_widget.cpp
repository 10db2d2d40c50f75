#include "gui/plot_widget.hpp"

#include "core/tessellate/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace gaspard {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Where a value lies on its axis; NaN where the axis cannot show it.
double on_axis(const Axis& axis, double value) {
    if (!std::isfinite(value)) return nothing;
    if (!axis.logarithmic) return value;
    return value > 0 ? std::log10(value) : nothing;
}

/// From values to pixels within the area of the curves.
struct Mapping {
    const Plot& plot;
    ScreenRect area;
    AxisRange x, y;

    float pixel_x(double value) const {
        return area.min.x +
               static_cast<float>((on_axis(plot.x, value) - x.low) / (x.high - x.low)) * area.width();
    }
    float pixel_y(double value) const {
        return area.max.y -
               static_cast<float>((on_axis(plot.y, value) - y.low) / (y.high - y.low)) * area.height();
    }
    /// False where there is nothing to see.
    bool point(const Curve& curve, std::size_t i, ImVec2& pixel) const {
        pixel = {pixel_x(curve.x[i]), pixel_y(curve.y[i])};
        return std::isfinite(pixel.x) && std::isfinite(pixel.y);
    }
};

std::vector<Tick> axis_ticks(const Axis& axis, AxisRange range, int count) {
    const auto value = [](double exponent) { return std::pow(10.0, std::clamp(exponent, -307.0, 308.0)); };
    if (axis.logarithmic) return log_ticks(value(range.low), value(range.high), count);
    return linear_ticks(range.low, range.high, count);
}

/// Ticks of both axes and what their labels need.
struct Frame {
    std::vector<Tick> x, y;
    AxisRange x_range, y_range;
    ScreenRect area; ///< of the curves
};

float label_width(const std::vector<Tick>& ticks) {
    float width = 0;
    for (const Tick& tick : ticks) width = std::max(width, ImGui::CalcTextSize(tick.label.c_str()).x);
    return width;
}

Frame make_frame(const Plot& plot, ScreenRect rect, float scale) {
    const float line = ImGui::GetFontSize(), gap = 5 * scale;
    Frame frame;
    frame.area = rect;
    if (!plot.title.empty()) frame.area.min.y += line + gap;
    if (!plot.y.label.empty()) frame.area.min.y += line + gap;
    frame.area.min.y += line / 2; // half of the uppermost label
    frame.area.max.y -= line + gap;
    if (!plot.x.label.empty()) frame.area.max.y -= line + gap / 2;
    frame.x_range = axis_range(plot.x, plot, false);
    frame.y_range = axis_range(plot.y, plot, true);
    const float spacing = plot.y.logarithmic ? 2.0F : 2.6F; // in lines of text
    frame.y = axis_ticks(plot.y, frame.y_range, static_cast<int>(frame.area.height() / (spacing * line)));
    frame.area.min.x += label_width(frame.y) + gap;
    frame.x = axis_ticks(plot.x, frame.x_range, static_cast<int>(frame.area.width() / (5 * line)));
    const float last_label = frame.x.empty() ? 0 : ImGui::CalcTextSize(frame.x.back().label.c_str()).x;
    frame.area.max.x -= std::max(last_label / 2, gap);
    return frame;
}

void draw_frame(ImDrawList& list, const Frame& frame, const Mapping& map, const Theme& theme, float scale) {
    const ScreenRect& area = frame.area;
    const float gap = 5 * scale, thin = std::max(1.0F, std::round(scale));
    const auto grid = [&](bool major) { return packed(theme.grid, major ? 1.0F : 0.4F); };
    // Minor lines help only where decades are wide.
    const auto shown = [&](const Tick& tick, AxisRange range, float length) {
        return tick.major || length / static_cast<float>(range.high - range.low) > 45 * scale;
    };
    list.AddRectFilled(area.min, area.max, packed(theme.frame, 0.45F));
    for (const Tick& tick : frame.x) {
        const float x = std::round(map.pixel_x(tick.value));
        if (!(x >= area.min.x - 1 && x <= area.max.x + 1)) continue;
        if (!shown(tick, map.x, area.width())) continue;
        list.AddRectFilled({x, area.min.y}, {x + thin, area.max.y}, grid(tick.major));
        const float width = ImGui::CalcTextSize(tick.label.c_str()).x;
        list.AddText({x - width / 2, area.max.y + gap}, packed(theme.faint_text), tick.label.c_str());
    }
    for (const Tick& tick : frame.y) {
        const float y = std::round(map.pixel_y(tick.value));
        if (!(y >= area.min.y - 1 && y <= area.max.y + 1)) continue;
        if (!shown(tick, map.y, area.height())) continue;
        list.AddRectFilled({area.min.x, y}, {area.max.x, y + thin}, grid(tick.major));
        const ImVec2 size = ImGui::CalcTextSize(tick.label.c_str());
        list.AddText({area.min.x - gap - size.x, y - size.y / 2}, packed(theme.faint_text),
                     tick.label.c_str());
    }
}

void draw_labels(ImDrawList& list, const Plot& plot, const Frame& frame, ScreenRect rect, const Theme& theme,
                 float scale) {
    const float line = ImGui::GetFontSize(), gap = 5 * scale;
    ImVec2 at = rect.min;
    if (!plot.title.empty()) {
        const float width = ImGui::CalcTextSize(plot.title.c_str()).x;
        list.AddText({(frame.area.min.x + frame.area.max.x - width) / 2, at.y}, packed(theme.text),
                     plot.title.c_str());
        at.y += line + gap;
    }
    list.AddText({std::max(rect.min.x, frame.area.min.x - label_width(frame.y) - gap), at.y},
                 packed(theme.faint_text), plot.y.label.c_str());
    const float width = ImGui::CalcTextSize(plot.x.label.c_str()).x;
    list.AddText({(frame.area.min.x + frame.area.max.x - width) / 2, rect.max.y - line},
                 packed(theme.faint_text), plot.x.label.c_str());
}

/// One unbroken piece of a curve, in parts that stay far below what ImGui can index.
class Stroke {
  public:
    Stroke(ImDrawList& list, ImU32 colour, float width) : list_(list), colour_(colour), width_(width) {}
    void add(ImVec2 point) {
        const ImVec2 last = points_.empty() ? ImVec2{-1e9F, -1e9F} : points_.back();
        if (std::hypot(point.x - last.x, point.y - last.y) < 0.5F) return;
        points_.push_back(point);
        if (points_.size() < 4000) return;
        flush();
        points_.push_back(point);
    }
    void end() {
        if (points_.size() == 1) list_.AddCircleFilled(points_.front(), 1.5F * width_, colour_, 16);
        flush();
    }

  private:
    void flush() {
        if (points_.size() > 1)
            list_.AddPolyline(points_.data(), static_cast<int>(points_.size()), colour_, 0, width_);
        points_.clear();
    }

    ImDrawList& list_;
    ImU32 colour_;
    float width_;
    std::vector<ImVec2> points_;
};

const Colour& curve_colour(const Theme& theme, std::size_t i) {
    return theme.curves[i % theme.curves.size()];
}

void draw_curves(ImDrawList& list, const Plot& plot, const Mapping& map, const Theme& theme, float scale) {
    for (std::size_t c = 0; c < plot.curves.size(); ++c) {
        const Curve& curve = plot.curves[c];
        const ImU32 colour = packed(curve_colour(theme, c));
        Stroke stroke(list, colour, 1.75F * scale);
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            ImVec2 pixel;
            if (!map.point(curve, i, pixel)) {
                stroke.end();
                continue;
            }
            stroke.add(pixel);
            if (curve.markers) list.AddCircleFilled(pixel, 3.5F * scale, colour, 24);
        }
        stroke.end();
    }
}

void draw_legend(ImDrawList& list, const Plot& plot, const Frame& frame, const Theme& theme, float scale) {
    if (plot.curves.size() < 2) return;
    const float line = ImGui::GetFontSize() * 1.25F, pad = 7 * scale, sample = 16 * scale;
    float width = 0;
    for (const Curve& curve : plot.curves)
        width = std::max(width, ImGui::CalcTextSize(curve.label.c_str()).x);
    const ImVec2 high = {frame.area.max.x - pad, frame.area.min.y + pad};
    const ImVec2 low = {high.x - width - sample - 3 * pad, high.y};
    const float bottom = high.y + line * static_cast<float>(plot.curves.size()) + pad;
    list.AddRectFilled(low, {high.x, bottom}, packed(theme.panel, 0.88F), 4 * scale);
    for (std::size_t c = 0; c < plot.curves.size(); ++c) {
        const float top = low.y + pad / 2 + line * static_cast<float>(c), middle = top + line / 2;
        list.AddLine({low.x + pad, middle}, {low.x + pad + sample, middle}, packed(curve_colour(theme, c)),
                     2 * scale);
        list.AddText({low.x + 2 * pad + sample, middle - ImGui::GetFontSize() / 2}, packed(theme.text),
                     plot.curves[c].label.c_str());
    }
}

std::optional<NearestPoint> nearest(const Mapping& map, ImVec2 position, float reach) {
    std::optional<NearestPoint> found;
    float best = reach;
    for (std::size_t c = 0; c < map.plot.curves.size(); ++c)
        for (std::size_t i = 0; i < map.plot.curves[c].x.size(); ++i) {
            ImVec2 pixel;
            if (!map.point(map.plot.curves[c], i, pixel)) continue;
            const float distance = std::hypot(pixel.x - position.x, pixel.y - position.y);
            if (distance > best) continue;
            best = distance;
            found = NearestPoint{c, i};
        }
    return found;
}

/// The nearest point's values in a box beside it.
void draw_read_out(ImDrawList& list, const Plot& plot, const Mapping& map, NearestPoint which,
                   const Theme& theme, float scale) {
    const Curve& curve = plot.curves[which.curve];
    ImVec2 at;
    map.point(curve, which.index, at);
    const auto name = [](const Axis& axis, const char* otherwise) {
        return axis.label.empty() ? std::string(otherwise) : axis.label;
    };
    std::string text = curve.label.empty() ? "" : curve.label + "\n";
    text += name(plot.x, "x") + "  " + short_number(curve.x[which.index], 6) + "\n";
    text += name(plot.y, "y") + "  " + short_number(curve.y[which.index], 5);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = 7 * scale, away = 10 * scale;
    ImVec2 corner = {at.x + away, at.y - away - size.y - 2 * pad};
    if (corner.x + size.x + 2 * pad > map.area.max.x) corner.x = at.x - away - size.x - 2 * pad;
    corner.x = std::max(corner.x, map.area.min.x);
    corner.y = std::max(corner.y, map.area.min.y);
    list.AddCircleFilled(at, 4 * scale, packed(curve_colour(theme, which.curve)), 24);
    list.AddCircle(at, 6 * scale, packed(theme.text), 24, scale);
    const ImVec2 opposite = {corner.x + size.x + 2 * pad, corner.y + size.y + 2 * pad};
    list.AddRectFilled(corner, opposite, packed(theme.panel, 0.94F), 4 * scale);
    list.AddRect(corner, opposite, packed(theme.border), 4 * scale);
    list.AddText({corner.x + pad, corner.y + pad}, packed(theme.text), text.c_str());
}

} // namespace

AxisRange axis_range(const Axis& axis, const Plot& plot, bool vertical) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    bool markers = false;
    for (const Curve& curve : plot.curves) {
        markers = markers || curve.markers;
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            // A point that the other axis cannot show asks for no room on this one.
            const double other = vertical ? on_axis(plot.x, curve.x[i]) : on_axis(plot.y, curve.y[i]);
            const double value = on_axis(axis, vertical ? curve.y[i] : curve.x[i]);
            if (std::isnan(value) || std::isnan(other)) continue;
            low = std::min(low, value), high = std::max(high, value);
        }
    }
    if (low > high) return axis.logarithmic ? AxisRange{-1, 0} : AxisRange{0, 1};
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low <= 1e-12 * size || high == low) {
        const double half = axis.logarithmic ? 0.5 : size > 0 ? 0.05 * size : 0.5;
        return {low - half, high + half};
    }
    const double room = vertical || markers ? 0.05 * (high - low) : 0;
    return {low - room, high + room};
}

std::optional<NearestPoint> nearest_point(const Plot& plot, ScreenRect area, ImVec2 position, float reach) {
    return nearest({plot, area, axis_range(plot.x, plot, false), axis_range(plot.y, plot, true)}, position,
                   reach);
}

void draw_plot(ImDrawList& list, const Plot& plot, ScreenRect rect, const Theme& theme, float scale,
               const ImVec2* pointer) {
    const Frame frame = make_frame(plot, rect, scale);
    if (frame.area.width() < 8 || frame.area.height() < 8) return; // no room for anything
    const Mapping map{plot, frame.area, frame.x_range, frame.y_range};
    draw_frame(list, frame, map, theme, scale);
    draw_labels(list, plot, frame, rect, theme, scale);
    list.PushClipRect({frame.area.min.x - 4 * scale, frame.area.min.y - 4 * scale},
                      {frame.area.max.x + 4 * scale, frame.area.max.y + 4 * scale}, true);
    draw_curves(list, plot, map, theme, scale);
    list.PopClipRect();
    draw_legend(list, plot, frame, theme, scale);
    if (pointer == nullptr) return;
    if (const auto which = nearest(map, *pointer, 40 * scale))
        draw_read_out(list, plot, map, *which, theme, scale);
}

void plot_widget(const char* id, const Plot& plot, ImVec2 size, const Theme& theme, float scale) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, size);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    draw_plot(*ImGui::GetWindowDrawList(), plot, {low, {low.x + size.x, low.y + size.y}}, theme, scale,
              ImGui::IsItemHovered() ? &mouse : nullptr);
}

} // namespace gaspard
