// The range of a plot's axis and the positions of values on it; used by the window and by the papers'
// figures.
//
// Positions are in axis units: the values themselves, or log10 of them on logarithmic axes.
#pragma once

#include "core/tessellate/plot.hpp"
#include "core/tessellate/ticks.hpp"

#include <functional>
#include <string>
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

/// The same for an axis of counts: at least one unit, and nothing below 0; of other axes, the range.
AxisRange range_of_counts(const Axis& axis, AxisRange range);

/// The range that the axis requests, as far as it does.
AxisRange asked_range(const Axis& axis, AxisRange otherwise);
/// The range that the plot requests or, by default, that shows every value.
AxisRange shown_range(const Plot& plot, bool vertical);

/// Where a position lies in a range: 0 at its left or lower end, 1 at the other.
double fraction_of(const Axis& axis, AxisRange range, double position);
/// The inverse.
double position_at(const Axis& axis, AxisRange range, double fraction);

/// About `count` ticks at most; their values are values, not positions. Of counts, whole numbers only.
std::vector<Tick> axis_ticks(const Axis& axis, AxisRange range, int count);
/// Those, or fewer, or some of them without a label, so that labels beside each other on an axis of this
/// length do not touch. `width`: of a label along the axis, with the gap to the next one.
std::vector<Tick> fitting_ticks(const Axis& axis, AxisRange range, int count, double length,
                                const std::function<double(const std::string&)>& width);

/// The places between two points of a curve where a line that is straight in values must be bent to be drawn
/// on axes of which one is logarithmic: positions of x within the range, `step` apart at most, none at the
/// points themselves. Also from a value of 0 of a logarithmic axis, which is infinitely far away, on.
std::vector<double> bends_between(const Axis& x, AxisRange range, double from, double to, double step);
/// The value there of a curve that is linear between two points.
double value_between(double x, double x0, double y0, double x1, double y1);

} // namespace gaspard
