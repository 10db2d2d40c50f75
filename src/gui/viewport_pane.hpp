// A viewport as part of the window: the picture of its run's newest snapshot, the camera that mouse and wheel
// steer, and the legend on top. All of it are ImGui calls and values; whoever has OpenGL draws the
// pictures it asks for.
#pragma once

#include "gui/document.hpp"
#include "gui/item_rectangles.hpp"
#include "gui/mesh_picture.hpp"
#include "gui/theme.hpp"

#include <memory>
#include <vector>

namespace gaspard {

/// A mesh to be drawn: what, from where, and where it belongs, in window coordinates.
struct ShownPicture {
    MeshPicture picture;
    Camera camera; ///< speaks of the size of `rectangle`
    ItemRectangle rectangle;
};

/// How things are drawn in this frame, and where it is noted what stands where.
struct FrameContext {
    const Theme& theme;
    float scale = 1; ///< how much larger than the theme says everything is
    ItemRectangles& items;
};

class ViewportPane {
  public:
    /// Draws all but the meshes into a window of its own that fills `area`.
    void frame(const DocumentRun& run, DocumentViewport& viewport, const ItemRectangle& area,
               const FrameContext& context);
    /// Shows the whole mesh again, however the viewport's size changes.
    void go_home(DocumentViewport& viewport);
    /// What the last frame asked for; empty before the first snapshot.
    const std::vector<ShownPicture>& pictures() const { return pictures_; }

  private:
    void draw_picture(const DocumentRun& run, DocumentViewport& viewport, const ItemRectangle& area,
                      const FrameContext& context);
    void steer_camera(DocumentViewport& viewport, const ItemRectangle& area, const MeshPicture& picture);

    PictureMaker maker_;
    std::vector<ShownPicture> pictures_;
    Camera home_; ///< the whole mesh, for this size of the viewport
    Size home_size_;
    std::shared_ptr<const Tessellation> home_of_;
};

} // namespace gaspard
