// The layout of the window's parts, in window coordinates; everything scales with the font.
#pragma once

#include "gui/base/item_rectangles.hpp"

namespace gaspard {

/// Which parts the user shows, and their sizes.
struct LayoutChoice {
    bool sidebar = true, plots = true, log = false;
    float sidebar_width = 19;  ///< in widths of the font; never more than two fifths of the window
    float plots_share = 0.26F; ///< of the width, or height, beside the sidebar
};

struct Layout {
    ItemRectangle sidebar, viewport, status, log; ///< without area where they are not shown
    ItemRectangle playback;                       ///< within the status
    ItemRectangle first_plot, second_plot;
    /// The strips by which sidebar and plots are made wider, or higher; without area where there is nothing.
    ItemRectangle sidebar_edge, plots_edge;
    bool plots_beside = true; ///< to the right of the viewport, or else below it
    /// Where the window is too small for two plots, the second has no area; for one beside the mesh, neither.
    int plots = 2;
    ItemRectangle plots_note; ///< below the viewport, to say so; else without area
};

/// `em`: the font's size. `top`: how much of the window's height the menu bar takes.
Layout compute_layout(float width, float height, float em, float top, const LayoutChoice& choice = {});

} // namespace gaspard
