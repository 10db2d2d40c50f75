// A mesh that moves, drawn quickly: cells and their edges in one pass, where mesh_fill, mesh_line and
// line_layer take three. Each cell draws its half of the edges around it, and places in the colour map are
// linear in triangles; for small cells the image is nearly the same.
#pragma once

#include "gui/gl/gl_objects.hpp"
#include "gui/render/mesh_frame.hpp"

#include <cstddef>

namespace gaspard {

struct DraftLook {
    LineStyle edges;
    Colour light_ink, dark_ink; ///< transparent: no edges
    bool flat_cells = false;    ///< each cell has a value of its own
    float dusk = 0;             ///< as in mesh_fill.frag
};

class MeshDraft {
  public:
    /// `gl` must outlive it and be current whenever it is used and when it dies.
    explicit MeshDraft(const Gl& gl);
    /// All facets, which are cells. The tables of mesh_unit are bound, those of the segments excepted.
    void draw(const MeshFrame& frame, std::size_t facets, bool quadrilaterals, const DraftLook& look);

  private:
    const Gl& gl_;
    GlProgram program_;
    struct {
        GLint clip, blend, clip_to_pixels, logarithm, ball, viewer, quadrilaterals, flat_cells, surface,
            half_width, fade, haze, limb, dusk, light_ink, dark_ink;
    } uniforms_{};
    GlVertexArray empty_array_;
};

} // namespace gaspard
