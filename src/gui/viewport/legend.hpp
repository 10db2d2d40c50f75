// The legend of the colours: a bar with ticks, and beside it a histogram.
#pragma once

#include "core/tessellate/colouring.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/base/screen_rect.hpp"
#include "gui/base/theme.hpp"

#include <cstdint>
#include <imgui.h>
#include <string_view>
#include <vector>

namespace gaspard {

/// Both ends of the range, and round values between that keep their distance.
std::vector<Tick> legend_ticks(const ColourRange& range);

/// The width of the legend beside a viewport, in pixels. It does not depend on the values, so that the view
/// does not shake. Needs a current ImGui frame.
float legend_width(const Colouring& colouring, bool histogram, float scale);

/// How long the bars of a histogram are.
enum class HistogramCounts { square_root, linear, logarithmic };
/// Of a choice of view.histogram_counts.
HistogramCounts histogram_counts(std::string_view choice);
/// Relative to the bar of `most`: in [0, 1], 0 for no value.
float histogram_length(std::uint32_t count, std::uint32_t most, HistogramCounts counts);

/// Where the parts of a legend in the middle of the right side of `available` are.
struct LegendPlaces {
    ScreenRect all, bar;
    ScreenRect low_value, high_value; ///< the numbers at the ends of the bar
};
LegendPlaces legend_places(const Colouring& colouring, bool histogram, ScreenRect available, float scale);

void draw_legend(ImDrawList& list, const Colouring& colouring, bool histogram, HistogramCounts counts,
                 ScreenRect available, const Theme& theme, float scale);

} // namespace gaspard
