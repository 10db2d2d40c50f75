// A viewport as part of the window: the picture of its run's newest snapshot, the camera that mouse and wheel
// steer, what the mouse picks, and the legend on top. All of it are ImGui calls and values; whoever has
// OpenGL draws the pictures it asks for.
//
// What one looks at and from where are values of the viewport's view (core/scenario/view_rows.hpp), nothing
// else: the camera and the pick are texts there, which the mouse rewrites.
#pragma once

#include "gui/base/frame_context.hpp"
#include "gui/document/document.hpp"
#include "gui/viewport/handles.hpp"
#include "gui/viewport/viewport.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {

/// A mesh to be drawn: what, from where, and where it belongs, in window coordinates.
struct ShownView {
    MeshScene scene;
    Camera camera; ///< speaks of the size of `rectangle`
    ItemRectangle rectangle;
    friend bool operator==(const ShownView&, const ShownView&) = default;
};

class ViewportPane {
  public:
    explicit ViewportPane(std::shared_ptr<TessellationCache> cache) : planner_(std::move(cache)) {}

    /// Draws all but the meshes into a window of its own that fills `area`.
    /// `others`: runs whose meshes are to be seen beside it, where the view's layout is "runs".
    void frame(const DocumentRun& run, DocumentViewport& viewport, const ItemRectangle& area,
               const FrameContext& context, const std::vector<const DocumentRun*>& others = {});
    /// Shows the whole mesh again, however the viewport's size changes, from the view's direction.
    void go_home(DocumentViewport& viewport);
    /// Home is from now on for the mesh that is shown next.
    void forget_home() { planner_.forget_home(); }
    /// The present camera as text, also where the view's is empty; empty before the first snapshot.
    std::string camera_text() const;
    /// A mesh that has turned by itself is shown as the view says again.
    void stop_turning() { spun_ = 0; }
    /// Takes a camera's text as that of what is shown.
    void look_as(DocumentViewport& viewport, const std::string& camera);
    /// What the next frames say in the lower left corner.
    void say_in_corner(std::string note) { note_ = std::move(note); }
    /// The handles of the next frames; the mouse may take hold of them.
    void offer_handles(std::vector<Handle> handles) { handles_ = std::move(handles); }
    struct HandleMove {
        Handle handle;
        Vec3 place; ///< where it is to be now
    };
    /// What the mouse has done to one since the last call.
    std::optional<HandleMove> take_handle_move() { return std::exchange(handle_move_, std::nullopt); }
    /// The mesh turns by itself: the next frame differs from this one.
    bool spinning() const { return spinning_; }
    /// Choices of the view that what is shown has not, as "layout=map".
    std::vector<std::string> unavailable() const {
        return plan_ ? plan_->unavailable : std::vector<std::string>();
    }
    /// The view's range becomes fixed, to what the colours span now.
    void fix_range(DocumentViewport& viewport) const;
    /// What the last frame asked for; empty before the first snapshot.
    const std::vector<ShownView>& views() const { return views_; }

  private:
    void steer(Values& view, float scale);
    void turn(Values& view);
    void drag(Values& view, const PlannedView& shown, int button, ImVec2 step);
    void click(Values& view, const PlannedView& shown, Pixel pointer, float scale);
    std::optional<Pixel> seen(const Handle& handle, const PlannedView& shown) const;
    std::optional<std::size_t> handle_at(ImVec2 at, float scale) const;
    bool drag_handle(float scale);
    void draw_handles(const FrameContext& context);
    void set_camera(Values& view, const PlannedView& shown, Camera camera);

    ViewportPlanner planner_;
    std::optional<ViewportPlan> plan_; ///< of the last frame
    std::vector<ShownView> views_;
    std::string note_;
    std::vector<Handle> handles_;
    std::optional<std::size_t> held_; ///< handle under the pressed button
    std::optional<HandleMove> handle_move_;
    bool dragging_ = false;
    bool spinning_ = false;
    double spun_ = 0;           ///< in radians, since the view's camera was last set
    std::string spun_from_;     ///< what the view said of its camera then
    std::string picked_before_; ///< view.pick before the last click, which may be the first of two
};

} // namespace gaspard
