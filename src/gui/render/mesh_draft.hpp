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
    bool round_cells = false;   ///< as in mesh_fill.frag
    float dusk = 0;             ///< as in mesh_fill.frag
};

class MeshDraft {
  public:
    /// `gl` must outlive it and be current whenever it is used and when it dies.
    explicit MeshDraft(const Gl& gl);
    /// Facets, so many along an edge of a cell. The tables of mesh_unit are bound, that of the segments
    /// excepted, and that of sides_on_segments() only if there are several.
    void draw(const MeshFrame& frame, std::size_t facets, int cuts, bool quadrilaterals,
              const DraftLook& look);

  private:
    const Gl& gl_;
    GlProgram program_;
    struct {
        GLint clip, blend, clip_to_pixels, logarithm, ball, viewer, quadrilaterals, cuts, flat_cells,
            round_cells, surface, half_width, fade, haze, limb, dusk, light_ink, dark_ink;
    } uniforms_{};
    GlVertexArray empty_array_;
};

} // namespace gaspard
