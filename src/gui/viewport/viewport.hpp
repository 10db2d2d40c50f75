// How a viewport looks, in the window and in images: one mesh or two side by side, the legend of
// their colours, a caption, a card about what is picked; of an interval, plots instead of the mesh.
//
// A ViewportPlanner says what goes where; MeshRenderer draws the meshes; draw_viewport_overlay() draws the
// rest with an ImDrawList. Everything is in pixels of the current ImGui frame, and everything a user can
// choose comes from values of view_rows().
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/camera.hpp"
#include "core/tessellate/line_section.hpp"
#include "gui/base/screen_rect.hpp"
#include "gui/base/theme.hpp"
#include "gui/scene/picking.hpp"
#include "gui/scene/projection_scene.hpp"
#include "gui/viewport/interval_planner.hpp"
#include "gui/viewport/legend.hpp"

#include <imgui.h>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

struct FilmFrame;

struct ViewportText {
    std::string title{};   ///< above the mesh; may be empty
    std::string subject{}; ///< what is solved: "plane, ring"; may be empty
    StepReport report{};
    int last_iteration = 0; ///< of the run, for the caption; 0: unknown
    bool caption = true;    ///< whether the line at the bottom is drawn
    float legend = 0;       ///< least width of the legend in pixels: meshes beside each other are of one size
    bool with_legend = true; ///< whether the legend of the colours is drawn
    bool notes = true;       ///< whether notes are: tangled cells, the exact mesh
};

/// A mesh to be drawn: what, from where, and where it belongs.
struct PlannedView {
    MeshScene scene;
    Camera camera; ///< for the size of `rect`
    ScreenRect rect;
    std::string title;         ///< above it; may be empty
    bool rear = false;         ///< its camera looks from behind the view's
    std::optional<Box> axes{}; ///< of the mesh that is shown, where it has axes

    Size size() const { return {static_cast<double>(rect.width()), static_cast<double>(rect.height())}; }
};

/// Another mesh to be shown beside a viewport's own.
struct NamedSnapshot {
    std::string title;
    const Snapshot* snapshot = nullptr;
};

struct ViewportPlan {
    ScreenRect rect;
    /// One, or more of one size, whose cameras are one, or look from both sides.
    std::vector<PlannedView> views;
    std::vector<PlannedPlot> plots; ///< of a mesh of an interval, which then has no views
    ViewportText text;
    std::shared_ptr<const Colouring> colouring; ///< of the legend; null: none
    std::optional<SectionLine> section;         ///< view.section, for a mesh in the plane
    std::optional<Pick> pick;
    PickFacts facts;       ///< of the pick
    std::string complaint; ///< what was wrong with the view's texts
    bool histogram = true;
    bool axes = true; ///< of meshes in the plane
    HistogramCounts counts = HistogramCounts::square_root;
    std::vector<std::string> unavailable; ///< choices of the view that this mesh has not: "layout=projection"
};

/// The point that a mesh rotates about.
Vec3 pivot_of(const MeshScene& scene);
/// The key of the view that holds the camera of a scene.
const char* camera_key(const MeshScene& scene);

/// Plans one viewport, frame after frame; keeps what does not change between them.
class ViewportPlanner {
  public:
    ViewportPlanner() = default;
    /// With tessellations that may have been made elsewhere.
    explicit ViewportPlanner(std::shared_ptr<TessellationCache> cache)
        : maker_(cache), uniform_maker_(std::move(cache)) {}

