// What an axis of a plot spans and where a value lies on it; the window's plots and the papers' agree in
// this.
//
// Axes count in axis units: those of the values, or decades (log10) where logarithmic.
#pragma once

#include "core/tessellate/plot.hpp"
#include "core/tessellate/ticks.hpp"

#include <vector>

namespace gaspard {

/// The stretch of an axis, in axis units.
struct AxisRange {
    double low = 0, high = 1;
    double span() const { return high - low; }
    friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

/// The decades of doubles that have all their digits.
inline constexpr double lowest_decade = -307, highest_decade = 308;

/// In axis units; NaN where the axis cannot show the value.
double to_axis(const Axis& axis, double value);
/// Back; kept within what a double can be.
double from_axis(const Axis& axis, double position);

/// What an axis spans to show all from `low` to `high`, with a little `workspace` or without; [0, 1] (or one
/// decade) where low > high: there is nothing to show.
AxisRange range_around(double low, double high, bool logarithmic, bool workspace);

/// What the plot asks to be seen, or what shows every value that can be shown.
AxisRange shown_range(const Plot& plot, bool vertical);

/// At most about `count` ticks; their values are values, not positions.
std::vector<Tick> axis_ticks(const Axis& axis, AxisRange range, int count);

} // namespace gaspard
