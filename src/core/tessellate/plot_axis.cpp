#include "core/tessellate/plot_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

double on_axis(const Axis& axis, double value) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(value)) return nothing;
    if (!axis.logarithmic) return value;
    return value > 0 ? std::log10(value) : nothing;
}

AxisSpan span_of_axis(const Axis& axis, const Plot& plot, bool vertical) {
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
    if (low > high) return axis.logarithmic ? AxisSpan{-1, 0} : AxisSpan{0, 1};
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low <= 1e-12 * size || high == low) {
        const double half = axis.logarithmic ? 0.5 : size > 0 ? 0.05 * size : 0.5;
        return {low - half, high + half};
    }
    const double room = vertical || markers ? 0.05 * (high - low) : 0;
    return {low - room, high + room};
}

std::vector<Tick> ticks_of_axis(const Axis& axis, AxisSpan span, int count) {
    const auto value = [](double exponent) { return std::pow(10.0, std::clamp(exponent, -307.0, 308.0)); };
    if (axis.logarithmic) return log_ticks(value(span.low), value(span.high), count);
    return linear_ticks(span.low, span.high, count);
}

} // namespace gaspard
