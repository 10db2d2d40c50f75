// How a viewport looks, in the window and in a picture alike: the mesh, the legend of its colours, one
// caption line.
//
// The mesh is drawn by MeshRenderer over the whole area; what is here draws on top with an ImDrawList, and
// tells how much room that takes, so that the camera's home keeps the mesh clear of it.
#pragma once

#include "core/session/snapshot.hpp"
#include "gui/camera.hpp"
#include "gui/mesh_picture.hpp"
#include "gui/plot_widget.hpp"
#include "gui/theme.hpp"

#include <imgui.h>
#include <string>
#include <vector>

namespace gaspard {

struct ViewportText {
    std::string title{};   ///< above the mesh; may be empty
    std::string subject{}; ///< what is solved: "plane, ring"; may be empty
    StepReport report{};
    bool caption = true; ///< whether the line at the bottom is drawn
};

/// "plane, ring", "iteration 52", "residual 9.8×10⁻⁹", "equidistribution 0.0367", "converged": what the
/// caption says.
std::vector<std::string> caption_parts(const ViewportText& text);

/// What title, legend and caption take of the sides of an area, in pixels. Needs a current ImGui frame.
Insets viewport_insets(const MeshPicture& picture, const ViewportText& text, Size area, float scale);

/// Legend and caption over `rect`, where the mesh has been drawn.
void draw_viewport_overlay(ImDrawList& list, const MeshPicture& picture, const ViewportText& text,
                           ScreenRect rect, const Theme& theme, float scale);

} // namespace gaspard
