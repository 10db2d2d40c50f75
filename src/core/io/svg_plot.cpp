#include "core/io/atomic_file.hpp"
#include "core/io/svg.hpp"
#include "core/io/svg_document.hpp"
#include "core/tessellate/plot_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

/// Distinguishable with red-green colour blindness, too (Okabe and Ito's palette, without its yellow).
constexpr std::array<const char*, 7> curve_colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                      "#56b4e9", "#e69f00", "#333333"};

constexpr double gap = 3, tick_length = 3, row_height = 5; // points

/// A part of the page, of the curves; the rows of nodes are below it.
struct Area {
    double left, top, right, bottom;
    double width() const { return right - left; }
    double height() const { return bottom - top; }
    bool contains(PagePoint p) const {
        constexpr double slack = 0.01;
        return p.x >= left - slack && p.x <= right + slack && p.y >= top - slack && p.y <= bottom + slack;
    }
};

/// From values to the page.
struct Mapping {
    const Plot& plot;
    Area area;
    AxisRange x, y;

    double page_x(double value) const {
        return area.left + fraction_of(plot.x, x, to_axis(plot.x, value)) * area.width();
    }
    double page_y(double value) const {
        return area.bottom - fraction_of(plot.y, y, to_axis(plot.y, value)) * area.height();
    }
};

double widest(const std::vector<Tick>& ticks) {
    double width = 0;
    for (const Tick& tick : ticks) width = std::max(width, svg_text_width(tick.label));
    return width;
}

Area area_of(const Plot& plot, double width, double height, double y_labels, double last_x_label) {
    constexpr double border = 4, line = 1.25 * svg_font_size;
    Area area{border, border + svg_font_size / 2, width - border, height - border - line - gap};
    if (!plot.title.empty()) area.top += line;
    if (!plot.y.label.empty()) area.left += line + gap;
    if (!plot.x.label.empty()) area.bottom -= line;
    area.bottom -= row_height * static_cast<double>(plot.rows.size());
    area.left += y_labels + tick_length + gap;
    area.right -= last_x_label / 2;
    return area;
}

/// The grid as one path per weight; ticks reach out of the frame.
std::string svg_grid(const Mapping& map, const std::vector<Tick>& x, const std::vector<Tick>& y) {
    SvgPath major, minor;
    const Area& area = map.area;
    // Minor lines help only where decades are wide.
    const bool minor_x = area.width() / (map.x.span()) > 36;
    const bool minor_y = area.height() / (map.y.span()) > 36;
    const auto inside = [](double at, double low, double high) {
        return at >= low - 0.01 && at <= high + 0.01;
    };
    for (const Tick& tick : x) {
        const double at = map.page_x(tick.value);
        if (!inside(at, area.left, area.right) || (!tick.major && !minor_x)) continue;
        SvgPath& path = tick.major ? major : minor;
        path.move({at, area.top});
        path.line({at, area.bottom + (tick.major ? tick_length : 0)});
    }
    for (const Tick& tick : y) {
        const double at = map.page_y(tick.value);
        if (!inside(at, area.top, area.bottom) || (!tick.major && !minor_y)) continue;
        SvgPath& path = tick.major ? major : minor;
        path.move({area.left - (tick.major ? tick_length : 0), at});
        path.line({area.right, at});
    }
    std::string text;
    if (!minor.empty())
        text += "<path fill=\"none\" stroke=\"#ddd\" stroke-width=\".25\" d=\"" + minor.data() + "\"/>\n";
    return text + "<path fill=\"none\" stroke=\"#bbb\" stroke-width=\".35\" d=\"" + major.data() + "\"/>\n";
}

std::string svg_labels(const Mapping& map, const std::vector<Tick>& x, const std::vector<Tick>& y,
                       double height) {
    const Area& area = map.area;
    std::string text = "<g fill=\"#222\">\n";
    const double below = area.bottom + row_height * static_cast<double>(map.plot.rows.size());
    for (const Tick& tick : x)
        if (!tick.label.empty())
            text += svg_text({map.page_x(tick.value), below + tick_length + gap + 0.6 * svg_font_size},
                             Anchor::middle, tick.label);
    for (const Tick& tick : y)
        if (!tick.label.empty())
            text +=
                svg_text({area.left - tick_length - gap / 2, map.page_y(tick.value) + 0.36 * svg_font_size},
                         Anchor::end, tick.label);
    const double middle = (area.left + area.right) / 2;
    if (!map.plot.title.empty())
        text += svg_text({middle, 4 + 0.75 * svg_font_size}, Anchor::middle, map.plot.title,
                         "font-weight=\"bold\"");
    if (!map.plot.x.label.empty())
        text += svg_text({middle, height - 4 - 0.2 * svg_font_size}, Anchor::middle, map.plot.x.label);
    if (!map.plot.y.label.empty()) {
        const double at = 4 + 0.75 * svg_font_size, centre = (area.top + area.bottom) / 2;
        text += svg_text({at, centre}, Anchor::middle, map.plot.y.label,
                         "transform=\"rotate(-90 " + svg_number(at) + ' ' + svg_number(centre) + ")\"");
    }
    return text + "</g>\n";
}

