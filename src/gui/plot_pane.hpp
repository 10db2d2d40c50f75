// The plots of a document as parts of the window.
#pragma once

#include "gui/document.hpp"
#include "gui/viewport_pane.hpp"

namespace gaspard {

class PlotPane {
  public:
    /// Draws two plots, each into a window of its own.
    void frame(const Document& document, const ItemRectangle& first, const ItemRectangle& second,
               const FrameContext& context);
};

} // namespace gaspard
