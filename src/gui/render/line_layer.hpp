// A layer that collects thin lines before they are blended over an image: where lines meet, the more opaque
// one counts (not both), so that crossings of translucent lines are not darker.
//
// Red holds how much light ink covers a pixel, green how much dark ink. The layer has a depth of its own.
#pragma once

#include "gui/base/theme.hpp"
#include "gui/gl/gl_objects.hpp"

namespace gaspard {

class LineLayer {
  public:
    /// `gl` must outlive the layer and be current whenever it is used and when it dies.
    explicit LineLayer(const Gl& gl);

    /// Clears the layer and directs draw calls to it; the larger value of a pixel stays.
    void begin(int width, int height);
    /// Blends it over the previous framebuffer, with its lower left corner at (x, y).
    void end(int x, int y, Colour light_ink, Colour dark_ink);

  private:
    void resize(int width, int height);

    const Gl& gl_;
    GlProgram program_;
    GLint corner_, light_ink_, dark_ink_;
    GlVertexArray empty_array_;
    GlFramebuffer framebuffer_;
    GlTexture ink_;
    GlRenderbuffer depth_;
    int width_ = 0, height_ = 0;
    GLint before_ = 0; ///< the framebuffer that was drawn to before
};

} // namespace gaspard
