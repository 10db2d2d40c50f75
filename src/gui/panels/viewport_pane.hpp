// A viewport as part of the window: the view of its run's newest snapshot, the camera that mouse and wheel
// move, picking, and the legend on top. It consists of ImGui calls and values; the caller draws the meshes
// with OpenGL.
//
// All that the viewport shows is given by the values of its view (core/scenario/view_rows.hpp). Camera and
// pick are texts there, which the mouse changes.
#pragma once

#include "gui/base/frame_context.hpp"
#include "gui/document/document.hpp"
#include "gui/viewport/cut_handles.hpp"
#include "gui/viewport/handles.hpp"
#include "gui/viewport/legend_control.hpp"
#include "gui/viewport/section_control.hpp"
#include "gui/viewport/viewport.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {

/// A mesh to draw: its scene, its camera, and its place in window coordinates.
struct ShownView {
    MeshScene scene;
    Camera camera; ///< for a view of the size of `rectangle`
    ItemRectangle rectangle;
    friend bool operator==(const ShownView&, const ShownView&) = default;
};

/// A run and the iterate of it to show, which is null before the first.
struct ShownRun {
    const DocumentRun* run;
    std::shared_ptr<const Snapshot> snapshot;
    std::optional<ColourRange> range{}; ///< of the colours, instead of the automatic one of the iterate
    /// Iterates with which the plots of an interval are compared: their axes cover these, too.
    std::vector<std::shared_ptr<const Snapshot>> compared{};
};

/// What a run is called beside others, "Newton: 11 iterations, converged".
std::string title_among_others(const ShownRun& shown);

class ViewportPane {
  public:
    explicit ViewportPane(std::shared_ptr<TessellationCache> cache) : planner_(std::move(cache)) {}

    /// Draws all but the meshes, into an ImGui window that fills `area`. `others`: runs whose meshes are
    /// shown side by side with it in the layout "runs".
    void frame(const ShownRun& shown, DocumentViewport& viewport, const ItemRectangle& area,
               const FrameContext& context, const std::vector<ShownRun>& others = {});
    /// Shows the whole mesh from the view's direction, also when the size of the viewport changes.
    void go_home(DocumentViewport& viewport);
    /// The next mesh shown determines the home camera.
    void forget_home() { planner_.forget_home(); }
    /// Whether there was a snapshot to show.
    bool shows() const { return plan_.has_value(); }
    /// The plots of the last frame, of an interval; else empty.
    std::vector<PlannedPlot> plots() const { return plan_ ? plan_->plots : std::vector<PlannedPlot>(); }
    /// The present camera as text, also if the view's is empty; empty before the first snapshot, and of
    /// plots.
    std::string camera_text() const;
    /// Shows a mesh that has rotated by itself as the view says.
    void stop_turning() { spun_ = 0; }
    /// Sets the camera, given as text.
    void look_as(DocumentViewport& viewport, const std::string& camera);
    /// In the next frame the screen still shows these meshes, whose axes and marks are drawn with them; by
    /// default those of the frame.
    void stay_with(std::vector<ShownView> meshes) { on_screen_ = std::move(meshes); }
    /// The handles of the next frames, which the mouse can drag.
    void offer_handles(std::vector<Handle> handles);
    /// Whether the planes of a cut have handles in the next frames.
    void offer_cut_handles(bool offered) { offers_cut_ = offered; }
    struct HandleMove {
        Handle handle;
        Vec3 place; ///< its new place
    };
    /// The last drag of a handle since the last call.
    std::optional<HandleMove> take_handle_move() { return std::exchange(handle_move_, std::nullopt); }
    /// The mesh rotates by itself, or a part of it is on its way: the next frame differs from this one.
    bool changing() const { return spinning_ || planner_.awaits_section(); }
    /// Parts of a picture that take long follow later.
    void work_in_background() { planner_.work_in_background(); }
    /// Choices of the view that are not available for this mesh, such as "layout=projection".
    std::vector<std::string> unavailable() const {
        return plan_ ? plan_->unavailable : std::vector<std::string>();
    }
    /// Fixes the range of the colours, or of a plot's vertical axis, to the present one.
    void fix_range(DocumentViewport& viewport) const;
    /// Along the line of the view (view.section), of the last frame.
    Plot section_plot() { return plan_ ? section_plot_.plot(*plan_) : Plot(); }
    std::string section_csv() { return plan_ ? section_plot_.csv(*plan_) : std::string(); }
    /// The meshes of the last frame; empty before the first snapshot.
    const std::vector<ShownView>& views() const { return views_; }

  private:
    void draw_nets(const FrameContext& context) const;
    void draw_overlay(const FrameContext& context) const;
    void interact(Values& view, const ItemRectangle& area, const FrameContext& context);
    void draw_plots(const FrameContext& context);
    void say_too_small(const FrameContext& context) const;
    bool use_legend(Values& view, float scale);
    void draw_legend_control(Values& view, const FrameContext& context);
    void forget_zooms(const Values& view);
    void steer(Values& view, float scale);
    void turn(Values& view);
    void drag(Values& view, const PlannedView& shown, int button, ImVec2 step);
    void click(Values& view, const PlannedView& shown, Pixel pointer, float scale);
    std::optional<Pixel> seen(const Handle& handle, const PlannedView& shown) const;
    std::optional<std::size_t> handle_at(ImVec2 at, float scale) const;
    bool drag_handle(float scale);
    void draw_handles(const FrameContext& context);
    std::vector<CutHandle> cut_handles_in(const PlannedView& shown, float scale) const;
    std::optional<CutHandle> cut_handle_at(ImVec2 at, float scale) const;
    bool drag_cut(Values& view, float scale);
    void draw_cut(const FrameContext& context);
    void set_camera(Values& view, const PlannedView& shown, Camera camera);

    ViewportPlanner planner_;
    std::optional<ViewportPlan> plan_; ///< of the last frame
    std::vector<ColumnZoom> zooms_;    ///< of the plots, by column
    std::string x_axis_, y_axis_;      ///< what the view says of the axes that were zoomed
    std::vector<ShownView> views_, on_screen_;
    bool hides_active_ = false; ///< the meshes of all runs are shown, but the active run is hidden
    std::vector<Handle> handles_;
    std::optional<std::size_t> held_; ///< the handle being dragged
    std::optional<HandleMove> handle_move_;
    /// A handle of a plane that is being dragged, and the cut before.
    struct HeldCut {
        CutHandle handle;
        std::vector<CutWedge> before;
    };
    bool offers_cut_ = true;
    std::vector<CutWedge> cut_; ///< of the view in the last frame, where the mesh is solid
    std::optional<HeldCut> held_cut_;
    LegendControl legend_;
    SectionControl section_;
    SectionPlotMaker section_plot_;
    bool dragging_ = false;
    bool spinning_ = false;
    double spun_ = 0;           ///< rotation in radians since the view's camera was last set
    std::string spun_from_;     ///< camera and direction of the view at that time
    std::string picked_before_; ///< view.pick before the last click, which may be the first of two
};

} // namespace gaspard