/// Of points that follow each other within a quarter of a point of the page from left to right, only the
/// first, the lowest, the highest and the last are seen.
std::vector<PagePoint> thinned(const std::vector<PagePoint>& points) {
    const auto column = [](PagePoint p) { return std::floor(4 * p.x); };
    std::vector<PagePoint> kept;
    for (std::size_t i = 0, next = 0; i < points.size(); i = next) {
        std::size_t low = i, high = i;
        for (next = i + 1; next < points.size() && column(points[next]) == column(points[i]); ++next) {
            if (points[next].y < points[low].y) low = next;
            if (points[next].y > points[high].y) high = next;
        }
        std::array<std::size_t, 4> seen = {i, low, high, next - 1};
        std::sort(seen.begin(), seen.end());
        const auto end = std::unique(seen.begin(), seen.end());
        for (auto k = seen.begin(); k != end; ++k) kept.push_back(points[*k]);
    }
    return kept;
}

/// The places between the last point and this one where a line that is straight in values bends.
void add_bends(const Curve& curve, std::size_t i, const Mapping& map, std::vector<PagePoint>& piece) {
    constexpr double step = 2; // points of the page
    const double x0 = curve.x[i - 1], x1 = curve.x[i], y0 = curve.y[i - 1], y1 = curve.y[i];
    for (const double at : bends_between(map.plot.x, map.x, x0, x1, step * map.x.span() / map.area.width())) {
        const double x = from_axis(map.plot.x, at);
        const PagePoint p{map.page_x(x), map.page_y(value_between(x, x0, y0, x1, y1))};
        if (std::isfinite(p.x) && std::isfinite(p.y)) piece.push_back(p);
    }
}

/// The unbroken pieces of a curve.
std::vector<std::vector<PagePoint>> pieces_of(const Curve& curve, const Mapping& map) {
    std::vector<std::vector<PagePoint>> pieces(1);
    const bool bent = curve.linear && (map.plot.x.logarithmic || map.plot.y.logarithmic);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (bent && i > 0) add_bends(curve, i, map, pieces.back());
        const PagePoint p{map.page_x(curve.x[i]), map.page_y(curve.y[i])};
        if (std::isfinite(p.x) && std::isfinite(p.y))
            pieces.back().push_back(p);
        else if (!pieces.back().empty())
            pieces.emplace_back();
    }
    if (pieces.back().empty()) pieces.pop_back();
    return pieces;
}

/// The points of a curve that the axes can show.
std::vector<PagePoint> points_of(const Curve& curve, const Mapping& map) {
    std::vector<PagePoint> points;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const PagePoint p{map.page_x(curve.x[i]), map.page_y(curve.y[i])};
        if (std::isfinite(p.x) && std::isfinite(p.y)) points.push_back(p);
    }
    return points;
}

std::string svg_disc(PagePoint at, double radius) {
    return "<circle cx=\"" + svg_number(at.x) + "\" cy=\"" + svg_number(at.y) + "\" r=\"" +
           svg_number(radius) + "\"/>\n";
}

/// The part of a line that lies in the area; nothing if none does.
std::optional<std::pair<PagePoint, PagePoint>> clipped(PagePoint a, PagePoint b, const Area& area) {
    double from = 0, to = 1; // along the line
    const double dx = b.x - a.x, dy = b.y - a.y;
    for (const auto& [step, workspace] : {std::pair{-dx, a.x - area.left},
                                          {dx, area.right - a.x},
                                          {-dy, a.y - area.top},
                                          {dy, area.bottom - a.y}}) {
        if (step == 0 && workspace < -0.01) return std::nullopt;
        if (step < 0) from = std::max(from, workspace / step);
        if (step > 0) to = std::min(to, workspace / step);
    }
    if (!(from <= to)) return std::nullopt;
    const PagePoint end = {a.x + to * dx, a.y + to * dy};
    return std::pair{from > 0 ? PagePoint{a.x + from * dx, a.y + from * dy} : a, to < 1 ? end : b};
}

