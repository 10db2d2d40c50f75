#include "gui/render/line_layer.hpp"

#include "core/base/error.hpp"

#include <string>

namespace gaspard {

LineLayer::LineLayer(const Gl& gl)
    : gl_(gl), program_(make_program(gl, "line_layer")), corner_(uniform(gl, program_, "corner")),
      light_ink_(uniform(gl, program_, "light_ink")), dark_ink_(uniform(gl, program_, "dark_ink")),
      empty_array_(gl), framebuffer_(gl), ink_(gl), depth_(gl) {
    gl.UseProgram(program_.name());
    gl.Uniform1i(uniform(gl, program_, "ink"), 0);
}

void LineLayer::resize(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, ink_.name());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RG8, width, height, 0, GL_RG, GL_UNSIGNED_BYTE, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, ink_.name(), 0);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw MachineError("this machine's OpenGL cannot draw lines in an area of " + std::to_string(width) +
                           " x " + std::to_string(height) + " pixels");
}

void LineLayer::begin(int width, int height) {
    gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    resize(width, height);
    gl_.Viewport(0, 0, width, height);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.ClearDepth(1);
    gl_.DepthMask(GL_TRUE);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_MAX);
}

void LineLayer::end(int x, int y, Colour light_ink, Colour dark_ink) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before_));
    gl_.Viewport(x, y, width_, height_);
    gl_.Scissor(x, y, width_, height_);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.UseProgram(program_.name());
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, ink_.name());
    gl_.Uniform2f(corner_, static_cast<float>(x), static_cast<float>(y));
    gl_.Uniform4f(light_ink_, light_ink.r, light_ink.g, light_ink.b, light_ink.a);
    gl_.Uniform4f(dark_ink_, dark_ink.r, dark_ink.g, dark_ink.b, dark_ink.a);
    gl_.BindVertexArray(empty_array_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace gaspard
