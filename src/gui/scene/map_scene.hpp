// The scene of a mesh on a ball as a map (core/tessellate/sphere_map.hpp): a planar scene of the same cells.
#pragma once

#include "gui/scene/mesh_scene.hpp"

namespace gaspard {

/// Makes maps frame after frame; keeps what does not change between them.
class MapSceneBuilder {
  public:
    /// Of the mesh as the globe's blend has it. `longitude` of the map's middle, in degrees. The globe's
    /// nodes lie on a ball. A map has no arrows.
    MeshScene make(const MeshScene& globe, double longitude);

  private:
    MeshScene globe_; ///< what the last map was made of
    SphereMap made_;
    MeshScene map_;
};

} // namespace gaspard
