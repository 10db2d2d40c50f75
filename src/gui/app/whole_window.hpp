// The image of the whole window, on a screen or in memory: the views of meshes, and over them everything
// else.
#pragma once

#include "core/io/image.hpp"
#include "gui/app/application.hpp"
#include "gui/gl/imgui_renderer.hpp"
#include "gui/gl/offscreen.hpp"
#include "gui/render/mesh_renderer.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

/// Of a framebuffer: its size in pixels, and how many of them a unit of the window has.
struct WindowPixels {
    int width = 0, height = 0;
    float density = 1;
    std::optional<int> top{}; ///< of a strip of an image: how many rows of the window are above it
};

/// A part of the window in pixels of the framebuffer.
PixelRect pixels_of(const ItemRectangle& part, float density);

/// How the meshes of a frame are drawn.
struct Drawing {
    bool quickly = false; ///< with one sample a pixel
    bool keep = false;    ///< meshes that only moved, seen from the same places, stay as they were drawn
    bool finish = true;   ///< what was drawn quickly and has not changed is drawn in full
};

/// The image of the window, drawn in memory first. So it is equal with and without a screen (a window's own
/// framebuffer may have the opposite order of rows, which rounds positions between pixels differently), and
/// unchanged meshes are not drawn again below an open menu.
class WindowImage {
  public:
    /// `gl` must outlive it and be current whenever it is used and when it dies.
    explicit WindowImage(const Gl& gl) : gl_(gl), meshes_(gl), interface_(gl) {}

    struct Outcome {
        bool anew = false;     ///< the meshes were redrawn
        bool complete = false; ///< they are as they should be, in full
    };
    /// Draws the frame that ImGui has just rendered, and the meshes below it. `zoom`: units of the window per
    /// unit of the theme.
    Outcome draw(const Application& application, const WindowPixels& pixels, float zoom,
                 const Drawing& drawing = {});
    void show() const { whole_->show(); } ///< in the window, after draw()
    Image read() const { return whole_->read(); }
    ImGuiRenderer& interface() { return interface_; }

  private:
    /// What the image of the meshes depends on.
    struct Below {
        std::vector<ShownView> views;
        std::string theme;
        float density = 1, zoom = 1;
        std::optional<int> top{};
        friend bool operator==(const Below&, const Below&) = default;
    };
    static bool only_moved(const Below& drawn, const Below& wanted);
    void draw_meshes(const Application& application, const WindowPixels& pixels, float zoom,
                     RenderTarget& target);

    const Gl& gl_;
    MeshRenderers meshes_;
    ImGuiRenderer interface_;
    std::optional<RenderTarget> below_, draft_, whole_; ///< the meshes, in full or quickly; all
    std::optional<Below> drawn_;                        ///< what below_ or draft_ shows
    bool full_ = true;                                  ///< below_ does
};

/// The window showing a finished run, drawn offscreen. Throws MachineError if there is no OpenGL.
Image render_whole_window(std::shared_ptr<const Catalogue> catalogue, const FinishedRun& run, int width,
                          int height, const Settings& settings = {},
                          OffscreenBackend backend = OffscreenBackend::any);

} // namespace gaspard
