// The list of a document's runs: name, colour in the plots, and whether the plots show it. Kept runs can be
// renamed in place and removed.
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/document/document.hpp"

#include <string>

namespace gaspard {

class RunList {
  public:
    /// Draws into the current ImGui window. True when the live run is to be kept. Notes "runs.keep" and per
    /// run, counted from 0, "runs.0.eye", "runs.0.name", "runs.0.remove".
    bool draw(Document& document, const Action& keep, const FrameContext& context);

  private:
    void draw_name(Document& document, const DocumentRun& run, const std::string& key, float width,
                   const FrameContext& context);

    std::string name_before_; ///< of the run whose name is being edited
};

} // namespace gaspard