/// Connected lines, as far as they lie in the area.
void add_line(SvgPath& path, const std::vector<PagePoint>& points, const Area& area) {
    bool connected = false;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto part = clipped(points[i - 1], points[i], area);
        if (part) {
            if (!connected) path.move(part->first);
            path.line(part->second);
        }
        connected = part && area.contains(points[i]);
    }
}

/// Discs on the points of a curve, unless they would run into a thick line.
std::string svg_markers(const Curve& curve, const Mapping& map) {
    std::string discs;
    const bool dense = static_cast<double>(curve.x.size()) > map.area.width();
    for (const PagePoint p : thinned(points_of(curve, map)))
        if (map.area.contains(p) && !dense) discs += svg_disc(p, 2);
    return discs;
}

/// A stroke for every place that can be told from the one before.
std::string svg_row(const PlotRow& row, std::size_t number, const Mapping& map, const std::string& colour) {
    SvgPath path;
    const double top = map.area.bottom + row_height * static_cast<double>(number) + 1;
    double last = std::numeric_limits<double>::quiet_NaN();
    for (const double x : row.x) {
        const double at = map.page_x(x);
        if (!(at >= map.area.left - 0.01 && at <= map.area.right + 0.01) || std::abs(at - last) < 0.25)
            continue;
        path.move({at, top});
        path.line({at, top + row_height - 1});
        last = at;
    }
    return "<path fill=\"none\" stroke=\"" + colour + "\" stroke-width=\".5\" d=\"" + path.data() + "\"/>\n";
}

std::string svg_curve(const Curve& curve, const Mapping& map, const std::string& colour) {
    SvgPath path;
    std::string discs;
    for (const auto& piece : pieces_of(curve, map)) {
        const auto points = thinned(piece);
        add_line(path, points, map.area);
        if (!curve.markers && points.size() == 1 && map.area.contains(points[0]))
            discs += svg_disc(points[0], 1);
    }
    if (curve.markers) discs += svg_markers(curve, map);
    std::string text;
    const std::string width = curve.behind ? " stroke-width=\".7\"" : "";
    if (!path.empty())
        text += "<path fill=\"none\" stroke=\"" + colour + '"' + width + " d=\"" + path.data() + "\"/>\n";
    if (!discs.empty()) text += "<g fill=\"" + colour + "\">\n" + discs + "</g>\n";
    return text;
}

/// Thin vertical lines at events, with their labels along them.
std::string svg_marks(const Mapping& map) {
    std::string text;
    for (const PlotMark& mark : map.plot.marks) {
        const double x = map.page_x(mark.x);
        if (!map.area.contains({x, map.area.top})) continue;
        SvgPath path;
        path.move({x, map.area.top});
        path.line({x, map.area.bottom});
        text += "<path fill=\"none\" stroke=\"#666\" stroke-width=\".5\" stroke-dasharray=\"2 2\" d=\"" +
                path.data() + "\"/>\n";
        const PagePoint at = {x + 0.9 * svg_font_size, map.area.top + gap};
        text += svg_text(at, Anchor::end, mark.label,
                         "font-size=\"7\" fill=\"#444\" transform=\"rotate(-90 " + svg_number(at.x) + ' ' +
                             svg_number(at.y) + ")\"");
    }
    return text;
}

/// Dashed lines at values, with their labels above the left end, which curves that fall to it leave free.
std::string svg_levels(const Mapping& map) {
    std::string text;
    for (const PlotLevel& level : map.plot.levels) {
        const double y = map.page_y(level.y);
        if (!map.area.contains({map.area.left, y})) continue;
        SvgPath path;
        path.move({map.area.left, y});
        path.line({map.area.right, y});
        text += "<path fill=\"none\" stroke=\"#3a7d44\" stroke-width=\".6\" stroke-dasharray=\"4 2\" d=\"" +
                path.data() + "\"/>\n";
        const bool below = y - svg_font_size < map.area.top;
        text += svg_text({map.area.left + gap, below ? y + svg_font_size : y - gap / 2}, Anchor::start,
                         level.label, "fill=\"#3a7d44\"");
    }
    return text;
}

std::string colour_of(const Plot& plot, std::size_t curve) {
    return curve_colours[plot.curves[curve].colour.value_or(curve) % curve_colours.size()];
}

/// The curves that the legend names.
std::vector<std::size_t> named_curves(const Plot& plot) {
    std::vector<std::size_t> named;
    for (std::size_t c = 0; c < plot.curves.size(); ++c)
        if (!plot.curves[c].label.empty()) named.push_back(c);
    return named;
}

