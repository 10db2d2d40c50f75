// OpenGL's buffers, textures and programs as owned values: made in a constructor, deleted with their owner,
// never copied. They must die while their context is current.
#pragma once

#include "gui/gl/gl.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace gaspard {

/// One object of OpenGL. `Kind` only tells the compiler that a texture is not a buffer.
template <class Kind>
class GlObject {
  public:
    GlObject() = default;
    explicit GlObject(const Gl& gl) : gl_(&gl), name_(Kind::make(gl)) {}
    GlObject(const Gl& gl, GLuint name) : gl_(&gl), name_(name) {}
    GlObject(GlObject&& other) noexcept
        : gl_(std::exchange(other.gl_, nullptr)), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject() {
        if (name_ != 0) Kind::destroy(*gl_, name_);
    }

    GLuint name() const { return name_; }

  private:
    const Gl* gl_ = nullptr;
    GLuint name_ = 0;
};

struct BufferKind {
    static GLuint make(const Gl& gl);
    static void destroy(const Gl& gl, GLuint name);
};
struct TextureKind {
    static GLuint make(const Gl& gl);
    static void destroy(const Gl& gl, GLuint name);
};
struct VertexArrayKind {
    static GLuint make(const Gl& gl);
    static void destroy(const Gl& gl, GLuint name);
};
struct FramebufferKind {
    static GLuint make(const Gl& gl);
    static void destroy(const Gl& gl, GLuint name);
};
struct RenderbufferKind {
    static GLuint make(const Gl& gl);
    static void destroy(const Gl& gl, GLuint name);
};
struct ShaderKind {
    static void destroy(const Gl& gl, GLuint name);
};
struct ProgramKind {
    static GLuint make(const Gl& gl);
    static void destroy(const Gl& gl, GLuint name);
};

using GlBuffer = GlObject<BufferKind>;
using GlTexture = GlObject<TextureKind>;
using GlVertexArray = GlObject<VertexArrayKind>;
using GlFramebuffer = GlObject<FramebufferKind>;
using GlRenderbuffer = GlObject<RenderbufferKind>;
using GlShader = GlObject<ShaderKind>;
using GlProgram = GlObject<ProgramKind>;

/// Compiles and links shaders/<vertex>.vert with shaders/<fragment>.frag, which are embedded in the program.
/// Throws MachineError with the compiler's words.
GlProgram make_program(const Gl& gl, std::string_view vertex, std::string_view fragment);
inline GlProgram make_program(const Gl& gl, std::string_view name) { return make_program(gl, name, name); }

/// Where a uniform of a program is; -1 (which OpenGL ignores) where the compiler dropped it.
GLint uniform(const Gl& gl, const GlProgram& program, const char* name);

} // namespace gaspard
