// The strips between the parts of the window: dragging them resizes the parts.
#pragma once

#include "core/base/parameter.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/base/layout.hpp"

namespace gaspard {

/// `settings`: values of settings_rows(), which remember the sizes. Keys "edge.sidebar" and "edge.plots".
void draw_edges(const Layout& layout, Values& settings, const FrameContext& context);

} // namespace gaspard
