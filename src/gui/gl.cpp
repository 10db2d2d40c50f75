#include "gui/gl.hpp"

#include "core/base/error.hpp"

#include <string>

namespace gaspard {

namespace {

template <class Function>
void load(const GlLookup& lookup, Function& function, const char* name) {
    void* address = lookup(name);
    if (address == nullptr)
        throw MachineError(std::string("this machine's OpenGL lacks the function ") + name +
                           "; Gaspard needs OpenGL 3.3 or newer");
    function = reinterpret_cast<Function>(address);
}

void require_version(const Gl& gl) {
    GLint major = 0, minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 33)
        throw MachineError("this machine offers OpenGL " + std::to_string(major) + "." +
                           std::to_string(minor) + "; Gaspard needs 3.3 or newer");
}

} // namespace

Gl load_gl(const GlLookup& lookup) {
    Gl gl;
    load(lookup, gl.ActiveTexture, "glActiveTexture");
    load(lookup, gl.AttachShader, "glAttachShader");
    load(lookup, gl.BindBuffer, "glBindBuffer");
    load(lookup, gl.BindFramebuffer, "glBindFramebuffer");
    load(lookup, gl.BindRenderbuffer, "glBindRenderbuffer");
    load(lookup, gl.BindTexture, "glBindTexture");
    load(lookup, gl.BindVertexArray, "glBindVertexArray");
    load(lookup, gl.BlendEquation, "glBlendEquation");
    load(lookup, gl.BlendFuncSeparate, "glBlendFuncSeparate");
    load(lookup, gl.BlitFramebuffer, "glBlitFramebuffer");
    load(lookup, gl.BufferData, "glBufferData");
    load(lookup, gl.BufferSubData, "glBufferSubData");
    load(lookup, gl.CheckFramebufferStatus, "glCheckFramebufferStatus");
    load(lookup, gl.Clear, "glClear");
    load(lookup, gl.ClearColor, "glClearColor");
    load(lookup, gl.ClearDepth, "glClearDepth");
    load(lookup, gl.ColorMask, "glColorMask");
    load(lookup, gl.CompileShader, "glCompileShader");
    load(lookup, gl.CreateProgram, "glCreateProgram");
    load(lookup, gl.CreateShader, "glCreateShader");
    load(lookup, gl.DeleteBuffers, "glDeleteBuffers");
    load(lookup, gl.DeleteFramebuffers, "glDeleteFramebuffers");
    load(lookup, gl.DeleteProgram, "glDeleteProgram");
    load(lookup, gl.DeleteRenderbuffers, "glDeleteRenderbuffers");
    load(lookup, gl.DeleteShader, "glDeleteShader");
    load(lookup, gl.DeleteTextures, "glDeleteTextures");
    load(lookup, gl.DeleteVertexArrays, "glDeleteVertexArrays");
    load(lookup, gl.DepthFunc, "glDepthFunc");
    load(lookup, gl.DepthMask, "glDepthMask");
    load(lookup, gl.Disable, "glDisable");
    load(lookup, gl.DrawArrays, "glDrawArrays");
    load(lookup, gl.DrawElements, "glDrawElements");
    load(lookup, gl.DrawElementsBaseVertex, "glDrawElementsBaseVertex");
    load(lookup, gl.Enable, "glEnable");
    load(lookup, gl.EnableVertexAttribArray, "glEnableVertexAttribArray");
    load(lookup, gl.Finish, "glFinish");
    load(lookup, gl.FramebufferRenderbuffer, "glFramebufferRenderbuffer");
    load(lookup, gl.FramebufferTexture2D, "glFramebufferTexture2D");
    load(lookup, gl.GenBuffers, "glGenBuffers");
    load(lookup, gl.GenFramebuffers, "glGenFramebuffers");
    load(lookup, gl.GenRenderbuffers, "glGenRenderbuffers");
    load(lookup, gl.GenTextures, "glGenTextures");
    load(lookup, gl.GenVertexArrays, "glGenVertexArrays");
    load(lookup, gl.GetError, "glGetError");
    load(lookup, gl.GetIntegerv, "glGetIntegerv");
    load(lookup, gl.GetProgramInfoLog, "glGetProgramInfoLog");
    load(lookup, gl.GetProgramiv, "glGetProgramiv");
    load(lookup, gl.GetShaderInfoLog, "glGetShaderInfoLog");
    load(lookup, gl.GetShaderiv, "glGetShaderiv");
    load(lookup, gl.GetString, "glGetString");
    load(lookup, gl.GetUniformLocation, "glGetUniformLocation");
    load(lookup, gl.LinkProgram, "glLinkProgram");
    load(lookup, gl.PixelStorei, "glPixelStorei");
    load(lookup, gl.PolygonOffset, "glPolygonOffset");
    load(lookup, gl.ReadBuffer, "glReadBuffer");
    load(lookup, gl.ReadPixels, "glReadPixels");
    load(lookup, gl.RenderbufferStorage, "glRenderbufferStorage");
    load(lookup, gl.RenderbufferStorageMultisample, "glRenderbufferStorageMultisample");
    load(lookup, gl.Scissor, "glScissor");
    load(lookup, gl.ShaderSource, "glShaderSource");
    load(lookup, gl.TexImage2D, "glTexImage2D");
    load(lookup, gl.TexParameteri, "glTexParameteri");
    load(lookup, gl.TexSubImage2D, "glTexSubImage2D");
    load(lookup, gl.Uniform1f, "glUniform1f");
    load(lookup, gl.Uniform1i, "glUniform1i");
    load(lookup, gl.Uniform2f, "glUniform2f");
    load(lookup, gl.Uniform3f, "glUniform3f");
    load(lookup, gl.Uniform4f, "glUniform4f");
    load(lookup, gl.UniformMatrix4fv, "glUniformMatrix4fv");
    load(lookup, gl.UseProgram, "glUseProgram");
    load(lookup, gl.VertexAttribPointer, "glVertexAttribPointer");
    load(lookup, gl.Viewport, "glViewport");
    require_version(gl);
    return gl;
}

} // namespace gaspard
