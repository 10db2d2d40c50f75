#include "gui/plot/plot_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace gaspard {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t few = 4; // points that a column of pixels shows one by one

struct DPoint {
    double x = 0, y = 0;
};

/// The first of x[begin, end), which are in order, that is larger than `value`; `end` if there is none.
std::size_t first_above(std::span<const double> x, std::size_t begin, std::size_t end, double value) {
    const auto at = [&x](std::size_t i) { return x.begin() + static_cast<std::ptrdiff_t>(i); };
    return static_cast<std::size_t>(std::upper_bound(at(begin), at(end), value) - x.begin());
}

/// What is drawn of a curve, gathered from left to right.
class PathMaker {
  public:
    PathMaker(const CurveView& curve, const PlotFrame& frame)
        : curve_(curve), frame_(frame), bent_(curve.linear && (frame.x.logarithmic || frame.y.logarithmic)) {}

    void point(std::size_t i) {
        if (bent_ && i > 0) bends_before(i);
        add(frame_.pixel_x(curve_.x[i]), frame_.pixel_y(curve_.y[i]));
    }
    void points(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) point(i);
    }
    /// Many points that share a column of pixels: the lowest and the highest, the nearer one first.
    void column(std::size_t begin, std::size_t end) {
        const Extent extent = curve_.extremes->of(curve_.y, begin, end);
        double low = frame_.pixel_y(frame_.y.logarithmic ? extent.min_positive : extent.min);
        double high = frame_.pixel_y(extent.max);
        const double x = frame_.pixel_x(curve_.x[begin]);
        if (std::isnan(low) || std::isnan(high)) return add(x, nothing);
        const double before = path_.y.empty() ? nothing : path_.y.back();
        if (std::abs(high - before) < std::abs(low - before)) std::swap(low, high);
        add(x, low);
        if (high != low) add(x, high);
    }
    PixelPath take() { return std::move(path_); }

  private:
    void bends_before(std::size_t i) {
        constexpr double step = 4; // pixels
        const double x0 = curve_.x[i - 1], x1 = curve_.x[i], y0 = curve_.y[i - 1], y1 = curve_.y[i];
        const double per_pixel = frame_.x_range.span() / static_cast<double>(frame_.area.width());
        for (const double at : bends_between(frame_.x, frame_.x_range, x0, x1, step * per_pixel)) {
            path_.between.resize(path_.x.size());
            path_.between.push_back(1);
            add(frame_.pixel_of_x(at),
                frame_.pixel_y(value_between(from_axis(frame_.x, at), x0, y0, x1, y1)));
        }
    }
    void add(double x, double y) {
        path_.x.push_back(x);
        path_.y.push_back(std::isnan(x) ? nothing : y);
    }
    const CurveView& curve_;
    const PlotFrame& frame_;
    bool bent_; ///< a line between points is none on these axes
    PixelPath path_;
};

/// Cuts a line off at a box; false where nothing of it is left inside.
bool clip_line(DPoint& a, DPoint& b, DPoint low, DPoint high) {
    double from = 0, to = 1;
    const DPoint d{b.x - a.x, b.y - a.y};
    for (const auto& [step, available] :
         {std::pair{-d.x, a.x - low.x}, {d.x, high.x - a.x}, {-d.y, a.y - low.y}, {d.y, high.y - a.y}}) {
        if (step == 0 && available < 0) return false;
        if (step < 0) from = std::max(from, available / step);
        if (step > 0) to = std::min(to, available / step);
    }
    if (!(from <= to)) return false;
    const DPoint start = a;
    a = {start.x + from * d.x, start.y + from * d.y};
    b = {start.x + to * d.x, start.y + to * d.y};
    return true;
}

/// Draws connected lines, in parts that stay far below what ImGui can index, and cut off not far outside of
/// `area`: single precision would bend lines that end far away.
class Stroke {
  public:
    Stroke(ImDrawList& list, ScreenRect area, ImU32 colour, float width)
        : list_(list), low_{static_cast<double>(area.min.x) - 50, static_cast<double>(area.min.y) - 50},
          high_{static_cast<double>(area.max.x) + 50, static_cast<double>(area.max.y) + 50}, colour_(colour),
          width_(width) {}

    void add(DPoint point) {
        if (std::isnan(point.y)) return end();
        if (!begun_) {
            begun_ = true, single_ = true, last_ = point;
            return;
        }
        if (std::hypot(point.x - last_.x, point.y - last_.y) < 0.5) return;
        DPoint from = last_, to = point;
        last_ = point, single_ = false;
        if (!clip_line(from, to, low_, high_)) return flush();
        const ImVec2 start = to_screen(from);
        if (points_.empty() || points_.back().x != start.x || points_.back().y != start.y) {
            flush();
            points_.push_back(start);
        }
        if (points_.size() > 1 && turns_back(points_[points_.size() - 2], start, to_screen(to))) {
            flush();
            points_.push_back(start);
        }
        points_.push_back(to_screen(to));
        if (points_.size() < 4000) return;
        flush();
        points_.push_back(to_screen(to));
    }
    void end() {
        flush();
        const bool inside =
            last_.x >= low_.x && last_.x <= high_.x && last_.y >= low_.y && last_.y <= high_.y;
        if (begun_ && single_ && inside) list_.AddCircleFilled(to_screen(last_), 1.5F * width_, colour_, 16);
        begun_ = false;
    }

