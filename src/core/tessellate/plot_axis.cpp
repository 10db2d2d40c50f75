#include "core/tessellate/plot_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
    AxisRange range = range_around(low, high, axis.logarithmic, vertical || markers);
    const double asked_low = axis.low ? to_axis(axis, *axis.low) : range.low;
    const double asked_high = axis.high ? to_axis(axis, *axis.high) : range.high;
    return asked_low < asked_high ? AxisRange{asked_low, asked_high} : range;
}

std::vector<Tick> axis_ticks(const Axis& axis, AxisRange range, int count) {
    if (axis.logarithmic) return log_ticks(from_axis(axis, range.low), from_axis(axis, range.high), count);
    return linear_ticks(range.low, range.high, count);
}

} // namespace gaspard
