#include "core/base/error.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/tessellate/blend.hpp"
#include "core/tessellate/caption.hpp"
#include "core/tessellate/film.hpp"
#include "core/tessellate/snapshot_section.hpp"
#include "core/tessellate/ticks.hpp"
#include "gui/scene/arrows.hpp"
#include "gui/viewport/axes.hpp"
#include "gui/viewport/legend.hpp"
#include "gui/viewport/viewport.hpp"
#include "gui/viewport/viewport_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr double arrow_spacing = 26; // at scale 1

/// The margins for title and axes of one of several views.
Insets insets_of_part(const ViewportPlan& plan, const PlannedView& shown, float scale) {
    Insets insets = plan.axes ? room_for_axes(shown.scene, scale) : Insets();
    insets.top = static_cast<double>(title_height(shown.title, scale));
    return insets;
}

/// The margins for legend and texts of a view that fills the viewport.
Insets insets_of(const ViewportPlan& plan, const MeshScene& scene, float scale) {
    Insets insets;
    const ScreenRect rect = plan.rect;
    insets.top = static_cast<double>(title_height(plan.text.title, scale));
    insets.bottom = static_cast<double>(caption_height(plan.text, rect.width(), scale));
    if (plan.colouring != nullptr)
        insets.right = static_cast<double>(
            std::max(plan.text.legend, legend_width(*plan.colouring, plan.histogram, scale)));
    if (scene.projection)
        insets.left = static_cast<double>(ImGui::CalcTextSize("30° N").x + 2 * viewport_margin * scale);
    // Where the legend's strip is free anyway beside a centred mesh, the mesh stays centred.
    const double free_side =
        (static_cast<double>(rect.width() - rect.height()) + insets.top + insets.bottom) / 2;
    if (free_side > insets.right && !scene.projection) insets.left = insets.right;
    if (!plan.axes) return insets;
    const Insets axes = room_for_axes(scene, scale);
    insets.left = std::max(insets.left, axes.left);
    insets.right = std::max(insets.right, axes.right);
    insets.bottom += axes.bottom;
    return insets;
}

Size size_of(ScreenRect rect) {
    return {std::max(1.0, static_cast<double>(rect.width())),
            std::max(1.0, static_cast<double>(rect.height()))};
}

/// Whether two parts are beside each other; in an upright strip, one is above the other.
bool fit_beside(ScreenRect available) { return 2 * available.width() >= available.height(); }

/// Two parts of one size.
std::pair<ScreenRect, ScreenRect> halves(ScreenRect available) {
    const bool beside = fit_beside(available);
    const float half = std::floor((beside ? available.width() : available.height()) / 2);
    ScreenRect first = available, second = available;
    (beside ? first.max.x : first.max.y) = (beside ? available.min.x : available.min.y) + half;
    (beside ? second.min.x : second.min.y) = (beside ? first.max.x : first.max.y);
    (beside ? second.max.x : second.max.y) = (beside ? second.min.x : second.min.y) + half;
    return {first, second};
}

/// Colours that only a mesh has that follows a time, and that this one has not.
std::vector<std::string> missing_velocities(const Snapshot& snapshot) {
    std::vector<std::string> names;
    for (const FieldInfo& info : mesh_colours())
        if (info.name.starts_with("mesh_") && snapshot.field(info.name) == nullptr)
            names.push_back(info.name);
    return names;
}

/// A mesh that has another side.
bool in_space(const MeshScene& scene) { return !scene.planar() && scene.elevation == 0; }

/// The layout that the mesh can be shown in.
std::string layout_of(const MeshScene& scene, const Values& view) {
    const std::string& wish = view.text("layout");
    if (wish == "runs") return "single"; // there are no others
    const bool fits = wish == "projection" ? scene.ball > 0 : wish != "front-and-rear" || in_space(scene);
    return fits ? wish : "single";
}

} // namespace

std::vector<std::vector<std::string>> caption_lines(const ViewportText& text, float width, float scale) {
    std::vector<std::vector<std::string>> lines;
    float used = width + 1;
    for (auto& part : caption_parts(text.subject, text.report, text.last_iteration)) {
        const float need = ImGui::CalcTextSize(part.c_str()).x + 4 * viewport_gap * scale;
        if (used + need > width) {
            lines.emplace_back();
            used = 0;
        }
        used += need;
        lines.back().push_back(std::move(part));
    }
    return lines;
}

