// Draws a Plot: axes with ticks and grid, curves, their legend, and as a widget the values at the pointer and
// the zoom.
//
// Empty plots, gaps (NaN), single points and values that a logarithmic axis cannot show (zero, negative) are
// all fine: what can be drawn is drawn.
#pragma once

#include "gui/plot/plot_axes.hpp"

#include <optional>

namespace gaspard {

/// What the left button does within the area of the curves.
struct PlotPointing {
    enum class Use {
        sweep, ///< a drag gives the value of x; it does not pan
        point, ///< a click gives the value of x, and so does a drag of a mark with a handle
    };
    Use use = Use::sweep;
    std::optional<double> x{};   ///< what was pointed at in this frame
    bool double_clicked = false; ///< in this frame, after a first click
};

/// Without a pointer and without zoom, as for a file.
void draw_plot(ImDrawList& list, const Plot& plot, ScreenRect rect, const Theme& theme, float scale);

/// The same of a view, which may be zoomed.
void draw_plot(ImDrawList& list, const PlotView& plot, ScreenRect rect, const PlotZoom& zoom,
               const Theme& theme, float scale);

/// A plot in the current window, with the values at the pointer beside it, and steered with the mouse: the
/// wheel zooms at the pointer (with Shift, or over the axis below, only x; with Ctrl, or over the axis at the
/// left, only y), the left button drags, the right one zooms to a rectangle, a double click shows everything
/// again. True when clicked with the right button: a menu is asked for.
///
/// `pointing` says what else the left button does within the area of the curves, and receives the value of x.
bool plot_widget(const char* id, const PlotView& plot, ImVec2 size, PlotZoom& zoom, const Theme& theme,
                 float scale, PlotPointing* pointing = nullptr);

} // namespace gaspard
