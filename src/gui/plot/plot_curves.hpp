// Draws the curves of a plot, at a cost that depends on the pixels rather than on the number of points: where
// many points share a column of pixels, the lowest and the highest of them are drawn.
#pragma once

#include "gui/plot/plot_axes.hpp"

namespace gaspard {

/// The points that are drawn of a curve, as pixels; a NaN in y is a gap.
struct PixelPath {
    std::vector<double> x, y;
    std::vector<char> between{}; ///< of those that are no points of the curve: lines bend there; may be short
};
PixelPath pixel_path(const CurveView& curve, const PlotFrame& frame);
/// Of all curves, in their order.
std::vector<PixelPath> pixel_paths(const PlotView& plot, const PlotFrame& frame);
/// How much of a path lies within a rectangle, in pixels.
double length_within(const PixelPath& path, ScreenRect rect);

/// `paths`: of the plot's curves. Clips to the frame's area and a little beyond.
void draw_curves(ImDrawList& list, const PlotView& plot, const std::vector<PixelPath>& paths,
                 const PlotFrame& frame, const Theme& theme, float scale);

const Colour& curve_colour(const Theme& theme, std::size_t colour);

} // namespace gaspard