float caption_height(const ViewportText& text, float width, float scale) {
    if (!text.caption) return 0;
    const auto lines = caption_lines(text, width - 2 * viewport_margin * scale, scale);
    return std::round(viewport_line_height() * static_cast<float>(lines.size()) + viewport_gap * scale);
}

float title_height(const std::string& title, float scale) {
    return title.empty() ? 0 : viewport_line_height() + viewport_margin * scale;
}

ScreenRect above_caption(const ViewportPlan& plan, float scale) {
    ScreenRect available = plan.rect;
    available.max.y -= caption_height(plan.text, available.width(), scale);
    return available;
}

const char* camera_key(const MeshScene& scene) {
    return scene.projection ? "projection_camera" : scene.elevation > 0 ? "elevation_camera" : "camera";
}

/// As far as the mesh has spun.
Camera ViewportPlanner::turned(Camera camera, const MeshScene& scene) const {
    if (spun_ != 0 && !scene.planar()) spin(camera, spun_, pivot_of(scene));
    return camera;
}

Vec3 pivot_of(const MeshScene& scene) { return scene.ball > 0 ? Vec3{} : scene.home_box.centre(); }

/// Whether a planar mesh is about where another one was.
static bool is_alike(const Box& before, const MeshScene& scene) {
    const double size = before.size(), now = scene.home_box.size();
    return scene.planar() && now < 1.7 * size && size < 1.7 * now &&
           norm(scene.home_box.centre() - before.centre()) < 0.5 * size;
}

Camera ViewportPlanner::camera_of(const MeshScene& scene, const Values& view, Size size, Insets insets,
                                  std::string& complaint) {
    const std::string& text = view.text(camera_key(scene));
    std::optional<Camera> wish;
    try {
        if (!text.empty()) wish = parse_camera(text, size);
    } catch (const InputError& error) {
        complaint = error.what();
    }
    if (wish && !shows_all(text)) return turned(*wish, scene);
    if (scene.projection) return planar_home(scene.box, size, insets);
    const std::string& direction = wish ? text : view.text("direction");
    const bool same_view = home_.size == size && home_.insets == insets && home_.direction == direction &&
                           home_.elevation == scene.elevation;
    // While the domain is changed by its points, they stay where the mouse has put them.
    if (same_view && home_.of && home_.of != scene.mesh && also_ && is_alike(home_.box, scene))
        home_.of = scene.mesh;
    if (same_view && home_.of == scene.mesh) return turned(home_.camera, scene);
    const Box shown = also_ && scene.planar() ? merge(scene.home_box, *also_) : scene.home_box;
    const Camera whole = home(shown, size, insets, view.text("direction"));
    home_ = {scene.mesh, size, insets, direction, scene.elevation, scene.home_box, whole};
    if (scene.planar()) return home_.camera;
    if (wish) home_.camera.right = wish->right, home_.camera.up = wish->up;
    if (scene.ball > 0) {
        fit_ball(home_.camera, pivot_of(scene), scene.ball, size, insets);
    } else {
        home_.camera.centre = scene.home_box.centre();
        std::vector<const Points*> points{scene.nodes ? &scene.mesh->nodes : scene.computational.get()};
        if (!scene.burst) points.push_back(scene.nodes ? scene.nodes.get() : scene.physical.get());
        fit_points(home_.camera, points, size, insets);
    }
    return turned(home_.camera, scene);
}

/// The computational mesh, for the left of two. Interpolation errors there are those of the uniform mesh.
MeshScene ViewportPlanner::computational(const MeshScene& scene, const Snapshot& snapshot,
                                         const Values& view) {
    MeshScene left = scene;
    const bool of_errors = view.text("color") == "interpolation_error" && snapshot.interpolation;
    if (of_errors || scene.nodes) { // planes cut a mesh where it is shown
        Values of_uniform = view;
        if (of_errors) of_uniform.set("color", std::string("interpolation_error_uniform"));
        of_uniform.set("blend", 0.0);
        left = uniform_maker_.make(snapshot, of_uniform);
    }
    left.blend = 0, left.overlay = nullptr;
    return left;
}

/// What its colours show.
static std::string field_title(const MeshScene& scene) {
    return scene.colouring ? scene.colouring->label : "no colours";
}

