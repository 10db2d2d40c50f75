// Where the parts of the window stand. Pure arithmetic, in window coordinates; everything scales with the
// font.
#pragma once

#include "gui/item_rectangles.hpp"

namespace gaspard {

struct Layout {
    ItemRectangle toolbar, sidebar, viewport, status;
    ItemRectangle residual, equidistribution; ///< the two plots
};

/// `em`: the font's size. `top`: how much of the window's height the menu bar takes.
Layout compute_layout(float width, float height, float em, float top);

} // namespace gaspard
