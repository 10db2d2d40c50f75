// The functions of a Gl table, one after the other, with their names, to load it.
#pragma once

#include "gui/gl/gl.hpp"

namespace gaspard {

/// Calls visit(function pointer, "glName") for every entry.
template <class Visit>
void visit_gl_functions(Gl& gl, Visit visit) {
    visit(gl.ActiveTexture, "glActiveTexture");
    visit(gl.AttachShader, "glAttachShader");
    visit(gl.BindBuffer, "glBindBuffer");
    visit(gl.BindFramebuffer, "glBindFramebuffer");
    visit(gl.BindRenderbuffer, "glBindRenderbuffer");
    visit(gl.BindTexture, "glBindTexture");
    visit(gl.BindVertexArray, "glBindVertexArray");
    visit(gl.BlendEquation, "glBlendEquation");
    visit(gl.BlendFuncSeparate, "glBlendFuncSeparate");
    visit(gl.BlitFramebuffer, "glBlitFramebuffer");
    visit(gl.BufferData, "glBufferData");
    visit(gl.CheckFramebufferStatus, "glCheckFramebufferStatus");
    visit(gl.Clear, "glClear");
    visit(gl.ClearColor, "glClearColor");
    visit(gl.ClearDepth, "glClearDepth");
    visit(gl.ColorMask, "glColorMask");
    visit(gl.CompileShader, "glCompileShader");
    visit(gl.CreateProgram, "glCreateProgram");
    visit(gl.CreateShader, "glCreateShader");
    visit(gl.DeleteBuffers, "glDeleteBuffers");
    visit(gl.DeleteFramebuffers, "glDeleteFramebuffers");
    visit(gl.DeleteProgram, "glDeleteProgram");
    visit(gl.DeleteRenderbuffers, "glDeleteRenderbuffers");
    visit(gl.DeleteShader, "glDeleteShader");
    visit(gl.DeleteTextures, "glDeleteTextures");
    visit(gl.DeleteVertexArrays, "glDeleteVertexArrays");
    visit(gl.DepthFunc, "glDepthFunc");
    visit(gl.DepthMask, "glDepthMask");
    visit(gl.Disable, "glDisable");
    visit(gl.DrawArrays, "glDrawArrays");
    visit(gl.DrawElements, "glDrawElements");
    visit(gl.DrawElementsBaseVertex, "glDrawElementsBaseVertex");
    visit(gl.Enable, "glEnable");
    visit(gl.EnableVertexAttribArray, "glEnableVertexAttribArray");
    visit(gl.Finish, "glFinish");
    visit(gl.FramebufferRenderbuffer, "glFramebufferRenderbuffer");
    visit(gl.FramebufferTexture2D, "glFramebufferTexture2D");
    visit(gl.GenBuffers, "glGenBuffers");
    visit(gl.GenFramebuffers, "glGenFramebuffers");
    visit(gl.GenRenderbuffers, "glGenRenderbuffers");
    visit(gl.GenTextures, "glGenTextures");
    visit(gl.GenVertexArrays, "glGenVertexArrays");
    visit(gl.GetError, "glGetError");
    visit(gl.GetIntegerv, "glGetIntegerv");
    visit(gl.GetProgramInfoLog, "glGetProgramInfoLog");
    visit(gl.GetProgramiv, "glGetProgramiv");
    visit(gl.GetString, "glGetString");
    visit(gl.GetShaderInfoLog, "glGetShaderInfoLog");
    visit(gl.GetShaderiv, "glGetShaderiv");
    visit(gl.GetUniformLocation, "glGetUniformLocation");
    visit(gl.LinkProgram, "glLinkProgram");
    visit(gl.PixelStorei, "glPixelStorei");
    visit(gl.PolygonOffset, "glPolygonOffset");
    visit(gl.ReadPixels, "glReadPixels");
    visit(gl.RenderbufferStorage, "glRenderbufferStorage");
    visit(gl.RenderbufferStorageMultisample, "glRenderbufferStorageMultisample");
    visit(gl.Scissor, "glScissor");
    visit(gl.ShaderSource, "glShaderSource");
    visit(gl.TexImage2D, "glTexImage2D");
    visit(gl.TexParameteri, "glTexParameteri");
    visit(gl.TexSubImage2D, "glTexSubImage2D");
    visit(gl.Uniform1f, "glUniform1f");
    visit(gl.Uniform1i, "glUniform1i");
    visit(gl.Uniform2f, "glUniform2f");
    visit(gl.Uniform3f, "glUniform3f");
    visit(gl.Uniform4f, "glUniform4f");
    visit(gl.UniformMatrix4fv, "glUniformMatrix4fv");
    visit(gl.UseProgram, "glUseProgram");
    visit(gl.VertexAttribPointer, "glVertexAttribPointer");
    visit(gl.Viewport, "glViewport");
}

} // namespace gaspard
