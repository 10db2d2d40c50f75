// Draws a Plot: axes with ticks and grid, curves, their legend, and as a widget the values at the pointer and
// the zoom.
//
// Empty plots, gaps (NaN), single points and values that a logarithmic axis cannot show (zero, negative) are
// all fine: what can be drawn is drawn.
#pragma once

#include "gui/plot_axes.hpp"

#include <string>

namespace gaspard {

/// Without a pointer and without zoom, as for a file.
void draw_plot(ImDrawList& list, const Plot& plot, ScreenRect rect, const Theme& theme, float scale);

/// The points of the curves nearest to the pointer's abscissa. A curve that has none there (it ended before)
/// is left out.
struct PointedAt {
    std::size_t curve = 0, index = 0;
};
std::vector<PointedAt> points_at(const PlotView& plot, const PlotFrame& frame, float pixel_x);

/// A plot in the current window, with the values at the pointer beside it, and steered with the mouse: the
/// wheel zooms at the pointer (with Shift, or over the axis below, only x; with Ctrl, or over the axis at the
/// left, only y), the left button drags, the right one zooms to a rectangle, a double click shows everything
/// again. True when clicked with the right button: a menu is asked for.
bool plot_widget(const char* id, const PlotView& plot, ImVec2 size, PlotZoom& zoom, const Theme& theme,
                 float scale);

/// `text`, or its beginning and its end where it is wider than `width`.
std::string shortened(std::string_view text, float width);

} // namespace gaspard
