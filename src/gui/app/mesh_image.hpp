// The image of the meshes in the window, without what lies over them.
#pragma once

#include "gui/base/item_rectangles.hpp"
#include "gui/base/theme.hpp"
#include "gui/gl/offscreen.hpp"
#include "gui/panels/viewport_pane.hpp"
#include "gui/render/mesh_renderer.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace gaspard {

/// Of a framebuffer: its size in pixels, and how many of them a unit of the window has.
struct WindowPixels {
    int width = 0, height = 0;
    float density = 1;
    std::optional<int> top{}; ///< of a strip of an image: how many rows of the window are above it
    friend bool operator==(const WindowPixels&, const WindowPixels&) = default;
};

/// A part of the window in pixels of the framebuffer.
PixelRect pixels_of(const ItemRectangle& part, float density);

/// All that an image of meshes depends on.
struct MeshesToDraw {
    std::vector<ShownView> views;
    Theme theme;
    WindowPixels pixels;
    float zoom = 1; ///< units of the window per unit of the theme
    PixelRect area; ///< of the window, or of the strip: what the image shows
    friend bool operator==(const MeshesToDraw&, const MeshesToDraw&) = default;
};

/// Whether an image of one can be shown where the other is wanted, until that is drawn: meshes with as many
/// cells at the same places of the window, in the same theme.
bool in_same_place(const MeshesToDraw& one, const MeshesToDraw& other);

/// The smallest area with all views; one pixel if there are none.
PixelRect area_of_views(const std::vector<ShownView>& views, const WindowPixels& pixels);

/// Draws meshes into an image in memory, in full or quickly, with one sample a pixel.
class MeshImage {
  public:
    /// `gl` must outlive it and be current whenever it is used and when it dies.
    explicit MeshImage(const Gl& gl) : gl_(gl), meshes_(gl) {}
    /// False if `give_up`, asked now and then, said so; then the image is not to be used.
    bool draw(const MeshesToDraw& what, bool quickly = false, const std::function<bool()>& give_up = {});
    /// The last one drawn, with one sample a pixel.
    const RenderTarget& image() const { return *(full_ ? resolved_ : draft_); }

  private:
    const Gl& gl_;
    MeshRenderers meshes_;
    std::optional<RenderTarget> sampled_, resolved_, draft_;
    bool full_ = true;
};

} // namespace gaspard
