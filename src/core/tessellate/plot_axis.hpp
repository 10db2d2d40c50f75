// The range of a plot's axis and the positions of values on it; used by the window and by the papers'
// figures.
//
// Positions are in axis units: the values themselves, or log10 of them on logarithmic axes.
#pragma once

#include "core/tessellate/plot.hpp"
#include "core/tessellate/ticks.hpp"

#include <vector>

namespace gaspard {

/// The visible range of an axis, in axis units.
struct AxisRange {
    double low = 0, high = 1;
    double span() const { return high - low; }
    friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

/// The decades in which doubles have full precision.
inline constexpr double lowest_decade = -307, highest_decade = 308;

/// The position of a value; NaN if the axis cannot show it.
double to_axis(const Axis& axis, double value);
/// The inverse of to_axis, clamped to the range of doubles.
double from_axis(const Axis& axis, double position);

/// The range that shows all values from `low` to `high`, with 5 % padding on request. If low > high (no
/// values): [0, 1], or one decade.
AxisRange range_around(double low, double high, bool logarithmic, bool padding);

/// The range that the plot requests or, by default, that shows every value.
AxisRange shown_range(const Plot& plot, bool vertical);

/// About `count` ticks at most; their values are values, not positions.
std::vector<Tick> axis_ticks(const Axis& axis, AxisRange range, int count);

} // namespace gaspard
