// The legend of a picture's colours: a bar with ticks, and beside it how often each colour occurs.
#pragma once

#include "core/tessellate/colouring.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/base/theme.hpp"
#include "gui/plot/plot_widget.hpp"

#include <imgui.h>
#include <vector>

namespace gaspard {

/// Both ends of the range, and round values between that keep their distance.
std::vector<Tick> legend_ticks(const ColourRange& range);

/// What the legend takes of a viewport's side, in pixels; it does not depend on the values, lest the picture
/// tremble. Needs a current ImGui frame.
float legend_width(const Colouring& colouring, bool histogram, float scale);

/// In the middle of the right side of `room`.
void draw_legend(ImDrawList& list, const Colouring& colouring, bool histogram, ScreenRect available,
                 const Theme& theme, float scale);

} // namespace gaspard
