// Which points get an arrow from xi to x, so that arrows do not crowd the image.
#pragma once

#include "core/tessellate/camera.hpp"
#include "gui/scene/mesh_scene.hpp"

#include <cstdint>
#include <vector>

namespace gaspard {

/// Shown points that are nodes, at most one in each square of `spacing` pixels (of a mesh in space: in each
/// cube, so that points behind do not displace points in front). The squares are fixed to the mesh, so
/// that panning changes nothing; they are filled by xi, so that arrows do not come and go while the mesh
/// moves.
std::vector<std::uint32_t> points_with_arrows(const MeshScene& scene, const Camera& camera, Size size,
                                              double spacing);

} // namespace gaspard
