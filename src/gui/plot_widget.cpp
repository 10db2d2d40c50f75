#include "gui/plot_widget.hpp"

#include "gui/plot_curves.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

constexpr double wheel_step = 1.2; // per notch
constexpr float click_slack = 6;   // how far a mouse may move during a click, in pixels of scale 1

ImVec2 text_size(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size());
}

void write(ImDrawList& list, ImVec2 at, Colour colour, std::string_view text) {
    list.AddText(at, packed(colour), text.data(), text.data() + text.size());
}

void draw_marks(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, const Theme& theme,
                float scale) {
    float last = -FLT_MAX;
    for (const MarkView& mark : plot.marks) {
        const float x = std::round(static_cast<float>(frame.pixel_x(mark.x)));
        if (!(x >= frame.area.min.x && x <= frame.area.max.x) || std::abs(x - last) < 3 * scale) continue;
        last = x;
        const ImU32 colour = packed(curve_colour(theme, mark.colour), 0.55F);
        const float dash = 4 * scale;
        for (float y = frame.area.min.y; y < frame.area.max.y; y += 2 * dash)
            list.AddRectFilled({x, y},
                               {x + std::max(1.0F, std::round(scale)), std::min(y + dash, frame.area.max.y)},
                               colour);
    }
}

void draw_legend(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, const Theme& theme,
                 float scale) {
    std::vector<const CurveView*> entries;
    const CurveView* before = nullptr;
    for (const CurveView& curve : plot.curves) {
        const bool repeated = before && !curve.part.empty() && before->label == curve.label;
        if (!curve.label.empty() && !repeated) entries.push_back(&curve);
        before = &curve;
    }
    if (entries.size() < 2) return;
    const float line = ImGui::GetFontSize() * 1.25F, pad = 7 * scale, sample = 16 * scale;
    const float room = 0.7F * frame.area.width() - sample - 3 * pad;
    const auto fitting = static_cast<std::size_t>(std::max(0.0F, (0.7F * frame.area.height() - pad) / line));
    if (fitting == 0 || room < 3 * line) return;
    std::vector<std::string> texts;
    for (const CurveView* curve : entries) texts.push_back(shortened(curve->label, room));
    if (texts.size() > fitting) {
        texts.resize(fitting);
        texts.back() = "and " + std::to_string(entries.size() - fitting + 1) + " more";
    }
    float width = 0;
    for (const std::string& text : texts) width = std::max(width, text_size(text).x);
    const ImVec2 high = {frame.area.max.x - pad, frame.area.min.y + pad};
    const ImVec2 low = {high.x - width - sample - 3 * pad, high.y};
    const float bottom = high.y + line * static_cast<float>(texts.size()) + pad;
    list.AddRectFilled(low, {high.x, bottom}, packed(theme.panel, 0.88F), 4 * scale);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const float top = low.y + pad / 2 + line * static_cast<float>(i), middle = top + line / 2;
        if (entries.size() == texts.size() || i + 1 < texts.size())
            list.AddLine({low.x + pad, middle}, {low.x + pad + sample, middle},
                         packed(curve_colour(theme, entries[i]->colour)), 2 * scale);
        write(list, {low.x + 2 * pad + sample, middle - ImGui::GetFontSize() / 2}, theme.text, texts[i]);
    }
}

/// A line of the read-out: with a colour where it speaks of a curve.
struct ReadOutLine {
    std::string name, value;
    std::optional<std::size_t> colour;
};

std::string abscissa_text(const PlotView& plot, double value) {
    std::string text = plot.x.label.empty() ? "x" : plot.x.label;
    return text.append(" ").append(short_number(value, 6));
}

std::vector<ReadOutLine> read_out(const PlotView& plot, const PlotFrame& frame,
                                  const std::vector<PointedAt>& points, double x, float pixel_x, float scale,
                                  float room) {
    constexpr std::size_t most = 12;
    std::vector<ReadOutLine> lines = {{abscissa_text(plot, x), {}, {}}};
    for (const PointedAt& point : points) {
        if (lines.size() > most) break;
        const CurveView& curve = plot.curves[point.curve];
        std::string name = shortened(curve.label, room);
        if (!curve.part.empty()) name.append(" ").append(curve.part);
        std::string value = short_number(curve.y[point.index], 5);
        if (std::abs(frame.pixel_x(curve.x[point.index]) - static_cast<double>(pixel_x)) > 2)
            value.append(" at ").append(short_number(curve.x[point.index], 6));
        lines.push_back({std::move(name), std::move(value), curve.colour});
    }
    for (const MarkView& mark : plot.marks)
        if (std::abs(frame.pixel_x(mark.x) - static_cast<double>(pixel_x)) <= static_cast<double>(5 * scale))
            lines.push_back({shortened(mark.label, 1.5F * room), {}, {}});
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
        write(list, {left, top}, theme.faint_text, lines[i].name);
        write(list, {high.x - pad - text_size(lines[i].value).x, top}, theme.text, lines[i].value);
    }
}

