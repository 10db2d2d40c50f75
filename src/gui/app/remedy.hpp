// A banner over the viewport that offers an action for a run that has failed.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/frame_context.hpp"

#include <string>

namespace gaspard {

/// At the bottom of `viewport`: the text, and a button for the action; true when it is pressed. Draws nothing
/// for an empty text. Key "remedy" of the button.
bool draw_remedy(const std::string& text, const Action& action, const ItemRectangle& viewport,
                 const FrameContext& context);

} // namespace gaspard
