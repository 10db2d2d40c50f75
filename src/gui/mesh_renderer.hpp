// Draws a MeshPicture with OpenGL: cells filled by a colour map, edges as smooth lines of constant width,
// tangled cells on top. Leaves the rest of the framebuffer alone.
//
// Positions go to the graphics card in single precision relative to a centre that was subtracted in double.
#pragma once

#include "gui/camera.hpp"
#include "gui/gl_objects.hpp"
#include "gui/mesh_picture.hpp"
#include "gui/theme.hpp"

namespace gaspard {

/// A part of the framebuffer in its own pixels, from the upper left corner.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
    Size size() const { return {static_cast<double>(width), static_cast<double>(height)}; }
};

class MeshRenderer {
  public:
    /// `gl` must outlive the renderer and be current whenever it is used and when it dies.
    explicit MeshRenderer(const Gl& gl);

    /// Fills `area` of the bound framebuffer, which is `framebuffer_height` high, with the theme's background
    /// and the picture. `camera` speaks of area.size() pixels; `scale` widens lines on high-density displays.
    void draw(const MeshPicture& picture, const Camera& camera, PixelRect area, int framebuffer_height,
              const Theme& theme, float scale);

    /// Bytes sent to the graphics card so far: unchanged arrays send none.
    std::size_t uploaded_bytes() const { return uploaded_bytes_; }

  private:
    /// Numbers that shaders fetch by index: rows of a texture, as buffer textures may be too small.
    struct Table {
        GlTexture texture;
        int rows = 0;
    };
    struct FillUniforms {
        GLint clip, blend, computational, physical, colours, surface, plain, range;
    };
    struct LineUniforms {
        GLint clip, blend, computational, physical, segments, colours, viewport, width, fade, plain, range,
            on_dark, on_light, surface, flat_colour, pull;
    };

    void upload(const MeshPicture& picture);
    void upload_structure(const MeshPicture& picture);
    void upload_positions(const Points& points, const std::vector<double>* scalar, Table& table);
    void upload_colours(const MeshPicture& picture);
    void upload_tangled(const MeshPicture& picture);
    void fill_table(Table& table, GLint internal_format, GLenum format, GLenum type, const void* texels,
                    std::size_t count, std::size_t texel_bytes);
    void bind_table(const Table& table, int unit);
    void set_state(PixelRect area, int framebuffer_height, const Theme& theme);
    void draw_fill(const MeshPicture& picture, const glm::mat4& clip, const Theme& theme);
    void draw_lines(const MeshPicture& picture, const glm::mat4& clip, Size size, const Theme& theme,
                    float scale);
    void draw_tangled(const MeshPicture& picture, const glm::mat4& clip, Size size, const Theme& theme,
                      float scale);

    const Gl& gl_;
    GlProgram fill_program_, line_program_;
    FillUniforms fill_{};
    LineUniforms line_{};
    GlVertexArray fill_array_, tangled_array_, empty_array_;
    GlBuffer triangles_, tangled_triangles_;
    Table computational_, physical_, segments_, discs_, outlines_;
    GlTexture colours_;
    std::size_t triangle_count_ = 0, tangled_count_ = 0, segment_count_ = 0, disc_count_ = 0,
                outline_count_ = 0;
    Vec3 centre_;
    MeshPicture shown_; ///< what is on the card; holds its arrays, so that a pointer is a version
    std::size_t uploaded_bytes_ = 0;
};

} // namespace gaspard
