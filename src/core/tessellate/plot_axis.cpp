#include "core/tessellate/plot_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace gaspard {

double to_axis(const Axis& axis, double value) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(value)) return nothing;
    if (!axis.logarithmic) return value;
    return value > 0 ? std::log10(value) : nothing;
}

double from_axis(const Axis& axis, double position) {
    if (!axis.logarithmic) return position;
    return std::pow(10.0, std::clamp(position, lowest_decade, highest_decade));
}

AxisRange range_around(double low, double high, bool logarithmic, bool padding) {
    if (low > high) return logarithmic ? AxisRange{-1, 0} : AxisRange{0, 1};
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low <= 1e-12 * size || high == low) {
        const double half = logarithmic ? 0.5 : size > 0 ? 0.05 * size : 0.5;
        return {low - half, high + half};
    }
    const double more = padding ? 0.05 * (high - low) : 0;
    return {low - more, high + more};
}

AxisRange range_of_counts(const Axis& axis, AxisRange range) {
    if (!axis.whole || axis.logarithmic) return range;
    if (range.span() < 1) range = {std::floor(range.low), std::ceil(range.high)};
    range.low = std::max(range.low, 0.0);
    return {range.low, std::max(range.high, range.low + 1)};
}

AxisRange asked_range(const Axis& axis, AxisRange otherwise) {
    const double low = axis.low ? to_axis(axis, *axis.low) : otherwise.low;
    const double high = axis.high ? to_axis(axis, *axis.high) : otherwise.high;
    return low < high ? AxisRange{low, high} : otherwise;
}

AxisRange shown_range(const Plot& plot, bool vertical) {
    const Axis& axis = vertical ? plot.y : plot.x;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    bool markers = false;
    for (const Curve& curve : plot.curves) {
        markers = markers || curve.markers;
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            // Ignore points that the other axis cannot show.
            const double x = to_axis(plot.x, curve.x[i]), y = to_axis(plot.y, curve.y[i]);
            if (std::isnan(x) || std::isnan(y)) continue;
            low = std::min(low, vertical ? y : x), high = std::max(high, vertical ? y : x);
        }
    }
    for (const PlotLevel& level : plot.levels)
        if (const double at = to_axis(axis, level.y); vertical && !std::isnan(at))
            low = std::min(low, at), high = std::max(high, at);
    const AxisRange all = range_around(low, high, axis.logarithmic, vertical || markers);
    return asked_range(axis, range_of_counts(axis, all));
}

double fraction_of(const Axis& axis, AxisRange range, double position) {
    return (axis.reversed ? range.high - position : position - range.low) / range.span();
}

double position_at(const Axis& axis, AxisRange range, double fraction) {
    return axis.reversed ? range.high - fraction * range.span() : range.low + fraction * range.span();
}

/// A label of a distance as one of a place. Differences between distances ("+2×10⁻¹³") stay differences, of
/// the other sign where the place is that much before an end.
static std::string behind(const std::string& before, std::string label) {
    static constexpr std::string_view minus = "−";
    if (before.empty() || label.empty()) return label;
    const bool more = label.front() == '+', less = label.starts_with(minus);
    if (!more && !less) return before + label;
    if (!before.ends_with(minus) && !before.ends_with("− ")) return label;
    return more ? std::string(minus).append(label, 1) : "+" + label.substr(minus.size());
}

/// Less than one unit apart, ticks have labels with decimals, which whole numbers do without.
static void keep_counts(std::vector<Tick>& ticks) {
    constexpr double slack = 1e-6;
    std::erase_if(ticks, [](const Tick& tick) {
        return tick.value < -slack || std::abs(tick.value - std::round(tick.value)) > slack;
    });
    for (Tick& tick : ticks) {
        tick.value = std::round(tick.value);
        if (tick.label.find('.') != std::string::npos) tick.label = short_number(tick.value, 9);
    }
}

/// Removes the labels that touch the one before.
static void thin_touching(std::vector<Tick>& ticks, const Axis& axis, AxisRange range, double length,
                          const std::function<double(const std::string&)>& width) {
    double end = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        Tick& tick = ticks[axis.reversed ? ticks.size() - 1 - i : i];
        if (tick.label.empty()) continue;
        const double at = fraction_of(axis, range, to_axis(axis, tick.value)) * length;
        const double half = width(tick.label) / 2;
        if (at - half < end)
            tick.label.clear();
        else
            end = at + half;
    }
}

std::vector<Tick> axis_ticks(const Axis& axis, AxisRange range, int count) {
    if (axis.whole && !axis.logarithmic) count = std::min(count, std::max(1, static_cast<int>(range.span())));
    std::vector<Tick> ticks = axis.logarithmic
                                  ? log_ticks(from_axis(axis, range.low), from_axis(axis, range.high), count)
                                  : linear_ticks(range.low, range.high, count);
    if (axis.whole) keep_counts(ticks);
    for (Tick& tick : ticks) tick.label = behind(axis.before, std::move(tick.label));
    return ticks;
}

std::vector<Tick> fitting_ticks(const Axis& axis, AxisRange range, int count, double length,
                                const std::function<double(const std::string&)>& width) {
    const auto touch = [&](const std::vector<Tick>& ticks) {
        double end = -std::numeric_limits<double>::infinity(); // of the label before, in units of the length
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            const Tick& tick = ticks[axis.reversed ? ticks.size() - 1 - i : i];
            if (tick.label.empty()) continue;
            const double at = fraction_of(axis, range, to_axis(axis, tick.value)) * length;
            const double half = width(tick.label) / 2;
            if (at - half < end) return true;
            end = at + half;
        }
        return false;
    };
    std::vector<Tick> ticks = axis_ticks(axis, range, count);
    while (count > 1 && touch(ticks)) ticks = axis_ticks(axis, range, --count);
    thin_touching(ticks, axis, range, length, width);
    return ticks;
}

std::vector<double> bends_between(const Axis& x, AxisRange range, double from, double to, double step) {
    if (!(from < to) || !(to > 0 || !x.logarithmic)) return {};
    const double first = x.logarithmic && from <= 0 ? range.low : to_axis(x, from), last = to_axis(x, to);
    const double low = std::max(first, range.low), high = std::min(last, range.high);
    if (!(low < high) || !(step > 0)) return {};
    const auto pieces = static_cast<std::size_t>(std::ceil(std::min((high - low) / step, 1e5)));
    std::vector<double> places;
    for (std::size_t i = 0; i <= pieces; ++i) {
        const double at = low + (high - low) * static_cast<double>(i) / static_cast<double>(pieces);
        if ((at > first || from <= 0) && at < last) places.push_back(at);
    }
    return places;
}

double value_between(double x, double x0, double y0, double x1, double y1) {
    return y0 + (y1 - y0) * ((x - x0) / (x1 - x0));
}

} // namespace gaspard
