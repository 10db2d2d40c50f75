#include "gui/plot/plot_read_out.hpp"

#include "gui/base/plot_text.hpp"
#include "gui/plot/plot_curves.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace gaspard {

namespace {

std::size_t nearest_index(const CurveView& curve, const PlotFrame& frame, double pixel_x) {
    const auto distance = [&](std::size_t i) { return std::abs(frame.pixel_x(curve.x[i]) - pixel_x); };
    const auto drawn = [&](std::size_t i) {
        return !std::isnan(frame.pixel_x(curve.x[i])) && !std::isnan(frame.pixel_y(curve.y[i]));
    };
    const std::size_t count = curve.x.size();
    std::size_t begin = 0, end = count;
    if (curve.extremes) { // the x are in order: a few to the left and to the right suffice
        constexpr std::size_t far = 32;
        const double x = from_axis(frame.x, frame.position_x(pixel_x));
        const auto at =
            static_cast<std::size_t>(std::lower_bound(curve.x.begin(), curve.x.end(), x) - curve.x.begin());
        begin = at > far ? at - far : 0;
        end = std::min(count, at + far);
    }
    std::size_t best = count;
    for (std::size_t i = begin; i < end; ++i)
        if (drawn(i) && (best == count || distance(i) < distance(best))) best = i;
    return best;
}

/// A line of the read-out, with a colour if it belongs to a curve.
struct ReadOutLine {
    std::string name, value;
    std::optional<std::size_t> colour;
};

/// With as many digits as tell the pixels apart.
std::string abscissa_number(const PlotView& plot, const PlotFrame& frame, double value) {
    const AxisRange& range = frame.x_range;
    const double size = std::max(std::abs(range.low), std::abs(range.high)), ratio = size / range.span();
    const int digits = plot.x.logarithmic ? 6 : 6 + static_cast<int>(std::log10(std::max(ratio, 1.0)));
    return plot.x.before + short_number(value, std::min(digits, 17));
}

std::string abscissa_text(const PlotView& plot, const PlotFrame& frame, double value) {
    std::string text = plot.x.label.empty() ? "x" : plot.x.label;
    return text.append(" ").append(abscissa_number(plot, frame, value));
}

std::vector<ReadOutLine> read_out(const PlotView& plot, const PlotFrame& frame,
                                  const std::vector<PointedAt>& points, double x, float pixel_x, float scale,
                                  float available) {
    constexpr std::size_t most = 12;
    std::vector<ReadOutLine> lines = {{abscissa_text(plot, frame, x), {}, {}}};
    for (const PointedAt& point : points) {
        if (lines.size() > most) break;
        const CurveView& curve = plot.curves[point.curve];
        std::string name = shortened(curve.label.empty() ? std::string(curve.name) : curve.label, available);
        if (!curve.part.empty()) name.append(" ").append(curve.part);
        std::string value = short_number(curve.y[point.index], 5);
        if (std::abs(frame.pixel_x(curve.x[point.index]) - static_cast<double>(pixel_x)) > 2)
            value.append(" at ").append(abscissa_number(plot, frame, curve.x[point.index]));
        lines.push_back({std::move(name), std::move(value), curve.colour});
    }
    for (const MarkView& mark : plot.marks)
        if (std::abs(frame.pixel_x(mark.x) - static_cast<double>(pixel_x)) <= static_cast<double>(5 * scale))
            lines.push_back({shortened(mark.label, 1.5F * available), {}, {}});
    return lines;
}

void draw_box(ImDrawList& list, const std::vector<ReadOutLine>& lines, ImVec2 beside, const ScreenRect& area,
              const Theme& theme, float scale) {
    const float line = ImGui::GetFontSize() * 1.2F, pad = 7 * scale, away = 12 * scale, sample = 10 * scale;
    float names = 0, values = 0;
    for (const ReadOutLine& one : lines) {
        const float indent = one.colour ? sample + pad : 0;
        (one.value.empty() ? values : names) =
            std::max(one.value.empty() ? values : names, text_size(one.name).x + indent);
    }
    float width = values;
    for (const ReadOutLine& one : lines)
        if (!one.value.empty()) width = std::max(width, names + pad + text_size(one.value).x);
    const ImVec2 size{width + 2 * pad, line * static_cast<float>(lines.size()) + 2 * pad};
    ImVec2 low{beside.x + away, beside.y - away - size.y};
    if (low.x + size.x > area.max.x) low.x = beside.x - away - size.x;
    low.x = std::max(low.x, area.min.x);
    low.y = std::clamp(low.y, area.min.y, std::max(area.min.y, area.max.y - size.y));
    const ImVec2 high{low.x + size.x, low.y + size.y};
    list.AddRectFilled(low, high, packed(theme.panel, 0.94F), 4 * scale);
    list.AddRect(low, high, packed(theme.border), 4 * scale);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const float top = low.y + pad + line * static_cast<float>(i);
        float left = low.x + pad;
        if (lines[i].colour) {
            const float middle = top + ImGui::GetFontSize() / 2;
            list.AddRectFilled({left, middle - sample / 2}, {left + sample, middle + sample / 2},
                               packed(curve_colour(theme, *lines[i].colour)), 2 * scale);
            left += sample + pad;
        }
        write_text(list, {left, top}, theme.faint_text, lines[i].name);
        write_text(list, {high.x - pad - text_size(lines[i].value).x, top}, theme.text, lines[i].value);
    }
}

} // namespace

