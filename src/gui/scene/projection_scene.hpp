// The scene of a mesh on a ball in a map projection (core/tessellate/sphere_map.hpp): a planar scene of the
// same cells.
#pragma once

#include "gui/scene/mesh_scene.hpp"

namespace gaspard {

/// Makes projections frame after frame; keeps what does not change between them.
class ProjectionSceneBuilder {
  public:
    /// Projects the mesh with the globe's blend. `longitude`: of the centre, in degrees. The globe's nodes
    /// lie on a ball. A projection has no arrows.
    MeshScene make(const MeshScene& globe, double longitude);

  private:
    MeshScene globe_; ///< which the last projection was made of
    SphereMap made_;
    MeshScene projected_;
};

} // namespace gaspard
