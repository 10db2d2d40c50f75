#include "gui/plot/plot_axes.hpp"

#include "gui/base/plot_text.hpp"
#include "gui/plot/plot_legend.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace gaspard {

namespace {

constexpr float row_height = 9; // at scale 1

struct Hull {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double position) {
        if (std::isnan(position)) return;
        low = std::min(low, position), high = std::max(high, position);
    }
};

/// For a curve whose extremes are known; no search is necessary.
void add_indexed(const CurveView& curve, const PlotView& plot, bool vertical, Hull& hull) {
    const Axis& axis = vertical ? plot.y : plot.x;
    if (vertical) {
        const Extent& all = curve.extremes->all();
        hull.add(to_axis(axis, axis.logarithmic ? all.min_positive : all.min));
        hull.add(to_axis(axis, all.max));
        return;
    }
    const auto first =
        axis.logarithmic ? std::upper_bound(curve.x.begin(), curve.x.end(), 0.0) : curve.x.begin();
    if (first == curve.x.end()) return;
    hull.add(to_axis(axis, *first));
    hull.add(to_axis(axis, curve.x.back()));
}

void add_points(const CurveView& curve, const PlotView& plot, bool vertical, Hull& hull) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        // Ignore points that the other axis cannot show.
        const double x = to_axis(plot.x, curve.x[i]), y = to_axis(plot.y, curve.y[i]);
        if (!std::isnan(x) && !std::isnan(y)) hull.add(vertical ? y : x);
    }
}

float label_width(const std::vector<Tick>& ticks) {
    float width = 0;
    for (const Tick& tick : ticks) width = std::max(width, ImGui::CalcTextSize(tick.label.c_str()).x);
    return width;
}

/// Minor lines help only where decades are wide.
bool is_shown(const Tick& tick, AxisRange range, float length, float scale) {
    return tick.major || length / static_cast<float>(range.span()) > 45 * scale;
}

/// A stroke in every column of pixels that has a place.
void draw_rows(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, const Theme& theme,
               float scale) {
    const float thin = std::max(1.0F, std::round(scale));
    for (std::size_t i = 0; i < plot.rows.size(); ++i) {
        const float top = frame.area.max.y + (row_height * static_cast<float>(i) + 2) * scale;
        const ImU32 colour = packed(theme.curves[plot.rows[i].colour % theme.curves.size()]);
        for (const float x : columns_of(plot.rows[i].x, frame))
            list.AddRectFilled({x, top}, {x + thin, top + (row_height - 2) * scale}, colour);
    }
}

/// In as many lines as it needs.
ImVec2 title_size(std::string_view title, const ScreenRect& rect) {
    return ImGui::CalcTextSize(title.data(), title.data() + title.size(), false, rect.width());
}

/// Whether one line above the curves names both axes, so that more of a low plot is left for them; still
/// lower ones would have labels of ticks that overlap.
bool has_one_label(const PlotView& plot, ScreenRect rect) {
    const float lines = rect.height() / ImGui::GetFontSize();
    return !plot.x.label.empty() && !plot.y.label.empty() && lines >= 5 && lines < 8;
}

void draw_labels(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, ScreenRect rect,
                 const Theme& theme, float scale) {
    const float line = ImGui::GetFontSize(), gap = 5 * scale;
    const float middle = (frame.area.min.x + frame.area.max.x) / 2;
    float top = rect.min.y;
    const auto write = [&list](ImVec2 at, Colour colour, std::string_view text) {
        list.AddText(at, packed(colour), text.data(), text.data() + text.size());
    };
    if (!plot.title.empty()) {
        const ImVec2 size = title_size(plot.title, rect);
        const float left =
            std::clamp(middle - size.x / 2, rect.min.x, std::max(rect.min.x, rect.max.x - size.x));
        list.AddText(ImGui::GetFont(), line, {left, top}, packed(theme.text), plot.title.data(),
                     plot.title.data() + plot.title.size(), rect.width());
        top += size.y + gap;
    }
    const float ticks = plot.left > 0 ? plot.left : label_width(frame.y_ticks) + gap;
    const float left = std::max(rect.min.x, frame.area.min.x - ticks);
    if (has_one_label(plot, rect))
        return write({left, top}, theme.faint_text, plot.y.label + " over " + plot.x.label);
    write({left, top}, theme.faint_text, plot.y.label);
    write({middle - text_size(plot.x.label).x / 2, rect.max.y - line}, theme.faint_text, plot.x.label);
}

} // namespace

