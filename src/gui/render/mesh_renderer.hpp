// Draws a MeshScene with OpenGL: cells filled by a colour map, edges as smooth lines of constant width,
// tangled cells with a rim on top, and arrows. Does not touch the rest of the framebuffer.
//
// Positions go to the graphics card in single precision relative to a centre that was subtracted in double.
#pragma once

#include "gui/base/theme.hpp"
#include "gui/gl/gl_objects.hpp"
#include "gui/gl/pixel_rect.hpp"
#include "gui/render/facets.hpp"
#include "gui/render/line_layer.hpp"
#include "gui/render/mesh_draft.hpp"
#include "gui/render/mesh_frame.hpp"
#include "gui/render/texel_table.hpp"
#include "gui/scene/mesh_scene.hpp"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace gaspard {

class MeshRenderer {
  public:
    /// `gl` must outlive the renderer and be current whenever it is used and when it dies.
    explicit MeshRenderer(const Gl& gl);

    /// Fills `area` of the bound framebuffer, which is `framebuffer_height` high, with the theme's background
    /// and the scene. `camera` is one of an image of area.size(); `scale` widens lines on high-density
    /// displays. `quickly`: nearly the same, as for a mesh that moves: many curved cells are subdivided less,
    /// and cells and their edges are drawn as a draft where that is possible. False if
    /// `give_up`, asked before each layer, said so; then the image is not complete.
    bool draw(const MeshScene& scene, const Camera& camera, PixelRect area, int framebuffer_height,
              const Theme& theme, float scale, bool quickly = false,
              const std::function<bool()>& give_up = {});

    /// Bytes sent to the graphics card so far: unchanged arrays send none.
    std::size_t uploaded_bytes() const { return uploaded_bytes_; }

  private:
    struct Texel {
        float r, g, b, a;
    };
    struct LineSet {
        TexelTable table;
        std::size_t count = 0;
    };
    /// The cells of a tessellation and their edges, on the card.
    struct CellSet {
        explicit CellSet(const Gl& gl);
        GlVertexArray array;
        GlBuffer triangles;
        TexelTable facets, cells; ///< cells: which one a triangle belongs to, or a segment
        TexelTable sides;         ///< of sides_on_segments(), for drafts
        LineSet edges, border;    ///< border: those of the edges that are at the mesh's
        DrawnFacets parts;
        std::size_t caps = 0; ///< as in the tessellation
        int cuts = 1;
    };
    using Frame = MeshFrame;
    struct FillUniforms {
        GLint clip, blend, clip_to_pixels, surface, logarithm, flat_cells, ball, viewer, round_cells, dusk,
            nodal, pallor, first_triangle;
    };
    struct LineUniforms {
        GLint clip, blend, half_viewport, half_width, fade, haze, pieces, pull, surface, flat_ink,
            ink_on_light, logarithm, by_map, flat_cells, ball, viewer, limb, bent;
    };
    struct ArrowUniforms {
        GLint clip, half_viewport, head_width, shaft_width, rim_width, pull, ink, rim;
    };

