// What the programs that draw a mesh share.
#pragma once

#include "gui/base/theme.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace gaspard {

/// What all draw calls of a scene share.
struct MeshFrame {
    glm::mat4 clip;
    glm::vec3 clip_to_pixels;
    float blend = 1;
    bool planar = true;
    float logarithm = 0; ///< as in colour_map.glsl
    glm::vec4 ball{0};   ///< as in place.glsl
    glm::vec3 viewer{0, 0, 1};
};

/// How segments are drawn.
struct LineStyle {
    float width = 1; ///< in pixels, like the two below
    float fade_begin = 0, fade_end = 0;
    float haze = 0, pull = 0;           ///< as in mesh_line.vert
    Colour surface, flat_ink;           ///< as in mesh_line.frag
    Colour ink_on_light{0, 0, 0, 0};    ///< as in mesh_line.frag
    bool by_map = false;                ///< as in mesh_line.frag
    float limb_begin = 0, limb_end = 0; ///< as in mesh_line.vert; equal: lines do not fade
};

/// Texture units of the tables that shaders read.
namespace mesh_unit {
inline constexpr int computational = 0, physical = 1, colours = 2, segments = 3, cells = 4, cell_values = 5,
                     facets = 6, edges = 7;
} // namespace mesh_unit

} // namespace gaspard