std::vector<float> columns_of(std::span<const double> x, const PlotFrame& frame) {
    std::vector<float> columns;
    const auto add = [&](double value) {
        const auto at = static_cast<float>(std::round(frame.pixel_x(value)));
        if (at >= frame.area.min.x - 1 && at <= frame.area.max.x + 1 &&
            (columns.empty() || columns.back() != at))
            columns.push_back(at);
    };
    if (!std::is_sorted(x.begin(), x.end())) {
        for (const double value : x) add(value);
        return columns;
    }
    // From the first one of a column of pixels to the first one beyond it.
    const auto pixels = static_cast<double>(std::max(1.0F, frame.area.width()));
    const double low = from_axis(frame.x, frame.x_range.low);
    for (auto at = std::lower_bound(x.begin(), x.end(), low); at != x.end();) {
        add(*at);
        const double position = to_axis(frame.x, *at);
        if (position > frame.x_range.high) break;
        const double step = std::isnan(position) ? 0 : 0.5 * frame.x_range.span() / pixels;
        at = step > 0 ? std::upper_bound(at + 1, x.end(), from_axis(frame.x, position + step)) : at + 1;
    }
    return columns;
}

AxisRange home_range(const PlotView& plot, bool vertical) {
    const Axis& axis = vertical ? plot.y : plot.x;
    Hull hull;
    bool markers = false;
    for (const CurveView& curve : plot.curves) {
        if (curve.opacity < 1) continue;
        markers = markers || curve.markers;
        (curve.extremes ? add_indexed : add_points)(curve, plot, vertical, hull);
    }
    for (const LevelView& level : plot.levels)
        if (vertical) hull.add(to_axis(axis, level.y));
    if (!vertical && axis.whole && !axis.logarithmic && hull.low < hull.high) hull.add(0); // iterations
    const AxisRange all = range_around(hull.low, hull.high, axis.logarithmic, vertical || markers);
    return asked_range(axis, range_of_counts(axis, all));
}

AxisRange limited(AxisRange range, AxisRange home, bool logarithmic) {
    const double low = logarithmic ? lowest_decade : -1e300, high = logarithmic ? highest_decade : 1e300;
    const double size = std::max({std::abs(range.low), std::abs(range.high), 1e-290});
    const double narrowest = std::max(5e-13 * size, 1e-15 * home.span()); // rounding is far below
    const double widest = std::max(20 * home.span(), narrowest);
    const double middle = std::clamp(range.low / 2 + range.high / 2, low, high);
    const double span = std::clamp(range.span(), narrowest, widest);
    if (span != range.span()) range = {middle - span / 2, middle + span / 2};
    const bool sound = std::isfinite(range.low) && std::isfinite(range.high) && range.low < range.high &&
                       range.low >= low && range.high <= high;
    return sound ? range : home;
}

AxisRange scaled(AxisRange range, double about, double factor) {
    return {about + (range.low - about) * factor, about + (range.high - about) * factor};
}

double PlotFrame::pixel_of_x(double position) const {
    return static_cast<double>(area.min.x) +
           fraction_of(x, x_range, position) * static_cast<double>(area.width());
}

double PlotFrame::pixel_of_y(double position) const {
    return static_cast<double>(area.max.y) -
           fraction_of(y, y_range, position) * static_cast<double>(area.height());
}

double PlotFrame::position_x(double pixel) const {
    return position_at(x, x_range,
                       (pixel - static_cast<double>(area.min.x)) / static_cast<double>(area.width()));
}

double PlotFrame::position_y(double pixel) const {
    return position_at(y, y_range,
                       (static_cast<double>(area.max.y) - pixel) / static_cast<double>(area.height()));
}

