#include "gui/gl/offscreen.hpp"

#include "core/base/check.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <dlfcn.h>
#include <initializer_list>
#include <string>
#include <vector>

namespace gaspard {

namespace {

/// A shared library opened at run time.
class Library {
  public:
    explicit Library(std::initializer_list<const char*> names) {
        for (const char* name : names) {
            handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
            if (handle_ != nullptr) return;
        }
        throw MachineError(std::string(*names.begin()) + " is not installed");
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    // Not closed: Mesa leaves thread-local destructors behind, which must not outlive their code.
    ~Library() = default;

    template <class Function>
    Function find(const char* name) const {
        void* address = dlsym(handle_, name);
        if (address == nullptr) throw MachineError(std::string("the function ") + name + " is missing");
        return reinterpret_cast<Function>(address);
    }

  private:
    void* handle_ = nullptr;
};

// What we use of OSMesa's interface (GL/osmesa.h), declared here because Mesa has dropped OSMesa after 25.0:
// the program is built the same way with and without it.
using OsMesaContext = struct osmesa_context*;
enum OsMesaAttribute : int {
    osmesa_format = 0x22,
    osmesa_depth_bits = 0x30,
    osmesa_profile = 0x33,
    osmesa_core_profile = 0x34,
    osmesa_context_major_version = 0x36,
    osmesa_context_minor_version = 0x37,
};

class OsMesa : public OffscreenContext {
  public:
    OsMesa() : library_({"libOSMesa.so.8", "libOSMesa.so.6"}) {
        const auto create =
            library_.find<OsMesaContext (*)(const int*, OsMesaContext)>("OSMesaCreateContextAttribs");
        const auto make_current =
            library_.find<GLboolean (*)(OsMesaContext, void*, GLenum, GLsizei, GLsizei)>("OSMesaMakeCurrent");
        const auto lookup = library_.find<void (*(*)(const char*))()>("OSMesaGetProcAddress");
        destroy_ = library_.find<void (*)(OsMesaContext)>("OSMesaDestroyContext");
        const std::array<int, 11> attributes = {osmesa_format,
                                                GL_RGBA,
                                                osmesa_depth_bits,
                                                0,
                                                osmesa_profile,
                                                osmesa_core_profile,
                                                osmesa_context_major_version,
                                                3,
                                                osmesa_context_minor_version,
                                                3,
                                                0};
        context_ = create(attributes.data(), nullptr);
        if (context_ == nullptr) throw MachineError("OSMesa offers no OpenGL 3.3 core context");
        try {
            // The context's own buffer is not used: we draw into framebuffer objects.
            if (make_current(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE)
                throw MachineError("OSMesa cannot make its context current");
            gl_ = load_gl([&](const char* name) { return reinterpret_cast<void*>(lookup(name)); });
        } catch (...) {
            destroy_(context_);
            throw;
        }
    }
    ~OsMesa() override { destroy_(context_); }
    OsMesa(const OsMesa&) = delete;
    OsMesa& operator=(const OsMesa&) = delete;

    const Gl& gl() const override { return gl_; }
    std::string_view backend() const override { return "OSMesa"; }

  private:
    Library library_;
    void (*destroy_)(OsMesaContext) = nullptr;
    OsMesaContext context_ = nullptr;
    std::array<unsigned char, 4> pixel_{};
    Gl gl_;
};

class SurfacelessEgl : public OffscreenContext {
  public:
    SurfacelessEgl() : library_({"libEGL.so.1"}) {
        const auto lookup = library_.find<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress");
        terminate_ = library_.find<PFNEGLTERMINATEPROC>("eglTerminate");
        make_current_ = library_.find<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
        destroy_ = library_.find<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext");
        display_ = open_display(lookup);
        try {
            context_ = create_context();
            if (make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
                throw MachineError("EGL cannot make its context current");
            gl_ = load_gl([&](const char* name) { return reinterpret_cast<void*>(lookup(name)); });
        } catch (...) {
            close();
            throw;
        }
    }
    ~SurfacelessEgl() override { close(); }
    SurfacelessEgl(const SurfacelessEgl&) = delete;
    SurfacelessEgl& operator=(const SurfacelessEgl&) = delete;

    const Gl& gl() const override { return gl_; }
    std::string_view backend() const override { return "EGL"; }

  private:
    EGLDisplay open_display(PFNEGLGETPROCADDRESSPROC lookup) const {
        const auto get_display =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(lookup("eglGetPlatformDisplayEXT"));
        if (get_display == nullptr) throw MachineError("EGL cannot open a display without a screen");
        const auto initialize = library_.find<PFNEGLINITIALIZEPROC>("eglInitialize");
        EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        EGLint major = 0, minor = 0;
        if (display == EGL_NO_DISPLAY || initialize(display, &major, &minor) == EGL_FALSE)
            throw MachineError("EGL cannot open a display without a screen");
        return display;
    }

    EGLContext create_context() const {
        const auto bind_api = library_.find<PFNEGLBINDAPIPROC>("eglBindAPI");
        const auto choose = library_.find<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig");
        const auto create = library_.find<PFNEGLCREATECONTEXTPROC>("eglCreateContext");
        const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                              EGL_NONE};
        EGLConfig config = nullptr;
        EGLint found = 0;
        if (bind_api(EGL_OPENGL_API) == EGL_FALSE ||
            choose(display_, wanted.data(), &config, 1, &found) == EGL_FALSE || found == 0)
            throw MachineError("EGL offers no OpenGL");
        const std::array<EGLint, 7> version = {EGL_CONTEXT_MAJOR_VERSION,
                                               3,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               3,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_NONE};
        EGLContext context = create(display_, config, EGL_NO_CONTEXT, version.data());
        if (context == EGL_NO_CONTEXT) throw MachineError("EGL offers no OpenGL 3.3 core context");
        return context;
    }