    void upload(const MeshScene& scene);
    void upload_structure(const MeshScene& scene);
    void upload_cells(const Tessellation& tessellation, const MeshScene& scene, CellSet& set);
    void upload_sides(const Tessellation& tessellation, CellSet& set);
    const CellSet& cells_for(bool quickly);
    bool is_round() const;
    void upload_points(const Points& points, const MeshScene& scene, bool with_values, TexelTable& table);
    void upload_cell_values(const MeshScene& scene);
    void upload_colours(const ColourMap& map);
    void upload_contours(const MeshScene& scene);
    void upload_overlay(const MeshScene& scene, bool new_centre);
    void upload_tangled(const MeshScene& scene);
    void upload_triangles(const GlVertexArray& array, const std::vector<std::uint32_t>& triangles);
    void upload_segments(LineSet& set, const std::vector<Segment>& segments);
    void upload_numbers(TexelTable& table, const std::vector<std::uint32_t>& numbers);
    void fill(TexelTable& table, const TexelFormat& format, const void* texels, std::size_t count);
    void clear(PixelRect area, int bottom, const Theme& theme);
    void bind_points(const TexelTable& computational, const TexelTable& physical);
    void bind_cells(const CellSet& set);
    void bind_tables();
    void set_depth_test(bool on);
    /// Which corners of an array of triangles to draw, and how.
    struct FillPart {
        const GlVertexArray& array;
        std::size_t first = 0, count = 0;
        Colour surface{};
        float dusk = 0, pallor = 0; ///< as in mesh_fill.frag
    };
    bool draw_layers(const Frame& frame, PixelRect area, int bottom, const Theme& theme, float scale,
                     bool draft, const std::function<bool()>& give_up);
    void draw_fill(const Frame& frame, const FillPart& part);
    void draw_cells(const Frame& frame, Colour surface);
    void draw_edges(const Frame& frame, PixelRect area, int bottom, const Theme& theme,
                    const LineStyle& style);
    bool can_draft(double across) const;
    void draw_draft(const Frame& frame, const Theme& theme, const LineStyle& style);
    void draw_line_cells(const Frame& frame, LineStyle style, const Theme& theme, float scale);
    void draw_veil(const Frame& frame, const Theme& theme);
    void draw_tangled(const Frame& frame, LineStyle style, const Theme& theme, float scale);
    void draw_contours(const Frame& frame, LineStyle style, float scale);
    void draw_overlay(Frame frame, LineStyle style, float scale);
    void draw_arrows(const Frame& frame, const Theme& theme, float scale);
    void draw_lines(const Frame& frame, const LineSet& set, const LineStyle& style);
    void begin_layer(const Frame& frame, PixelRect area);
    void end_layer(const Frame& frame, PixelRect area, int bottom, Colour light_ink, Colour dark_ink);

    const Gl& gl_;
    GlProgram fill_program_, line_program_, arrow_program_;
    FillUniforms fill_{};
    LineUniforms line_{};
    ArrowUniforms arrow_{};
    GlVertexArray tangled_array_, empty_array_;
    GlBuffer tangled_triangles_;
    TexelTable computational_, physical_, cell_values_, arrows_, overlay_points_, contours_computational_,
        contours_physical_;
    CellSet cells_, coarse_;                        ///< coarse_: for meshes that move, once it was asked for
    std::shared_ptr<const Tessellation> coarse_of_; ///< what coarse_ was made of
    bool is_coarse_ = false;                        ///< coarse_ has something
    const CellSet* drawn_ = &cells_;                ///< one of them
    LineSet discs_, outlines_, overlay_edges_, contours_on_dark_, contours_on_light_;
    std::vector<Texel> texels_; ///< workspace for conversions
    std::vector<float> numbers_;
    GlTexture colours_;
    LineLayer layer_;
    MeshDraft draft_;
    const ColourMap* map_ = nullptr;             ///< what colours_ holds
    std::shared_ptr<const MeshOverlay> overlay_; ///< on the card
    std::size_t tangled_count_ = 0;              ///< corners of triangles
    Vec3 centre_;
    MeshScene shown_; ///< what is on the card; holds its arrays, so that a pointer is a version
    std::size_t uploaded_bytes_ = 0;
};

/// A renderer for each of several meshes in one frame, so that none is sent anew because of the others.
class MeshRenderers {
  public:
    explicit MeshRenderers(const Gl& gl) : gl_(gl) {}
    MeshRenderer& at(std::size_t which) {
        while (renderers_.size() <= which) renderers_.push_back(std::make_unique<MeshRenderer>(gl_));
        return *renderers_[which];
    }

  private:
    const Gl& gl_;
    std::vector<std::unique_ptr<MeshRenderer>> renderers_;
};

} // namespace gaspard