void ViewportPlanner::place_views(const MeshScene& scene, const Snapshot& snapshot, const Values& view,
                                  ViewportPlan& plan, float scale) {
    const std::string layout = layout_of(scene, view);
    const bool apart = layout == "field-and-mesh";
    if (layout != "side-by-side" && layout != "front-and-rear" && !apart) {
        const MeshScene shown = layout == "projection"
                                    ? projection_maker_.make(scene, view.real("projection_longitude"))
                                : layout == "computational" ? computational(scene, snapshot, view)
                                                            : scene;
        const Camera camera =
            camera_of(shown, view, size_of(plan.rect), insets_of(plan, shown, scale), plan.complaint);
        plan.views = {{shown, camera, plan.rect, plan.text.title}};
        return;
    }
    // Two of the same size; the legend has a strip of its own.
    ScreenRect available = above_caption(plan, scale);
    if (plan.colouring != nullptr)
        available.max.x -= std::round(legend_width(*plan.colouring, plan.histogram, scale));
    const auto [first, second] = halves(available);
    const bool around = layout == "front-and-rear";
    PlannedView left{around || apart ? scene : computational(scene, snapshot, view),
                     {},
                     first,
                     around  ? "front"
                     : apart ? field_title(scene)
                             : "computational"};
    if (apart) left.scene.lines = false, left.scene.tangled = nullptr, left.scene.arrows = nullptr;
    left.camera = camera_of(scene, view, size_of(first), insets_of_part(plan, left, scale), plan.complaint);
    PlannedView right{scene, left.camera, second,
                      around  ? "rear"
                      : apart ? "mesh"
                              : blend_title(scene.blend)};
    if (apart)
        right.scene.colouring = nullptr, right.scene.point_values = nullptr, right.scene.contours = nullptr;
    if (around) right.camera = from_behind(left.camera, pivot_of(scene)), right.rear = true;
    plan.views = {std::move(left), std::move(right)};
}

namespace {

/// So many columns that the parts are as wide as they are high, as nearly as can be.
int columns_for(std::size_t count, ScreenRect available) {
    const auto shorter = [&](int columns) {
        const int rows = (static_cast<int>(count) + columns - 1) / columns;
        return std::min(available.width() / static_cast<float>(columns),
                        available.height() / static_cast<float>(rows));
    };
    int best = 1;
    for (int columns = 2; columns <= static_cast<int>(count); ++columns)
        if (shorter(columns) > shorter(best)) best = columns;
    return best;
}

/// The view with its range fixed to that of one scene, for the scenes beside it.
Values in_colours_of(const MeshScene& scene, Values view) {
    return scene.colouring == nullptr ? view : with_range(std::move(view), scene.colouring->range);
}

} // namespace

void ViewportPlanner::place_runs(const MeshScene& scene, const Values& view, ViewportPlan& plan,
                                 std::span<const NamedSnapshot> others, float scale) {
    ScreenRect available = above_caption(plan, scale);
    if (plan.colouring != nullptr)
        available.max.x -= std::round(legend_width(*plan.colouring, plan.histogram, scale));
    const std::size_t count = others.size() + 1;
    const int columns = count == 2 ? (fit_beside(available) ? 2 : 1) : columns_for(count, available);
    const int rows = (static_cast<int>(others.size()) + columns) / columns;
    const ImVec2 part{std::floor(available.width() / static_cast<float>(columns)),
                      std::floor(available.height() / static_cast<float>(rows))};
    const Values like_first = in_colours_of(scene, view);
    while (other_makers_.size() < others.size()) other_makers_.emplace_back(maker_.cache());
    for (std::size_t i = 0; i <= others.size(); ++i) {
        const auto column = static_cast<float>(static_cast<int>(i) % columns),
                   row = static_cast<float>(static_cast<int>(i) / columns);
        const ImVec2 corner{available.min.x + column * part.x, available.min.y + row * part.y};
        plan.views.push_back({i == 0 ? scene : other_makers_[i - 1].make(*others[i - 1].snapshot, like_first),
                              {},
                              {corner, {corner.x + part.x, corner.y + part.y}},
                              i == 0 ? plan.text.subject : others[i - 1].title});
    }
    PlannedView& first = plan.views.front();
    first.camera = camera_of(scene, view, first.size(), insets_of_part(plan, first, scale), plan.complaint);
    for (PlannedView& shown : plan.views) shown.camera = first.camera;
}