/// How many pieces of the curves a box would hide.
std::size_t hidden_by(const Area& box, const Mapping& map) {
    std::size_t count = 0;
    for (const Curve& curve : map.plot.curves)
        for (const auto& piece : pieces_of(curve, map)) {
            const auto points = thinned(piece);
            for (std::size_t i = 1; i < points.size(); ++i)
                count += clipped(points[i - 1], points[i], box) ? 1 : 0;
        }
    return count;
}

/// The upper right corner, or else the first in which a box of this size hides nothing, or least.
Area legend_box(const Mapping& map, double width, double height, double pad) {
    const double left = map.area.left + pad, right = map.area.right - pad - width;
    const double top = map.area.top + pad, bottom = map.area.bottom - pad - height;
    Area best{};
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const PagePoint corner : {PagePoint{right, top}, {left, bottom}, {left, top}, {right, bottom}}) {
        const Area box{corner.x, corner.y, corner.x + width, corner.y + height};
        const std::size_t hidden = hidden_by(box, map);
        if (hidden < least) best = box, least = hidden;
    }
    return best;
}

namespace legend {
constexpr double line = 1.3 * svg_font_size, sample = 14, pad = 4;
}

/// An entry with its left end here, at half the height of its line.
std::string svg_legend_entry(const Plot& plot, std::size_t curve, PagePoint at) {
    SvgPath path;
    path.move(at);
    path.line({at.x + legend::sample, at.y});
    return "<path fill=\"none\" stroke=\"" + colour_of(plot, curve) + "\" stroke-width=\"1.2\" d=\"" +
           path.data() + "\"/>\n" +
           svg_text({at.x + legend::pad + legend::sample, at.y + 0.36 * svg_font_size}, Anchor::start,
                    plot.curves[curve].label, "fill=\"#222\"");
}

/// Calls `put(curve, place)` for the entries in lines of this width; returns the height.
template <class Put>
double legend_in_lines(const Plot& plot, double width, const Put& put) {
    PagePoint at{0, legend::line / 2};
    for (const std::size_t curve : named_curves(plot)) {
        const double needed = legend::sample + 3 * legend::pad + svg_text_width(plot.curves[curve].label);
        if (at.x > 0 && at.x + needed - 2 * legend::pad > width) at = {0, at.y + legend::line};
        put(curve, at);
        at.x += needed;
    }
    return at.y + legend::line / 2;
}

Area legend_area(const Mapping& map) {
    double width = 0;
    const auto named = named_curves(map.plot);
    for (const std::size_t c : named) width = std::max(width, svg_text_width(map.plot.curves[c].label));
    return legend_box(map, width + legend::sample + 3 * legend::pad,
                      legend::line * static_cast<double>(named.size()) + legend::pad, legend::pad);
}

/// The height of lines above the curves, for more than four names if a box inside would hide curves.
double legend_height_above(const Mapping& map) {
    if (named_curves(map.plot).size() <= 4 || hidden_by(legend_area(map), map) == 0) return 0;
    const double height = legend_in_lines(map.plot, map.area.width(), [](std::size_t, PagePoint) {});
    return height < 0.4 * map.area.height() ? height : 0;
}

std::string svg_legend(const Mapping& map, double height_above) {
    std::string text;
    if (height_above > 0) {
        const double top = map.area.top - height_above - svg_font_size / 2;
        legend_in_lines(map.plot, map.area.width(), [&](std::size_t curve, PagePoint at) {
            text += svg_legend_entry(map.plot, curve, {map.area.left + at.x, top + at.y});
        });
        return text;
    }
    const auto [left, top, right, bottom] = legend_area(map);
    text = "<rect x=\"" + svg_number(left) + "\" y=\"" + svg_number(top) + "\" width=\"" +
           svg_number(right - left) + "\" height=\"" + svg_number(bottom - top) +
           "\" fill=\"#fff\" fill-opacity=\".85\"/>\n";
    const auto named = named_curves(map.plot);
    for (std::size_t row = 0; row < named.size(); ++row)
        text += svg_legend_entry(
            map.plot, named[row],
            {left + legend::pad, top + legend::pad / 2 + legend::line * (static_cast<double>(row) + 0.5)});
    return text;
}

std::string svg_rect(const Area& area, const std::string& attributes) {
    return "<rect x=\"" + svg_number(area.left) + "\" y=\"" + svg_number(area.top) + "\" width=\"" +
           svg_number(area.width()) + "\" height=\"" + svg_number(area.height()) + "\" " + attributes +
           "/>\n";
}

