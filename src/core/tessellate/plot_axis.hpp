// What an axis of a plot spans and where a value lies on it. The window's plots and the papers' figures agree
// in this. Logarithmic axes count in decades.
#pragma once

#include "core/tessellate/plot.hpp"
#include "core/tessellate/ticks.hpp"

#include <vector>

namespace gaspard {

struct AxisSpan {
    double low = 0, high = 1;
};

/// Where a value lies on its axis; NaN where the axis cannot show it.
double on_axis(const Axis& axis, double value);

/// What the axis must span to show every value that it can show, with a little room; [0, 1] (or one decade)
/// if there is none.
AxisSpan span_of_axis(const Axis& axis, const Plot& plot, bool vertical);

/// At most about `count` ticks; their values are values of the axis.
std::vector<Tick> ticks_of_axis(const Axis& axis, AxisSpan span, int count);

} // namespace gaspard