std::vector<PointedAt> points_at(const PlotView& plot, const PlotFrame& frame, float pixel_x) {
    const auto reach = static_cast<double>(ImGui::GetFontSize());
    const auto pointer = static_cast<double>(pixel_x);
    std::vector<PointedAt> found;
    for (std::size_t c = 0; c < plot.curves.size(); ++c) {
        const CurveView& curve = plot.curves[c];
        const std::size_t i = nearest_index(curve, frame, pointer);
        if (i == curve.x.size()) continue;
        // Between the curve's points any distance is fine, beyond its ends only a short one.
        const double there = frame.pixel_x(curve.x[i]);
        const double to_higher = (pointer - there) * (plot.x.reversed ? -1 : 1);
        const bool before = curve.x[i] <= curve.x.front() && to_higher < -reach;
        const bool beyond = curve.x[i] >= curve.x.back() && to_higher > reach;
        if (!before && !beyond) found.push_back({c, i});
    }
    return found;
}

void draw_read_out(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, ImVec2 pointer,
                   const Theme& theme, float scale) {
    const auto points = points_at(plot, frame, pointer.x);
    if (points.empty()) return;
    const auto distance = [&](const PointedAt& p) {
        return std::abs(frame.pixel_x(plot.curves[p.curve].x[p.index]) - static_cast<double>(pointer.x));
    };
    const PointedAt nearest =
        *std::min_element(points.begin(), points.end(),
                          [&](const PointedAt& a, const PointedAt& b) { return distance(a) < distance(b); });
    const double x = plot.curves[nearest.curve].x[nearest.index];
    const auto pixel_x = static_cast<float>(frame.pixel_x(x));
    list.PushClipRect(frame.area.min, frame.area.max, true);
    list.AddLine({pixel_x, frame.area.min.y}, {pixel_x, frame.area.max.y}, packed(theme.text, 0.45F), scale);
    for (const PointedAt& point : points) {
        const CurveView& curve = plot.curves[point.curve];
        const ImVec2 at{static_cast<float>(frame.pixel_x(curve.x[point.index])),
                        static_cast<float>(frame.pixel_y(curve.y[point.index]))};
        list.AddCircleFilled(at, 3.5F * scale, packed(curve_colour(theme, curve.colour), curve.opacity), 20);
        list.AddCircle(at, 4.5F * scale, packed(theme.panel), 20, scale);
    }
    list.PopClipRect();
    const auto lines = read_out(plot, frame, points, x, pixel_x, scale, 0.4F * frame.area.width());
    draw_box(list, lines, {pixel_x, pointer.y}, frame.area, theme, scale);
}

} // namespace gaspard