/// What a plot of this size in points is drawn with.
struct Layout {
    AxisRange x_range, y_range;
    std::vector<Tick> x, y;
    Area area{};
    double legend_above = 0; ///< height of its lines above the area; 0: a box inside
};

/// So many ticks as suit the size, but with labels that do not touch in the area.
void fit_ticks(const Plot& plot, Layout& made, double width, double height) {
    const auto height_of = [](const std::string&) { return svg_font_size; };
    const auto width_of = [](const std::string& label) { return svg_text_width(label) + gap; };
    made.y = fitting_ticks(plot.y, made.y_range, static_cast<int>(height / (2.8 * svg_font_size)),
                           made.area.height(), height_of);
    made.x = fitting_ticks(plot.x, made.x_range, static_cast<int>(width / (5 * svg_font_size)),
                           made.area.width(), width_of);
}

Layout layout_of(const Plot& plot, double width, double height) {
    Layout made;
    made.x_range = shown_range(plot, false), made.y_range = shown_range(plot, true);
    made.area = area_of(plot, width, height, 0, 0);
    fit_ticks(plot, made, width, height);
    const Tick* last = made.x.empty() ? nullptr : plot.x.reversed ? &made.x.front() : &made.x.back();
    made.area = area_of(plot, width, height, widest(made.y), last ? svg_text_width(last->label) : 0);
    made.legend_above = legend_height_above({plot, made.area, made.x_range, made.y_range});
    made.area.top += made.legend_above;
    fit_ticks(plot, made, width, height); // in what is left of the area
    return made;
}

std::string svg_content(const Plot& plot, const Layout& layout, double height) {
    const Mapping map{plot, layout.area, layout.x_range, layout.y_range};
    std::string content = svg_grid(map, layout.x, layout.y);
    content += svg_rect(map.area, "fill=\"none\" stroke=\"#444\" stroke-width=\".5\"");
    content += svg_marks(map) + svg_levels(map) +
               "<g stroke-width=\"1.2\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    for (const bool behind : {true, false})
        for (std::size_t c = 0; c < plot.curves.size(); ++c)
            if (plot.curves[c].behind == behind)
                content += svg_curve(plot.curves[c], map, colour_of(plot, c));
    content += "</g>\n";
    for (std::size_t i = 0; i < plot.rows.size(); ++i)
        content += svg_row(plot.rows[i], i, map, curve_colours[plot.rows[i].colour % curve_colours.size()]);
    content += svg_labels(map, layout.x, layout.y, height);
    if (named_curves(plot).size() > 1) content += svg_legend(map, layout.legend_above);
    return content;
}

} // namespace

std::string svg_of_plot(const Plot& plot, const PlotSvgOptions& options) {
    const double width = options.width_mm * points_per_mm, height = options.height_mm * points_per_mm;
    return svg_document(width, height, plot.title, svg_content(plot, layout_of(plot, width, height), height));
}

std::string svg_of_plots(const std::vector<IntervalColumn>& columns, const Background& background,
                         const SvgPage& page) {
    const auto count = static_cast<double>(columns.size());
    const double points = points_per_mm / page.text_size;
    const double height = page.height_mm > 0 ? page.height_mm * points : 120 * points_per_mm;
    const double whole = count > 1 ? 90 * count : 120; // mm
    const double part = (page.width_mm > 0 ? page.width_mm * points : whole * points_per_mm) / count,
                 upper = values_share * height;
    std::string content;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Plot &values = columns[i].values, &spacing = columns[i].spacing;
        Layout above = layout_of(values, part, upper), below = layout_of(spacing, part, height - upper);
        above.area.left = below.area.left = std::max(above.area.left, below.area.left);
        above.area.right = below.area.right = std::min(above.area.right, below.area.right);
        const std::string left = svg_number(part * static_cast<double>(i));
        content += "<g transform=\"translate(" + left + " 0)\">\n" + svg_content(values, above, upper) +
                   "</g>\n<g transform=\"translate(" + left + ' ' + svg_number(upper) + ")\">\n" +
                   svg_content(spacing, below, height - upper) + "</g>\n";
    }
    return svg_document(part * count, height, columns[0].values.title, content, svg_background(background),
                        page.text_size);
}

void write_svg(const std::filesystem::path& file, const Plot& plot, const PlotSvgOptions& options) {
    write_atomically(file, svg_of_plot(plot, options));
}

void write_svg(const std::filesystem::path& file, const std::vector<IntervalColumn>& columns,
               const Background& background) {
    write_atomically(file, svg_of_plots(columns, background));
}

} // namespace gaspard