/// Of an interval; in the layout "runs" those of all runs, which are zoomed together.
void ViewportPlanner::place_plots(const Snapshot& snapshot, const Values& view, ViewportPlan& plan,
                                  std::span<const NamedSnapshot> others, const std::vector<ColumnZoom>& zooms,
                                  float scale) {
    for (const char* choice : {"layout=front-and-rear", "layout=projection", "overlay=exact"})
        plan.unavailable.emplace_back(choice);
    const bool among_others = view.text("layout") == "runs" && !others.empty();
    const std::size_t count = among_others ? others.size() + 1 : 1;
    if (interval_planners_.size() < count) interval_planners_.resize(count);
    const auto& compared = compared_ranges_.of(compared_, view);
    const ScreenRect available = above_caption(plan, scale);
    const int columns = columns_for(count, available);
    const int rows = (static_cast<int>(count) + columns - 1) / columns;
    const float width = std::floor(available.width() / static_cast<float>(columns)),
                height = std::floor(available.height() / static_cast<float>(rows));
    for (std::size_t i = 0; i < count; ++i) {
        const ImVec2 corner{available.min.x + width * static_cast<float>(static_cast<int>(i) % columns),
                            available.min.y + height * static_cast<float>(static_cast<int>(i) / columns)};
        const std::string& title = !among_others ? plan.text.title
                                   : i == 0      ? plan.text.subject
                                                 : others[i - 1].title;
        for (PlannedPlot& plot : interval_planners_[i].plan(
                 i == 0 ? snapshot : *others[i - 1].snapshot, view, title,
                 {corner, {corner.x + width, corner.y + height}}, zooms, scale, compared, held_axes_))
            plan.plots.push_back(std::move(plot));
    }
}

void ViewportPlanner::add_arrows(ViewportPlan& plan, float scale) {
    arrows_.resize(std::max(arrows_.size(), plan.views.size()));
    for (std::size_t i = 0; i < plan.views.size(); ++i) {
        PlannedView& shown = plan.views[i];
        Arrows& arrows = arrows_[i];
        const Size size = shown.size();
        const double spacing = arrow_spacing * static_cast<double>(scale);
        if (shown.scene.projection) continue;
        if (arrows.of != shown.scene.tessellation || !(arrows.camera == shown.camera) ||
            arrows.width != size.width || arrows.height != size.height || arrows.spacing != spacing)
            arrows = {shown.scene.tessellation,
                      shown.camera,
                      size.width,
                      size.height,
                      spacing,
                      std::make_shared<const std::vector<std::uint32_t>>(
                          points_with_arrows(shown.scene, shown.camera, size, spacing))};
        shown.scene.arrows = arrows.points;
    }
}

void ViewportPlanner::add_axes(ViewportPlan& plan) {
    extents_.resize(std::max(extents_.size(), plan.views.size()));
    for (std::size_t i = 0; i < plan.views.size(); ++i) {
        const MeshScene& scene = plan.views[i].scene;
        if (!has_axes(scene)) continue;
        Extent& extent = extents_[i];
        if (extent.computational != scene.computational || extent.physical != scene.physical ||
            extent.blend != scene.blend)
            extent = {scene.computational, scene.physical, scene.blend, shown_box(scene)};
        plan.views[i].axes = extent.box;
    }
}

/// What is wrong with the texts that say what is hidden of a solid; else empty.
static std::string complaint_about_inside(const Values& view) {
    try {
        inside_choice(view);
        return {};
    } catch (const InputError& error) {
        return error.what();
    }
}

void ViewportPlanner::add_section(const Values& view, ViewportPlan& plan) {
    if (plan.views.empty() || !has_section_line(*plan.views.front().scene.mesh)) return;
    try {
        plan.section = parse_section_line(view.text("section"));
    } catch (const InputError& error) {
        plan.complaint = error.what();
    }
}

void ViewportPlanner::add_pick(const Snapshot& snapshot, const MeshScene& scene, const Values& view,
                               ViewportPlan& plan) {
    try {
        plan.pick = parse_pick(view.text("pick"));
    } catch (const InputError& error) {
        plan.complaint = error.what();
    }
    if (!plan.pick) return;
    if (!has(*snapshot.mesh, *plan.pick)) {
        plan.pick.reset();
        return;
    }
    if (facts_.mesh != snapshot.mesh || facts_.version != snapshot.version || facts_.pick != plan.pick ||
        facts_.colouring != scene.colouring)
        facts_ = {snapshot.mesh, snapshot.version, plan.pick, scene.colouring,
                  facts_of(*plan.pick, snapshot, maker_.cells(), scene.colouring.get())};
    plan.facts = facts_.facts;
}

