// The plot of "Why adapt?": interpolation errors of uniform and adapted meshes against the number of cells.
#pragma once

#include "core/diagnostics/interpolation_error.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/document/cell_study.hpp"

namespace gaspard {

class StudyPanel {
  public:
    /// Whether the plot is shown, and the study therefore follows the problem.
    bool wanted() const { return wanted_; }
    /// Draws into the current ImGui window. `current`: the result is that of the present problem. Keys
    /// "why.study", "why.study.plot", "why.study.order", and "why.study.l2", "why.study.maximum",
    /// "why.study.h1" of the buttons for its norm.
    void draw(const CellStudy::Result& result, bool current, const FrameContext& context);

  private:
    void draw_norms(const FrameContext& context);

    bool wanted_ = false;
    ErrorNorm norm_ = ErrorNorm::l2;
};

/// "Order: 1.45 uniform, 1.60 adapted", between the two finest meshes; empty if it is not known.
std::string order_text(const std::vector<InterpolationRow>& rows, ErrorNorm norm);

} // namespace gaspard
