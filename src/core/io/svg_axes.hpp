// The axes of a drawing of a mesh in the plane.
#pragma once

#include "core/io/svg_scene.hpp"

#include <string>

namespace gaspard {

/// What axes need at the left of a mesh and below it, in points.
struct SvgAxesRoom {
    double left = 0, below = 0;
};
SvgAxesRoom svg_room_for_axes(const SvgScene& scene);

/// Along the left and the bottom of the mesh, or of the part that the view shows of it. `name` comes before
/// the id of the group.
std::string svg_axes(const SvgScene& scene, const SvgView& view, const std::string& name, bool computational);

} // namespace gaspard
