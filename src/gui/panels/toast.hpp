// A message over the bottom of the meshes, with an action that helps. It is dismissed with a button and comes
// back when it says something else.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/panels/status_bar.hpp"

#include <string>

namespace gaspard {

struct Toast {
    std::string text;               ///< empty: nothing is shown
    Tone tone = Tone::plain;        ///< of its edge
    const Action* action = nullptr; ///< its button; may be null
    bool closable = true;
};

class ToastPanel {
  public:
    /// Over the meshes in `viewport`. True when the action's button was pressed. Notes "message", "remedy"
    /// (the button) and "message.close".
    bool draw(const Toast& toast, const ItemRectangle& viewport, const FrameContext& context);
    /// Whether this toast is shown, not dismissed.
    bool shows(const Toast& toast) const { return !toast.text.empty() && toast.text != dismissed_; }
    void close(const Toast& toast) { dismissed_ = toast.text; }

  private:
    std::string dismissed_;
};

} // namespace gaspard