PlotFrame make_frame(const PlotView& plot, ScreenRect rect, const PlotZoom& zoom, float scale) {
    const float line = ImGui::GetFontSize(), gap = 5 * scale;
    PlotFrame frame;
    frame.x = plot.x, frame.y = plot.y;
    frame.area = rect;
    if (!plot.title.empty()) frame.area.min.y += title_size(plot.title, rect).y + gap;
    if (!plot.y.label.empty()) frame.area.min.y += line + gap;
    if (const ImVec2 names = legend_strip(plot, frame.area, scale); names.y > 0)
        frame.legend_width = names.x, frame.area.min.y += names.y;
    frame.area.min.y += line / 2; // half of the uppermost label
    frame.area.max.y -= line + gap;
    if (!plot.x.label.empty() && !has_one_label(plot, rect)) frame.area.max.y -= line + gap / 2;
    if (!plot.rows.empty()) frame.strip = (row_height * static_cast<float>(plot.rows.size()) + 2) * scale;
    frame.area.max.y -= frame.strip;
    frame.x_range = zoom.x ? *zoom.x : home_range(plot, false);
    frame.y_range = zoom.y ? *zoom.y : home_range(plot, true);
    if (!frame.drawable()) return frame;
    const float spacing = plot.y.logarithmic ? 2.0F : 2.6F; // in lines of text
    const auto height = [line](const std::string&) { return static_cast<double>(line); };
    frame.y_ticks =
        fitting_ticks(plot.y, frame.y_range, static_cast<int>(frame.area.height() / (spacing * line)),
                      static_cast<double>(frame.area.height()), height);
    frame.area.min.x += std::max(label_width(frame.y_ticks) + gap, plot.left);
    frame.area.max.x -= plot.right;
    const auto width = [gap](const std::string& label) {
        return static_cast<double>(ImGui::CalcTextSize(label.c_str()).x + gap);
    };
    const auto fit = [&] {
        constexpr int fewest = 3; // else a narrow axis has one tick, which is no scale
        frame.x_ticks = fitting_ticks(plot.x, frame.x_range,
                                      std::max(fewest, static_cast<int>(frame.area.width() / (5 * line))),
                                      static_cast<double>(frame.area.width()), width);
    };
    fit();
    const std::vector<Tick>& ticks = frame.x_ticks;
    const float last =
        ticks.empty() ? 0 : text_size((plot.x.reversed ? ticks.front() : ticks.back()).label).x;
    frame.area.max.x += plot.right - std::max({last / 2, gap, plot.right});
    if (frame.drawable()) fit(); // on the width that is left
    return frame;
}

void draw_frame(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, ScreenRect rect,
                const Theme& theme, float scale) {
    const ScreenRect& area = frame.area;
    const float gap = 5 * scale, thin = std::max(1.0F, std::round(scale));
    const auto grid = [&](bool major) { return packed(theme.grid, major ? 1.0F : 0.4F); };
    list.AddRectFilled(area.min, area.max, packed(theme.frame, 0.45F));
    for (const Tick& tick : frame.x_ticks) {
        const float x = std::round(static_cast<float>(frame.pixel_x(tick.value)));
        if (!(x >= area.min.x - 1 && x <= area.max.x + 1)) continue;
        if (!is_shown(tick, frame.x_range, area.width(), scale)) continue;
        list.AddRectFilled({x, area.min.y}, {x + thin, area.max.y}, grid(tick.major));
        const float width = ImGui::CalcTextSize(tick.label.c_str()).x;
        list.AddText({x - width / 2, area.max.y + frame.strip + gap}, packed(theme.faint_text),
                     tick.label.c_str());
    }
    for (const Tick& tick : frame.y_ticks) {
        const float y = std::round(static_cast<float>(frame.pixel_y(tick.value)));
        if (!(y >= area.min.y - 1 && y <= area.max.y + 1)) continue;
        if (!is_shown(tick, frame.y_range, area.height(), scale)) continue;
        list.AddRectFilled({area.min.x, y}, {area.max.x, y + thin}, grid(tick.major));
        const ImVec2 size = ImGui::CalcTextSize(tick.label.c_str());
        list.AddText({area.min.x - gap - size.x, y - size.y / 2}, packed(theme.faint_text),
                     tick.label.c_str());
    }
    draw_rows(list, plot, frame, theme, scale);
    draw_labels(list, plot, frame, rect, theme, scale);
}

} // namespace gaspard
