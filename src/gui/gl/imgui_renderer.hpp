// Draws ImGui's ImDrawData through our own table of OpenGL functions, in a window and offscreen alike.
//
// Leaves blending on, scissor and depth test off, and its own program bound; later drawing
// code sets the state that it needs.
#pragma once

#include "gui/gl/gl_objects.hpp"
#include "gui/gl/picture_sheet.hpp"
#include "gui/gl/pixel_rect.hpp"

#include <climits>
#include <cstdint>
#include <imgui.h>
#include <memory>
#include <vector>

namespace gaspard {

/// The texture of a font atlas: RGBA, 4 bytes a pixel, which belong to the atlas.
struct FontPixels {
    const unsigned char* rgba = nullptr;
    int width = 0, height = 0;
};
FontPixels pixels_of(ImFontAtlas& atlas);

class ImGuiRenderer {
  public:
    /// For draw data that were made elsewhere, with an atlas that has no texture. Uses no ImGui context, and
    /// so may be on another thread.
    ImGuiRenderer(const Gl& gl, const FontPixels& font);
    /// Makes the font texture of the current ImGui context and tells ImGui what the renderer can do. `gl`
    /// must outlive the renderer and be current whenever it is used and when it dies.
    explicit ImGuiRenderer(const Gl& gl);

    /// Again after the font atlas has changed.
    void update_font();
    /// Texture ids are that of the font and those of picture sheets.
    void draw(const ImDrawData& data) { draw(data, {0, 0, INT_MAX, INT_MAX}); }
    /// What lies in this part of the framebuffer.
    void draw(const ImDrawData& data, PixelRect part);

  private:
    void set_state(const ImDrawData& data, int width, int height);
    void draw_list(const ImDrawList& list, const ImDrawData& data, PixelRect part, int height);
    GLuint texture_of(ImTextureID id);
    void upload(const GlTexture& texture, int width, int height, const unsigned char* rgba);

    const Gl& gl_;
    GlProgram program_;
    GLint clip_;
    GlVertexArray array_;
    GlBuffer vertices_, indices_;
    GlTexture font_;
    struct Sheet {
        std::weak_ptr<const PictureSheet> of;
        GlTexture texture;
        std::uint64_t version = 0; ///< that was uploaded
    };
    std::vector<Sheet> sheets_;
};

} // namespace gaspard
