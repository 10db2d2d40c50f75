// The legend of the colours: a bar with ticks, and beside it a histogram.
#pragma once

#include "core/tessellate/colouring.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/base/screen_rect.hpp"
#include "gui/base/theme.hpp"

#include <imgui.h>
#include <vector>

namespace gaspard {

/// Both ends of the range, and round values between that keep their distance.
std::vector<Tick> legend_ticks(const ColourRange& range);

/// The width of the legend beside a viewport, in pixels. It does not depend on the values, so that the view
/// does not shake. Needs a current ImGui frame.
float legend_width(const Colouring& colouring, bool histogram, float scale);

/// In the middle of the right side of `available`.
void draw_legend(ImDrawList& list, const Colouring& colouring, bool histogram, ScreenRect available,
                 const Theme& theme, float scale);

} // namespace gaspard
