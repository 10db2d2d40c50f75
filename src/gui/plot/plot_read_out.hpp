// What a plot says about the place at which the pointer is.
#pragma once

#include "gui/plot/plot_axes.hpp"

namespace gaspard {

/// The points of the curves nearest to the pointer's abscissa. A curve that has none there (it ended before)
/// is left out.
struct PointedAt {
    std::size_t curve = 0, index = 0;
};
std::vector<PointedAt> points_at(const PlotView& plot, const PlotFrame& frame, float pixel_x);

/// A hair line at the nearest points, a disc on each, and a box with their values.
void draw_read_out(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, ImVec2 pointer,
                   const Theme& theme, float scale);

} // namespace gaspard
