// Draws a Plot: axes with ticks and grid, curves, their legend, and the values of the point near the pointer.
//
// Empty plots, gaps (NaN), single points and values that a logarithmic axis cannot show (zero, negative) are
// all fine: what can be drawn is drawn.
#pragma once

#include "core/tessellate/plot.hpp"
#include "gui/theme.hpp"

#include <imgui.h>
#include <optional>

namespace gaspard {

struct ScreenRect {
    ImVec2 min, max;
    float width() const { return max.x - min.x; }
    float height() const { return max.y - min.y; }
};

/// The interval of an axis. Logarithmic axes count in decades.
struct AxisRange {
    double low = 0, high = 1;
};
/// What the axis must span to show every value that it can show, with a little room; [0, 1] (or one decade)
/// if none.
AxisRange axis_range(const Axis& axis, const Plot& plot, bool vertical);

/// The point of the plot that is nearest to `position`, if it is within `reach` pixels.
struct NearestPoint {
    std::size_t curve = 0, index = 0;
};
std::optional<NearestPoint> nearest_point(const Plot& plot, ScreenRect area, ImVec2 position, float reach);

/// `pointer`: where the mouse is, for the read-out; null for none.
void draw_plot(ImDrawList& list, const Plot& plot, ScreenRect rect, const Theme& theme, float scale,
               const ImVec2* pointer = nullptr);

/// The same as a widget in the current window, with read-out where the mouse hovers.
void plot_widget(const char* id, const Plot& plot, ImVec2 size, const Theme& theme, float scale);

} // namespace gaspard
