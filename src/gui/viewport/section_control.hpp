// The line of view.section: how it is drawn over a mesh in the plane, and its ends, which the mouse drags.
#pragma once

#include "gui/base/frame_context.hpp"
#include "gui/viewport/viewport.hpp"

#include <cstddef>
#include <optional>

namespace gaspard {

/// The line in a view that shows the adapted mesh.
void draw_section_line(ImDrawList& list, const PlannedView& shown, const SectionLine& line,
                       const Theme& theme, float scale);

/// A line through the middle of what a scene shows.
SectionLine usual_section_line(const MeshScene& scene);

class SectionControl {
  public:
    /// After the item that receives the mouse. True if the mouse has an end of the line.
    bool interact(Values& view, const ViewportPlan& plan, float scale);
    /// The ends. Keys "section.0" and "section.1".
    void draw(const ViewportPlan& plan, const FrameContext& context) const;

  private:
    std::optional<std::size_t> held_; ///< the end that is being dragged
};

/// The values along the line of a plan, made anew when scene or line have changed.
class SectionPlotMaker {
  public:
    /// Without a line or a mesh in the plane, a plot whose title says so.
    Plot plot(const ViewportPlan& plan);
    std::string csv(const ViewportPlan& plan);

  private:
    bool follow(const ViewportPlan& plan);

    std::shared_ptr<const Tessellation> shape_;
    std::shared_ptr<const Points> shown_;
    std::shared_ptr<const Colouring> colouring_;
    std::optional<SectionLine> line_;
    ValuesOnLine values_;
};

} // namespace gaspard