/// A hair line at the nearest points, a disc on each, and a box with their values.
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
        list.AddCircleFilled(at, 3.5F * scale, packed(curve_colour(theme, curve.colour)), 20);
        list.AddCircle(at, 4.5F * scale, packed(theme.panel), 20, scale);
    }
    list.PopClipRect();
    const auto lines = read_out(plot, frame, points, x, pixel_x, scale, 0.5F * frame.area.width());
    draw_box(list, lines, {pixel_x, pointer.y}, frame.area, theme, scale);
}

/// Which axes the mouse steers at a place.
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

/// Moves ranges about; `home` keeps them within reason.
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
        if (which.x) set_x(moved(frame_.x_range, static_cast<double>(by.x / frame_.area.width())));
        if (which.y) set_y(moved(frame_.y_range, static_cast<double>(-by.y / frame_.area.height())));
    }
    void show(ScreenRect rect) {
        set_x({frame_.position_x(static_cast<double>(rect.min.x)),
               frame_.position_x(static_cast<double>(rect.max.x))});
        set_y({frame_.position_y(static_cast<double>(rect.max.y)),
               frame_.position_y(static_cast<double>(rect.min.y))});
    }
    void reset(Steered which) {
        if (which.x) zoom_.x.reset();
        if (which.y) zoom_.y.reset();
    }

  private:
    void set_x(AxisRange range) { zoom_.x = limited(range, home_range(plot_, false), frame_.x.logarithmic); }
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

/// True when a menu is asked for.
bool steer(const PlotView& plot, const PlotFrame& frame, PlotZoom& zoom, float scale) {
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
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 0) &&
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

std::size_t nearest_index(const CurveView& curve, const PlotFrame& frame, double pixel_x) {
    const auto distance = [&](std::size_t i) { return std::abs(frame.pixel_x(curve.x[i]) - pixel_x); };
    const auto drawn = [&](std::size_t i) {
        return !std::isnan(frame.pixel_x(curve.x[i])) && !std::isnan(frame.pixel_y(curve.y[i]));
    };
    const std::size_t count = curve.x.size();
    std::size_t begin = 0, end = count;
    if (curve.extremes) { // the x are in order: a few to the left and to the right will do
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

std::optional<AxisRange> asked_range(const Axis& axis) {
    if (!axis.low || !axis.high) return std::nullopt;
    const AxisRange range{to_axis(axis, *axis.low), to_axis(axis, *axis.high)};
    return range.low < range.high ? std::optional(range) : std::nullopt;
}

void draw(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, ScreenRect rect, const Theme& theme,
          float scale) {
    draw_frame(list, plot, frame, rect, theme, scale);
    draw_marks(list, plot, frame, theme, scale);
    draw_curves(list, plot, frame, theme, scale);
    draw_legend(list, plot, frame, theme, scale);
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
        const bool first = i == 0 && pointer < frame.pixel_x(curve.x[i]) - reach;
        const bool last = i + 1 == curve.x.size() && pointer > frame.pixel_x(curve.x[i]) + reach;
        if (!first && !last) found.push_back({c, i});
    }
    return found;
}

std::string shortened(std::string_view text, float width) {
    if (text_size(text).x <= width) return std::string(text);
    // Of UTF-8 only whole letters.
    const auto starts_letter = [&](std::size_t i) {
        return i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xc0U) != 0x80U;
    };
    for (std::size_t kept = text.size(); kept > 0; --kept) {
        const std::size_t head = kept * 2 / 5, tail = text.size() - (kept - head);
        if (!starts_letter(head) || !starts_letter(tail)) continue;
        std::string result = std::string(text.substr(0, head)) + "…" + std::string(text.substr(tail));
        if (text_size(result).x <= width) return result;
    }
    return "…";
}

void draw_plot(ImDrawList& list, const Plot& plot, ScreenRect rect, const Theme& theme, float scale) {
    const PlotView view = view_of(plot);
    const PlotFrame frame = make_frame(view, rect, {asked_range(plot.x), asked_range(plot.y)}, scale);
    if (frame.drawable()) draw(list, view, frame, rect, theme, scale);
}

bool plot_widget(const char* id, const PlotView& plot, ImVec2 size, PlotZoom& zoom, const Theme& theme,
                 float scale) {
    size = {std::max(size.x, 1.0F), std::max(size.y, 1.0F)};
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const ScreenRect rect{low, {low.x + size.x, low.y + size.y}};
    PlotFrame frame = make_frame(plot, rect, zoom, scale);
    if (!frame.drawable()) return false; // no room for anything
    const PlotZoom before = zoom;
    const bool menu = steer(plot, frame, zoom, scale);
    if (zoom != before) frame = make_frame(plot, rect, zoom, scale);
    if (!frame.drawable()) return menu;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw(list, plot, frame, rect, theme, scale);
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive() && frame.area.contains(pointer))
        draw_read_out(list, plot, frame, pointer, theme, scale);
    if (ImGui::IsItemActive() && ImGui::IsMouseDown(1))
        if (const auto rectangle = dragged_rectangle(frame, scale)) {
            list.AddRectFilled(rectangle->min, rectangle->max, packed(theme.accent, 0.18F));
            list.AddRect(rectangle->min, rectangle->max, packed(theme.accent), 0, 0, scale);
        }
    return menu;
}

} // namespace gaspard
