// What every part of the window needs to draw itself in a frame.
#pragma once

#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"

namespace gaspard {

struct FrameContext {
    const Theme& theme;
    float scale = 1;       ///< of sizes, relative to those of the theme
    ItemRectangles& items; ///< receives where the items are drawn
};

} // namespace gaspard
