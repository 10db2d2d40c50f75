// Draws ImGui's ImDrawData through our own table of OpenGL functions, in a window and offscreen alike.
//
// Leaves blending on, scissor and depth test off, and its own program bound; later drawing
// code sets the state that it needs.
#pragma once

#include "gui/gl/gl_objects.hpp"
#include "gui/gl/pixel_rect.hpp"

#include <climits>
#include <imgui.h>

namespace gaspard {

class ImGuiRenderer {
  public:
    /// Makes the font texture of the current ImGui context and tells ImGui what the renderer can do. `gl`
    /// must outlive the renderer and be current whenever it is used and when it dies.
    explicit ImGuiRenderer(const Gl& gl);

    /// Again after the font atlas has changed.
    void update_font();
    void draw(const ImDrawData& data) { draw(data, {0, 0, INT_MAX, INT_MAX}); }
    /// What lies in this part of the framebuffer.
    void draw(const ImDrawData& data, PixelRect part);

  private:
    void set_state(const ImDrawData& data, int width, int height);
    void draw_list(const ImDrawList& list, const ImDrawData& data, PixelRect part, int height);

    const Gl& gl_;
    GlProgram program_;
    GLint clip_;
    GlVertexArray array_;
    GlBuffer vertices_, indices_;
    GlTexture font_;
};

} // namespace gaspard
