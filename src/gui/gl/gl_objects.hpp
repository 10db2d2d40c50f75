// OpenGL's buffers, textures and programs as owned values: created by a constructor, deleted with their
// owner, never copied. They must be destroyed while their context is current.
#pragma once

#include "gui/gl/gl.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace gaspard {

/// One object of OpenGL. `make` and `destroy` are the functions of Gl that create and delete objects of its
/// kind, either several at a time (GenBuffers) or one (CreateProgram). Shaders, which are created with an
/// argument, have no `make` and are taken over by name.
template <auto make, auto destroy>
class GlObject {
  public:
    GlObject() = default;
    explicit GlObject(const Gl& gl) : gl_(&gl) {
        if constexpr (requires { (gl.*make)(1, &name_); })
            (gl.*make)(1, &name_);
        else
            name_ = (gl.*make)();
    }
    GlObject(const Gl& gl, GLuint name) : gl_(&gl), name_(name) {}
    GlObject(GlObject&& other) noexcept
        : gl_(std::exchange(other.gl_, nullptr)), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject() {
        if (name_ == 0) return;
        if constexpr (requires { (gl_->*destroy)(1, &name_); })
            (gl_->*destroy)(1, &name_);
        else
            (gl_->*destroy)(name_);
    }

    GLuint name() const { return name_; }

  private:
    const Gl* gl_ = nullptr;
    GLuint name_ = 0;
};

using GlBuffer = GlObject<&Gl::GenBuffers, &Gl::DeleteBuffers>;
using GlTexture = GlObject<&Gl::GenTextures, &Gl::DeleteTextures>;
using GlVertexArray = GlObject<&Gl::GenVertexArrays, &Gl::DeleteVertexArrays>;
using GlFramebuffer = GlObject<&Gl::GenFramebuffers, &Gl::DeleteFramebuffers>;
using GlRenderbuffer = GlObject<&Gl::GenRenderbuffers, &Gl::DeleteRenderbuffers>;
using GlShader = GlObject<nullptr, &Gl::DeleteShader>;
using GlProgram = GlObject<&Gl::CreateProgram, &Gl::DeleteProgram>;

/// Compiles and links shaders/<vertex>.vert with shaders/<fragment>.frag, which are embedded in the program.
/// Throws MachineError with the compiler's message.
GlProgram make_program(const Gl& gl, std::string_view vertex, std::string_view fragment);
inline GlProgram make_program(const Gl& gl, std::string_view name) { return make_program(gl, name, name); }

/// The location of a uniform; -1, which OpenGL ignores, if the compiler has removed it.
GLint uniform(const Gl& gl, const GlProgram& program, const char* name);

} // namespace gaspard