    void close() {
        make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) destroy_(display_, context_);
        terminate_(display_);
    }

    Library library_;
    PFNEGLTERMINATEPROC terminate_ = nullptr;
    PFNEGLMAKECURRENTPROC make_current_ = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroy_ = nullptr;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    Gl gl_;
};

} // namespace

namespace {

OffscreenBackend chosen_by_user() {
    const char* variable = std::getenv("GASPARD_OFFSCREEN");
    const std::string_view name = variable == nullptr ? "" : variable;
    if (name.empty()) return OffscreenBackend::any;
    if (name == "osmesa") return OffscreenBackend::osmesa;
    if (name == "egl") return OffscreenBackend::egl;
    throw InputError("the environment variable GASPARD_OFFSCREEN is \"" + std::string(name) +
                     "\"; allowed: osmesa, egl");
}

} // namespace

void check_offscreen_choice() { chosen_by_user(); }

std::unique_ptr<OffscreenContext> make_offscreen_context(OffscreenBackend backend) {
    if (backend == OffscreenBackend::any) backend = chosen_by_user();
    std::string reasons;
    if (backend != OffscreenBackend::egl) {
        try {
            return std::make_unique<OsMesa>();
        } catch (const MachineError& error) {
            reasons = error.what();
        }
    }
    if (backend != OffscreenBackend::osmesa) {
        try {
            return std::make_unique<SurfacelessEgl>();
        } catch (const MachineError& error) {
            reasons += (reasons.empty() ? "" : "; ") + std::string(error.what());
        }
    }
    throw MachineError("cannot draw images without a display, because no OpenGL is available: " + reasons);
}

RenderTarget::RenderTarget(const Gl& gl, int width, int height, int samples)
    : gl_(&gl), width_(width), height_(height), samples_(samples), drawn_(gl), resolved_(gl), colour_(gl),
      depth_(gl), resolved_colour_(gl) {
    GASPARD_CHECK(width > 0 && height > 0 && samples >= 0);
    GLint largest = 0, most_samples = 0;
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    gl.GetIntegerv(GL_MAX_SAMPLES, &most_samples);
    if (std::max(width, height) > largest)
        throw MachineError("this machine's OpenGL draws images of at most " + std::to_string(largest) +
                           " pixels a side");
    const auto attach = [&](const GlRenderbuffer& buffer, GLenum point, GLenum format, GLint count) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.name());
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, count, format, width, height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer.name());
    };
    const auto check = [&] {
        if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw MachineError("this machine's OpenGL cannot draw an image of " + std::to_string(width) +
                               " x " + std::to_string(height) + " pixels");
    };
    gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
    attach(resolved_colour_, GL_COLOR_ATTACHMENT0, GL_RGBA8, 0);
    check();
    gl.BindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
    attach(colour_, GL_COLOR_ATTACHMENT0, GL_RGBA8, std::min(samples, most_samples));
    attach(depth_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, std::min(samples, most_samples));
    check();
}

