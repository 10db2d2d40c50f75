// The axes of a plot: ranges, screen positions of values, ticks, grid and labels.
//
// Ranges are in axis units, as in core/tessellate/plot_axis.hpp. Screen positions are ImGui's, y downwards.
#pragma once

#include "core/tessellate/plot_axis.hpp"
#include "gui/base/screen_rect.hpp"
#include "gui/base/theme.hpp"
#include "gui/plot/plot_view.hpp"

#include <imgui.h>
#include <optional>
#include <span>
#include <vector>

namespace gaspard {

/// The range that the axis asks for, or else that shows all values that it can show, with a small margin;
/// [0, 1] (or one decade) if there are none.
AxisRange home_range(const PlotView& plot, bool vertical);

/// The ranges a user has zoomed to; an axis without a range shows all values, also later ones.
struct PlotZoom {
    std::optional<AxisRange> x, y;
    friend bool operator==(const PlotZoom&, const PlotZoom&) = default;
};

/// Ranges that can be shown: neither narrower than numbers can tell apart nor much wider than `home`.
AxisRange limited(AxisRange range, AxisRange home, bool logarithmic);
/// Makes a range `factor` times as wide about a position that stays where it is.
AxisRange scaled(AxisRange range, double about, double factor);

/// A plot's axes on the screen.
struct PlotFrame {
    Axis x, y;
    AxisRange x_range, y_range;
    std::vector<Tick> x_ticks, y_ticks;
    ScreenRect area;        ///< of the curves
    float strip = 0;        ///< height of the rows of nodes below it
    float legend_width = 0; ///< of the names above it (plot_legend.hpp); 0: a box inside has them

    bool drawable() const { return area.width() >= 8 && area.height() >= 8; }
    double pixel_x(double value) const { return pixel_of_x(to_axis(x, value)); }
    double pixel_y(double value) const { return pixel_of_y(to_axis(y, value)); }
    double pixel_of_x(double position) const;
    double pixel_of_y(double position) const;
    double position_x(double pixel) const; ///< in axis units
    double position_y(double pixel) const;
};

/// The columns of pixels, left to right or right to left, in which there are such places.
std::vector<float> columns_of(std::span<const double> x, const PlotFrame& frame);

PlotFrame make_frame(const PlotView& plot, ScreenRect rect, const PlotZoom& zoom, float scale);
/// Background, grid, ticks and what is written beside them.
void draw_frame(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, ScreenRect rect,
                const Theme& theme, float scale);

} // namespace gaspard
