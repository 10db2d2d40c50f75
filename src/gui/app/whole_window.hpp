// The image of the whole window, on a screen or in memory: the views of meshes, and over them everything
// else.
#pragma once

#include "core/io/image.hpp"
#include "gui/app/application.hpp"
#include "gui/app/mesh_painter.hpp"
#include "gui/gl/draw_changes.hpp"
#include "gui/gl/imgui_renderer.hpp"
#include "gui/gl/offscreen.hpp"

#include <memory>
#include <optional>

namespace gaspard {

/// The meshes that the application shows.
MeshesToDraw meshes_to_draw(const Application& application, const WindowPixels& pixels, float zoom);

/// The image of the window, drawn in memory first. So it is equal with and without a screen: a window's own
/// framebuffer may have the opposite order of rows, which rounds positions between pixels differently.
class WindowImage {
  public:
    /// `gl` must outlive it and be current whenever it is used and when it dies.
    explicit WindowImage(const Gl& gl) : gl_(gl), interface_(gl) {}

    /// The size of the window, and the colour where there are no meshes.
    void resize(int width, int height, Colour ground);
    /// Meshes that were drawn in this context, of this area; or elsewhere.
    void take(const MeshImage& meshes, PixelRect area);
    void take(const PaintedMeshes& meshes);
    /// There are none to show.
    void forget_meshes();
    /// Draws the frame that ImGui has just rendered over the meshes; only what has changed is drawn. False if
    /// nothing has.
    bool draw(const WindowPixels& pixels);
    /// Everything has changed, as with another font.
    void draw_all_anew();
    void show() const { whole_->show(); } ///< in the window, after draw()
    Image read() const { return whole_->read(); }
    ImGuiRenderer& interface() { return interface_; }

  private:
    void clear_below();
    void make_place_for(PixelRect meshes);
    const Gl& gl_;
    ImGuiRenderer interface_;
    std::optional<RenderTarget> below_, whole_; ///< the meshes; all
    Colour ground_;
    DrawChanges changes_;
    PixelRect meshes_;  ///< where below_ shows some
    PixelRect changed_; ///< of below_, since the last frame
};

/// The window showing a finished run, drawn offscreen. Throws MachineError if there is no OpenGL.
Image render_whole_window(std::shared_ptr<const Catalogue> catalogue, const FinishedRun& run, int width,
                          int height, const Settings& settings = {},
                          OffscreenBackend backend = OffscreenBackend::any);

} // namespace gaspard