void ViewportPlanner::prepare(const Snapshot& snapshot, const Values& view) {
    if (is_interval(*snapshot.mesh)) return;
    const MeshScene scene = maker_.make(snapshot, view);
    const std::string layout = layout_of(scene, view);
    if (layout == "projection") projection_maker_.make(scene, view.real("projection_longitude"));
    if (layout == "side-by-side" || layout == "computational") computational(scene, snapshot, view);
}

void ViewportPlanner::prepare(const FilmFrame& frame) {
    prepare(*frame.snapshot, frame.view);
    held_axes_ = frame.axes;
}

ViewportPlan ViewportPlanner::plan(const Snapshot& snapshot, const Values& view, const ViewportText& text,
                                   ScreenRect rect, float scale, std::span<const NamedSnapshot> others,
                                   const std::vector<ColumnZoom>& zooms) {
    ViewportPlan plan;
    plan.rect = rect;
    plan.text = text;
    for (const std::string& name : missing_velocities(snapshot)) plan.unavailable.push_back("color=" + name);
    if (is_interval(*snapshot.mesh)) {
        place_plots(snapshot, view, plan, others, zooms, scale);
        return plan;
    }
    const MeshScene scene = maker_.make(snapshot, view);
    if (scene.cell_dimension == 3) plan.complaint = complaint_about_inside(view);
    if (text.with_legend) plan.colouring = scene.colouring;
    plan.histogram = view.boolean("histogram");
    plan.axes = view.boolean("axes");
    plan.counts = histogram_counts(view.text("histogram_counts"));
    if (!in_space(scene)) plan.unavailable.emplace_back("layout=front-and-rear");
    if (scene.ball == 0) plan.unavailable.emplace_back("layout=projection");
    if (!snapshot.exact) plan.unavailable.emplace_back("overlay=exact");
    if (view.text("layout") == "runs" && !others.empty())
        place_runs(scene, view, plan, others, scale);
    else
        place_views(scene, snapshot, view, plan, scale);
    if (scene.cell_dimension == 3 && plan.complaint.empty() && scene.tessellation->triangles.empty())
        plan.complaint = nothing_left(view);
    if (view.boolean("arrows")) add_arrows(plan, scale);
    if (plan.axes) add_axes(plan);
    add_section(view, plan);
    add_pick(snapshot, scene, view, plan);
    return plan;
}

/// Whether the colours interpolate values of nodes.
static bool has_nodal_colours(const Values& view, const Snapshot& snapshot) {
    const std::string& name = view.text("color");
    for (const FieldInfo& info : mesh_colours())
        if (info.name == name) return info.place == FieldPlace::node;
    const Field* field = snapshot.field(name);
    return field != nullptr && field->place == FieldPlace::node;
}

std::string missing_note(const Values& view, const Snapshot& snapshot) {
    if (is_interval(*snapshot.mesh))
        for (const char* key : {"camera", "arrows", "pick", "contours", "elevation", "section"})
            if (!is_default(view, key))
                return "view." + std::string(key) + " shows nothing: an interval is shown as plots";
    for (const QualityMeasureInfo& measure : quality_measures())
        if (view.text("color") == measure.name && is_interval(*snapshot.mesh))
            return "view.color = " + view.text("color") + " shows nothing: an interval has no such values";
    for (const std::string& name : missing_velocities(snapshot))
        if (view.text("color") == name)
            return "view.color = " + name + " shows nothing: " +
                   (snapshot.field("mesh_speed") != nullptr ? "the mesh has no such direction"
                                                            : "no time passes");
    if (!has_section_line(*snapshot.mesh) && !is_default(view, "section"))
        return "view.section shows nothing: only a mesh in the plane is cut by a line";
    const bool plane = snapshot.mesh->space_dimension == 2 && cell_dimension(snapshot.mesh->kind) == 2;
    if (!plane && !is_default(view, "elevation"))
        return "view.elevation shows nothing: only a surface in the plane has heights";
    for (const std::string& key : inside_keys())
        if (cell_dimension(snapshot.mesh->kind) != 3 && !is_default(view, key))
            return "view." + key + " shows nothing: only a solid can be looked into";
    for (const char* key : {"contours", "elevation"})
        if (!is_default(view, key) && !has_nodal_colours(view, snapshot))
            return "view." + std::string(key) + " shows nothing: view.color = " + view.text("color") +
                   " has no values at the nodes";
    if (view.text("overlay") != "exact" || snapshot.exact) return {};
    return "view.overlay = exact shows nothing: the exact mesh is known on a sphere, for monitors that have "
           "an axis, and between ellipses with constant or disks with radial densities";
}

} // namespace gaspard