  private:
    /// Where ImGui's joint of the two segments would be thinner than the line.
    static bool turns_back(ImVec2 a, ImVec2 b, ImVec2 c) {
        return (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0;
    }
    static ImVec2 to_screen(DPoint p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }
    void flush() {
        if (points_.size() > 1)
            list_.AddPolyline(points_.data(), static_cast<int>(points_.size()), colour_, 0, width_);
        points_.clear();
    }

    ImDrawList& list_;
    DPoint low_, high_;
    ImU32 colour_;
    float width_;
    bool begun_ = false, single_ = false; ///< a piece has begun; it has one point so far
    DPoint last_;
    std::vector<ImVec2> points_;
};

/// Smaller ones where many are in sight, and none where they would run into a thick line.
float marker_radius(const PixelPath& path, ScreenRect area, float scale) {
    std::size_t seen = 0;
    for (std::size_t i = 0; i < path.x.size(); ++i) {
        const bool between = i < path.between.size() && path.between[i] != 0;
        const auto x = static_cast<float>(path.x[i]), y = static_cast<float>(path.y[i]);
        seen += !between && area.contains({x, y}) ? 1 : 0;
    }
    const float each = area.width() / (scale * static_cast<float>(std::max<std::size_t>(seen, 1)));
    if (each < 3) return 0;
    return std::clamp(0.35F * each, 1.8F, 3.5F) * scale;
}

void draw_curve(ImDrawList& list, const CurveView& curve, const PixelPath& path, ScreenRect area,
                ImU32 colour, float scale) {
    Stroke stroke(list, area, colour, (curve.behind ? 1.25F : 1.75F) * scale);
    const float radius = curve.markers ? marker_radius(path, area, scale) : 0;
    for (std::size_t i = 0; i < path.x.size(); ++i) {
        stroke.add({path.x[i], path.y[i]});
        const bool between = i < path.between.size() && path.between[i] != 0;
        if (radius == 0 || between || std::isnan(path.y[i])) continue;
        list.AddCircleFilled({static_cast<float>(path.x[i]), static_cast<float>(path.y[i])}, radius, colour,
                             24);
    }
    stroke.end();
}

} // namespace

PixelPath pixel_path(const CurveView& curve, const PlotFrame& frame) {
    PathMaker maker(curve, frame);
    const std::size_t count = curve.x.size();
    if (curve.extremes == nullptr) {
        maker.points(0, count);
        return maker.take();
    }
    const auto first_beyond = [&](std::size_t from, double position) { // in axis units
        return first_above(curve.x, from, count, from_axis(frame.x, position));
    };
    // One point more on either side, for the lines that lead out of the area.
    const std::size_t inside = first_beyond(0, frame.x_range.low);
    std::size_t i = inside > 0 ? inside - 1 : 0;
    const std::size_t end = std::min(count, first_beyond(i, frame.x_range.high) + 1);
    const auto columns = static_cast<std::size_t>(std::max(1.0F, frame.area.width()));
    if (end - i <= 2 * columns) {
        maker.points(i, end);
        return maker.take();
    }
    const std::size_t typical = (end - i) / columns;
    for (std::size_t column = 0; column <= columns && i < end; ++column) {
        const double right = frame.x_range.low + frame.x_range.span() * static_cast<double>(column) /
                                                     static_cast<double>(columns);
        // Most columns have about as many points as the others.
        const double beyond = from_axis(frame.x, right);
        const std::size_t guess = std::min(end, i + 2 * typical);
        const std::size_t next = guess < end && curve.x[guess] > beyond
                                     ? first_above(curve.x, i, guess, beyond)
                                     : first_above(curve.x, i, end, beyond);
        if (next - i <= few)
            maker.points(i, next);
        else
            maker.column(i, next);
        i = next;
    }
    maker.points(std::min(i, end - 1), end); // the last one in any case: it is the current value
    return maker.take();
}

const Colour& curve_colour(const Theme& theme, std::size_t colour) {
    return theme.curves[colour % theme.curves.size()];
}

std::vector<PixelPath> pixel_paths(const PlotView& plot, const PlotFrame& frame) {
    std::vector<PixelPath> paths;
    for (const CurveView& curve : plot.curves) paths.push_back(pixel_path(curve, frame));
    return paths;
}

double length_within(const PixelPath& path, ScreenRect rect) {
    const DPoint low{static_cast<double>(rect.min.x), static_cast<double>(rect.min.y)};
    const DPoint high{static_cast<double>(rect.max.x), static_cast<double>(rect.max.y)};
    double length = 0;
    for (std::size_t i = 0; i + 1 < path.x.size(); ++i) {
        DPoint a{path.x[i], path.y[i]}, b{path.x[i + 1], path.y[i + 1]};
        if (std::isnan(a.y) || std::isnan(b.y)) continue;
        if (std::max(a.x, b.x) < low.x || std::min(a.x, b.x) > high.x) continue;
        if (clip_line(a, b, low, high)) length += std::hypot(b.x - a.x, b.y - a.y);
    }
    return length;
}

void draw_curves(ImDrawList& list, const PlotView& plot, const std::vector<PixelPath>& paths,
                 const PlotFrame& frame, const Theme& theme, float scale) {
    const ScreenRect& area = frame.area;
    list.PushClipRect({area.min.x - 4 * scale, area.min.y - 4 * scale},
                      {area.max.x + 4 * scale, area.max.y + 4 * scale}, true);
    for (const bool behind : {true, false})
        for (std::size_t i = 0; i < plot.curves.size(); ++i)
            if (const CurveView& curve = plot.curves[i]; curve.behind == behind)
                draw_curve(list, curve, paths[i], area,
                           packed(curve_colour(theme, curve.colour), curve.opacity), scale);
    list.PopClipRect();
}

} // namespace gaspard
