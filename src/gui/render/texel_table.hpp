// Numbers that shaders fetch by index: textures, 2048 texels wide, as buffer textures may be too small.
#pragma once

#include "gui/gl/gl_objects.hpp"

#include <cstddef>

namespace gaspard {

/// What one texel of a table is.
struct TexelFormat {
    GLint internal;
    GLenum format, type;
    std::size_t bytes;
};

inline constexpr TexelFormat four_floats{GL_RGBA32F, GL_RGBA, GL_FLOAT, 16},
    one_float{GL_R32F, GL_RED, GL_FLOAT, 4}, four_numbers{GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16},
    one_number{GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4};

class TexelTable {
  public:
    /// Always with the same format. Returns the number of bytes sent.
    std::size_t fill(const Gl& gl, const TexelFormat& format, const void* texels, std::size_t count);
    void bind(const Gl& gl, int unit) const;

  private:
    GlTexture texture_;
    int rows_ = 0;
};

} // namespace gaspard
