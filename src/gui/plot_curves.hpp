// Draws the curves of a plot, at a cost that depends on the pixels rather than on the number of points: where
// many points share a column of pixels, the first, the lowest, the highest and the last of them are drawn.
#pragma once

#include "gui/plot_axes.hpp"

namespace gaspard {

/// Clips to the frame's area and a little beyond.
void draw_curves(ImDrawList& list, const PlotView& plot, const PlotFrame& frame, const Theme& theme,
                 float scale);

/// The points that draw_curves() takes of a curve, as pixels; a NaN in y is a gap.
struct PixelPath {
    std::vector<double> x, y;
};
PixelPath pixel_path(const CurveView& curve, const PlotFrame& frame);

const Colour& curve_colour(const Theme& theme, std::size_t colour);

} // namespace gaspard
