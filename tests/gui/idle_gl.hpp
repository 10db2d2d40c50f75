// An OpenGL that does nothing and takes no time: what remains is the cost of our own code.
#pragma once

#include "gui/gl/gl_functions.hpp"

namespace gaspard {

inline Gl idle_gl() {
    Gl gl;
    visit_gl_functions(gl,
                       []<class Result, class... Arguments>(Result (*&function)(Arguments...), const char*) {
                           function = [](Arguments...) -> Result { return Result(); };
                       });
    // What is asked for is there.
    gl.CreateShader = [](GLenum) -> GLuint { return 1; };
    gl.CreateProgram = []() -> GLuint { return 1; };
    gl.GetShaderiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
    gl.GetProgramiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
    gl.GetIntegerv = [](GLenum, GLint* value) { *value = 4; };
    gl.CheckFramebufferStatus = [](GLenum) -> GLenum { return GL_FRAMEBUFFER_COMPLETE; };
    return gl;
}

} // namespace gaspard
