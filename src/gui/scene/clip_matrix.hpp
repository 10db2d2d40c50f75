// A camera as OpenGL takes it.
#pragma once

#include "core/tessellate/camera.hpp"

#include <glm/mat4x4.hpp>

namespace gaspard {

/// Half the depth of the view, so that all of the box lies within it.
double view_depth(const Camera& camera, const Box& box);

/// From world positions minus `origin` to OpenGL's clip coordinates. `depth`: half the depth of the visible
/// space, in world units, on both sides of the camera's centre.
glm::mat4 clip_matrix(const Camera& camera, Size size, Vec3 origin, double depth);

} // namespace gaspard
