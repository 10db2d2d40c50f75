// The axes of a mesh in the plane, beside it or, where its edges are out of sight, at the edges of the pane.
#pragma once

#include "core/tessellate/camera.hpp"
#include "gui/viewport/viewport.hpp"

#include <imgui.h>

namespace gaspard {

/// Whether a scene has axes: a mesh in the plane, seen from above.
bool has_axes(const MeshScene& scene);
/// What axes need at the left of the mesh, below it and, for half of a label, at the right. Needs a current
/// ImGui frame.
Insets room_for_axes(const MeshScene& scene, float scale);
/// The box of the mesh that a scene shows.
Box shown_box(const MeshScene& scene);

/// Within `pane`, the part of the view that nothing else takes; no label touches `legend`.
void draw_axes(ImDrawList& list, const PlannedView& shown, ScreenRect pane,
               const std::optional<ScreenRect>& legend, const Theme& theme, float scale);

} // namespace gaspard