    /// Makes what takes long in plan() of the same snapshot and view. Needs no ImGui, so it can be done on
    /// another thread before.
    void prepare(const Snapshot& snapshot, const Values& view);
    /// Axes of plots are those of the whole film.
    void prepare(const FilmFrame& frame);
    /// Needs a current ImGui frame, for the sizes of texts. `view`: values of view_rows(). Texts that cannot
    /// be read are as good as empty, but for a complaint.
    ///
    /// `others` come beside it where view.layout is "runs", in the colours of the first. `zooms`: of plots.
    ViewportPlan plan(const Snapshot& snapshot, const Values& view, const ViewportText& text, ScreenRect rect,
                      float scale, std::span<const NamedSnapshot> others = {},
                      const std::vector<ColumnZoom>& zooms = {});
    /// Home is what showed the whole mesh when it was first seen, so that the view does not shake while it
    /// moves; from now on it is for the mesh of the next plan.
    void forget_home() { home_ = {}; }
    /// What home shows of a planar scene besides the mesh, such as control points beyond it.
    void show_also(std::optional<Box> box) { also_ = box; }
    /// The vertical axes of plots of an interval cover those of these snapshots, too.
    void compare_plots(std::vector<std::shared_ptr<const Snapshot>> snapshots) {
        compared_ = std::move(snapshots);
    }
    /// As SceneBuilder::work_in_background(), of a view's own mesh.
    void work_in_background() { maker_.work_in_background(); }
    /// Whether the next plan may show more.
    bool awaits_section() const { return maker_.awaits_section(); }
    /// A mesh in space is shown turned eastward by so many radians, from now on.
    void turn_by(double radians) { spun_ = radians; }

  private:
    Camera camera_of(const MeshScene& scene, const Values& view, Size size, Insets insets,
                     std::string& complaint);
    Camera turned(Camera camera, const MeshScene& scene) const;
    MeshScene computational(const MeshScene& scene, const Snapshot& snapshot, const Values& view);
    void place_views(const MeshScene& scene, const Snapshot& snapshot, const Values& view, ViewportPlan& plan,
                     float scale);
    void place_runs(const MeshScene& scene, const Values& view, ViewportPlan& plan,
                    std::span<const NamedSnapshot> others, float scale);
    void place_plots(const Snapshot& snapshot, const Values& view, ViewportPlan& plan,
                     std::span<const NamedSnapshot> others, const std::vector<ColumnZoom>& zooms,
                     float scale);
    void add_arrows(ViewportPlan& plan, float scale);
    void add_axes(ViewportPlan& plan);
    void add_section(const Values& view, ViewportPlan& plan);
    void add_pick(const Snapshot& snapshot, const MeshScene& scene, const Values& view, ViewportPlan& plan);

    SceneBuilder maker_;
    SceneBuilder uniform_maker_{maker_.cache()}; ///< of the uniform mesh, where it has other colours
    std::vector<SceneBuilder> other_makers_;     ///< of the meshes beside it, in their order
    ProjectionSceneBuilder projection_maker_;
    std::vector<IntervalPlanner> interval_planners_; ///< of intervals beside each other
    double spun_ = 0;
    std::optional<Box> also_;
    std::vector<std::shared_ptr<const Snapshot>> compared_;
    ComparedRanges compared_ranges_;
    std::vector<ColumnRanges> held_axes_; ///< of a film
    struct Home {
        std::shared_ptr<const Mesh> of;
        Size size;
        Insets insets;
        std::string direction;
        double elevation = 0;
        Box box; ///< of the mesh
        Camera camera;
    } home_;
    /// What the last arrows and the last facts were made for.
    struct Arrows {
        std::shared_ptr<const Tessellation> of;
        Camera camera;
        double width = 0, height = 0, spacing = 0;
        std::shared_ptr<const std::vector<std::uint32_t>> points;
    };
    std::vector<Arrows> arrows_; ///< of the plan's views
    /// The box of what was last shown.
    struct Extent {
        std::shared_ptr<const Points> computational, physical;
        double blend = 1;
        Box box;
    };
    std::vector<Extent> extents_; ///< of the plan's views
    struct Facts {
        std::shared_ptr<const Mesh> mesh;
        std::uint64_t version = 0;
        std::optional<Pick> pick;
        std::shared_ptr<const Colouring> colouring;
        PickFacts facts;
    } facts_;
};

/// The plots, as for a file; the window draws them as widgets.
void draw_viewport_plots(ImDrawList& list, const ViewportPlan& plan, const Theme& theme, float scale);
/// Everything but the meshes and the plots, over them.
void draw_viewport_overlay(ImDrawList& list, const ViewportPlan& plan, const Theme& theme, float scale);

/// Where the legend of a plan is; nothing if there is none.
std::optional<LegendPlaces> legend_of(const ViewportPlan& plan, float scale);

/// A sentence about what the view asks for and this mesh has not, where that is no error; else empty.
std::string missing_note(const Values& view, const Snapshot& snapshot);

} // namespace gaspard