void RenderTarget::bind() const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
    gl_->Viewport(0, 0, width_, height_);
}

void RenderTarget::blit(const GlFramebuffer& from, GLuint to, PixelRect part) const {
    gl_->Disable(GL_SCISSOR_TEST); // it would clip the copy
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    const int right = part.x + part.width, top = height_ - part.y, bottom = top - part.height;
    gl_->BlitFramebuffer(part.x, bottom, right, top, part.x, bottom, right, top, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
}

void RenderTarget::copy(const RenderTarget& from, PixelRect part) const {
    GASPARD_CHECK(from.width_ == width_ && from.height_ == height_);
    blit(from.drawn_, drawn_.name(), part);
}

void RenderTarget::put(const Image& image, int x, int y) const {
    const GlTexture texture(*gl_);
    const GlFramebuffer from(*gl_);
    gl_->ActiveTexture(GL_TEXTURE0);
    gl_->BindTexture(GL_TEXTURE_2D, texture.name());
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    image.rgba.data());
    gl_->BindFramebuffer(GL_FRAMEBUFFER, from.name());
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, drawn_.name());
    const int width = std::min(width_ - x, image.width), height = std::min(height_ - y, image.height);
    if (width <= 0 || height <= 0) return;
    const int top = height_ - y; // OpenGL's rows run from bottom to top
    gl_->BlitFramebuffer(0, height, width, 0, x, top - height, x + width, top, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
}

void RenderTarget::put(const RenderTarget& from, int x, int y) const {
    GASPARD_CHECK(samples_ == 0 && from.samples_ == 0);
    const int width = std::min(width_ - x, from.width_), height = std::min(height_ - y, from.height_);
    if (width <= 0 || height <= 0) return;
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, from.drawn_.name());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, drawn_.name());
    const int top = height_ - y, from_top = from.height_;
    gl_->BlitFramebuffer(0, from_top - height, width, from_top, x, top - height, x + width, top,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void RenderTarget::show() const {
    if (samples_ > 0)
        blit(drawn_, resolved_.name(), {0, 0, width_, height_}); // formats must agree to resolve samples
    blit(samples_ > 0 ? resolved_ : drawn_, 0, {0, 0, width_, height_});
    gl_->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

Image RenderTarget::read() const {
    blit(drawn_, resolved_.name(), {0, 0, width_, height_});
    gl_->BindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
    const auto row = static_cast<std::size_t>(width_) * 4;
    Image image{width_, height_, std::vector<std::uint8_t>(row * static_cast<std::size_t>(height_))};
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_->ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    // OpenGL's rows run from bottom to top.
    for (std::size_t top = 0, bottom = static_cast<std::size_t>(height_) - 1; top < bottom; ++top, --bottom)
        std::swap_ranges(image.rgba.begin() + static_cast<std::ptrdiff_t>(top * row),
                         image.rgba.begin() + static_cast<std::ptrdiff_t>((top + 1) * row),
                         image.rgba.begin() + static_cast<std::ptrdiff_t>(bottom * row));
    return image;
}

} // namespace gaspard
