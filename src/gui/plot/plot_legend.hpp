// The names of a plot's curves, in the corner where they hide least of the curves; of more than four curves
// in a small plot, in lines above them.
#pragma once

#include "gui/plot/plot_curves.hpp"

namespace gaspard {

/// Size of the lines of names above the curves of a plot that may take `area`; zero where a box inside is
/// small enough.
ImVec2 legend_strip(const PlotView& plot, ScreenRect area, float scale);

/// Draws nothing for a single curve or without space. `paths`: of the plot's curves. Returns the whole of the
/// name at `pointer` if it is written shortened, or the names that "and 3 more" stands for.
std::string draw_legend(ImDrawList& list, const PlotView& plot, const std::vector<PixelPath>& paths,
                        const PlotFrame& frame, const Theme& theme, float scale, ImVec2 pointer);

/// The first of the corners (upper right, lower left, upper left, lower right) and of the middles below and
/// above that is free for a box of this size, or else the one in which least is hidden.
ScreenRect legend_place(const std::vector<PixelPath>& paths, ScreenRect area, ImVec2 size, float margin);

} // namespace gaspard
