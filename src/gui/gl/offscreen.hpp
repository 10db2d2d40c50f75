// OpenGL without a window: a context in memory, and images of any size drawn in it.
//
// Two backends, both loaded at run time, so that the program starts without them: OSMesa (libOSMesa.so.8 or
// .so.6), and EGL without a surface (libEGL.so.1), the only one with a Mesa newer than 25.0.
#pragma once

#include "core/io/image.hpp"
#include "gui/gl/gl_objects.hpp"
#include "gui/gl/pixel_rect.hpp"

#include <memory>
#include <string_view>

namespace gaspard {

enum class OffscreenBackend { any, osmesa, egl };

/// A context that is current on the thread that made it, for as long as it lives. One at a time per thread.
class OffscreenContext {
  public:
    virtual ~OffscreenContext() = default;
    virtual const Gl& gl() const = 0;
    virtual std::string_view backend() const = 0; ///< "OSMesa" or "EGL"
};

/// Throws InputError if GASPARD_OFFSCREEN names no backend; to be called before long work.
void check_offscreen_choice();
/// `any` uses the backend that the environment variable GASPARD_OFFSCREEN names (`osmesa` or `egl`); without
/// it, OSMesa if it is installed, else EGL. Throws MachineError with one sentence if none works, InputError
/// if the variable names another backend.
std::unique_ptr<OffscreenContext> make_offscreen_context(OffscreenBackend backend = OffscreenBackend::any);

/// How often a pixel is looked at, for smooth rims of surfaces.
inline constexpr int image_samples = 4;

/// An image to draw into, with depth, and with several samples a pixel (0 for one) where the machine can.
class RenderTarget {
  public:
    /// Throws MachineError where the machine cannot make one of this size.
    RenderTarget(const Gl& gl, int width, int height, int samples = image_samples);
    void bind() const; ///< drawing goes here; sets the viewport to all of it
    /// Takes over what was drawn into another of the same size, with as many samples or into one.
    void copy(const RenderTarget& from) const { copy(from, {0, 0, width_, height_}); }
    void copy(const RenderTarget& from, PixelRect part) const; ///< with as many samples
    /// Puts what was drawn in another one, or an image, with its upper left corner there; what does not fit
    /// is cut off. Both have one sample a pixel.
    void put(const RenderTarget& from, int x, int y) const;
    void put(const Image& image, int x, int y) const;
    /// Puts the image into the window's own framebuffer, which is bound afterwards.
    void show() const;
    Image read() const;
    int width() const { return width_; }
    int height() const { return height_; }

  private:
    void blit(const GlFramebuffer& from, GLuint to, PixelRect part) const;
    const Gl* gl_;
    int width_, height_, samples_;
    GlFramebuffer drawn_, resolved_;
    GlRenderbuffer colour_, depth_, resolved_colour_;
};

} // namespace gaspard
