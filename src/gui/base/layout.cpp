#include "gui/base/layout.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

// Smaller ones say nothing, in widths of the font: header, labels of the axes, and some curve between.
constexpr float least_plot_width = 12, least_plot_height = 10.5F;
constexpr float legend_width = 6; // always beside the mesh
constexpr float least_mesh = 8;

/// So many plots fit into a part of this size, side by side or one above the other, and leave `mesh` for the
/// mesh.
int plots_that_fit(float width, float height, bool above_each_other, float mesh, float em) {
    if (mesh < least_mesh * em || width < least_plot_width * em || height < least_plot_height * em) return 0;
    const bool two =
        above_each_other ? height >= 2 * least_plot_height * em : width >= 2 * least_plot_width * em;
    return two ? 2 : 1;
}

/// The plots are placed right of or below the view, whichever leaves the mesh more space; it is about square.
void place_plots(Layout& layout, const ItemRectangle& rest, float em, float share) {
    const auto part = [&](float available, float least, float most) {
        return std::round(std::clamp(share * available, std::min(least, most), most));
    };
    const bool one_only = rest.height() < 2 * least_plot_height * em; // beside the mesh
    const float column = part(rest.width(), (one_only ? least_plot_width : 14) * em, 0.7F * rest.width());
    const float row = part(rest.height(), 13 * em, 0.7F * rest.height());
    const float legend = legend_width * em;
    const float beside = std::min(rest.width() - column - legend, rest.height());
    const float above = std::min(rest.width() - legend, rest.height() - row);
    const float grip = std::round(0.4F * em);
    layout.plots_beside = beside >= above;
    layout.plots = layout.plots_beside ? plots_that_fit(column, rest.height(), true, beside, em)
                                       : plots_that_fit(rest.width(), row, false, above, em);
    if (layout.plots == 0) return;
    const bool two = layout.plots == 2;
    if (layout.plots_beside) {
        const float x = std::max(rest.left, rest.right - column),
                    y = two ? std::round((rest.top + rest.bottom) / 2) : rest.bottom;
        layout.viewport = {rest.left, rest.top, x, rest.bottom};
        layout.first_plot = {x, rest.top, rest.right, y};
        if (two) layout.second_plot = {x, y, rest.right, rest.bottom};
        layout.plots_edge = {x, rest.top, x + grip, rest.bottom};
    } else {
        const float x = two ? std::round((rest.left + rest.right) / 2) : rest.right,
                    y = std::max(rest.top, rest.bottom - row);
        layout.viewport = {rest.left, rest.top, rest.right, y};
        layout.first_plot = {rest.left, y, x, rest.bottom};
        if (two) layout.second_plot = {x, y, rest.right, rest.bottom};
        layout.plots_edge = {rest.left, y, rest.right, y + grip};
    }
}

} // namespace

Layout compute_layout(float width, float height, float em, float top, const LayoutChoice& choice) {
    // Whole units, so that edges are sharp.
    const float status = std::round(4.6F * em), bar = std::round(2.7F * em);
    float bottom = std::max(top, height - status);
    Layout layout;
    layout.status = {0, bottom, width, std::max(height, bottom)};
    float side = 0;
    if (choice.sidebar) side = std::round(std::min(std::max(choice.sidebar_width, 12.0F) * em, 0.4F * width));
    const float state = std::round(std::min(std::max(side, 8 * em), 0.3F * width));
    layout.playback = {state, bottom, width, bottom + bar};
    if (choice.log) {
        const float log = std::round(std::min(11 * em, 0.4F * (bottom - top)));
        layout.log = {0, bottom - log, width, bottom};
        bottom -= log;
    }
    if (choice.sidebar) {
        layout.sidebar = {0, top, side, bottom};
        layout.sidebar_edge = {side - std::round(0.4F * em), top, side, bottom};
    }
    const ItemRectangle rest{side, top, width, bottom};
    layout.viewport = rest;
    layout.plots = 0;
    if (choice.plots) place_plots(layout, rest, em, choice.plots_share);
    if (choice.plots && layout.plots == 0) {
        layout.viewport.bottom = std::max(top, bottom - std::round(1.4F * em));
        layout.plots_note = {side, layout.viewport.bottom, width, bottom};
    }
    return layout;
}

} // namespace gaspard
