#include "gui/panels/viewport_pane.hpp"

#include "core/base/counted.hpp"
#include "core/base/error.hpp"
#include "core/base/short_number.hpp"
#include "core/session/time_series.hpp"
#include "gui/base/part_window.hpp"
#include "gui/base/plot_text.hpp"
#include "gui/plot/plot_widget.hpp"
#include "gui/viewport/axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>
#include <numbers>
#include <string>

namespace gaspard {

namespace {

constexpr float drag_threshold = 4; // pixels at scale 1; a shorter drag is a click
constexpr double pick_reach = 8;    // pixels at scale 1
constexpr double handle_reach = 11;
constexpr double wheel_factor = 1.15;
constexpr double arrow_of_cut = 52; // pixels at scale 1

Pixel pixel_in(const PlannedView& shown, ImVec2 mouse) {
    return {static_cast<double>(mouse.x - shown.rect.min.x), static_cast<double>(mouse.y - shown.rect.min.y)};
}

/// The view at a position; the nearest one if there is none.
const PlannedView& view_at(const ViewportPlan& plan, ImVec2 at) {
    const auto away = [at](const PlannedView& shown) {
        const ScreenRect& r = shown.rect;
        return std::max({r.min.x - at.x, at.x - r.max.x, r.min.y - at.y, at.y - r.max.y});
    };
    return *std::min_element(plan.views.begin(), plan.views.end(),
                             [&](const auto& a, const auto& b) { return away(a) < away(b); });
}

/// Rotates a ball so that a point faces the viewer. A ball that is fully visible stays at its place in the
/// view; else the point moves to the middle.
void recentre(Camera& camera, const PlannedView& shown, Vec3 where) {
    const Vec3 pivot = pivot_of(shown.scene);
    bring_to_front(camera, where, pivot);
    const double across = 2 * shown.scene.ball / camera.scale;
    if (across > std::min(shown.size().width, shown.size().height)) camera.centre = pivot;
}

/// Whether a camera shows a ball at the same size and place as before.
bool only_rotated(const PlannedView& shown, const Camera& camera) {
    constexpr double tolerance = 1e-6; // pixels
    const Vec3 pivot = pivot_of(shown.scene);
    const Pixel before = to_pixel(shown.camera, shown.size(), pivot),
                now = to_pixel(camera, shown.size(), pivot);
    return shown.scene.ball > 0 && camera.scale == shown.camera.scale &&
           std::hypot(before.x - now.x, before.y - now.y) < tolerance;
}

/// The planes of the view where they cut something.
std::vector<CutWedge> cut_of(const ViewportPlan& plan, const Values& view) {
    if (plan.views.empty() || plan.views.front().scene.cell_dimension != 3) return {};
    try {
        return parse_cut(view.text("cut"));
    } catch (const InputError&) { // it is being typed
        return {};
    }
}

/// The mouse button that is held; -1 for none.
int held_button() {
    for (const int button : {0, 1, 2})
        if (ImGui::IsMouseDown(button)) return button;
    return -1;
}

} // namespace

std::string title_among_others(const ShownRun& shown) {
    const DocumentRun& run = *shown.run;
    if (run.history.empty()) return run.name;
    const StepReport& last = run.history.back();
    if (shown.snapshot && shown.snapshot->report.iteration < last.iteration) {
        const StepReport& now = shown.snapshot->report;
        const std::size_t tangled = now.tangled_cells.value_or(0);
        const std::string place = is_time_step(now) ? "t = " + short_number(*time_of(now), 5)
                                                    : "iteration " + std::to_string(now.iteration) + " of " +
                                                          std::to_string(last.iteration);
        return run.name + ": " + place +
               (tangled > 0 ? ", " + std::to_string(tangled) + " tangled cells" : std::string());
    }
    std::string text = run.name + ": " +
                       (is_time_step(last) ? "t = " + short_number(*time_of(last), 5)
                                           : counted(last.iteration, "iteration")) +
                       ", ";
    if (last.tangled_cells.value_or(0) > 0 && run.status.run != RunStatus::tangled)
        text += std::to_string(*last.tangled_cells) + " tangled cells, ";
    std::string status(status_name(run.status.run));
    std::replace(status.begin(), status.end(), '-', ' '); // "iteration limit"
    return text + status;
}

void ViewportPane::frame(const ShownRun& shown_run, DocumentViewport& viewport, const ItemRectangle& area,
                         const FrameContext& context, const std::vector<ShownRun>& others) {
    const DocumentRun& run = *shown_run.run;
    const std::shared_ptr<const Snapshot>& snapshot = shown_run.snapshot;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    begin_part("##viewport", area,
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    context.items["viewport"] = area;
    const bool plots = snapshot && is_interval(*snapshot->mesh);
    if (plots)
        forget_zooms(viewport.view);
    else
        interact(viewport.view, area, context);
    if (snapshot) {
        const bool among_others = viewport.view.text("layout") == "runs";
        std::vector<NamedSnapshot> beside;
        for (const ShownRun& other : others)
            if (among_others && other.snapshot)
                beside.push_back({title_among_others(other), other.snapshot.get()});
        NamedSnapshot first{among_others ? title_among_others(shown_run) : run.title, snapshot.get()};
        hides_active_ = among_others && run.hidden && !beside.empty();
        if (hides_active_) { // the first of the others takes its place
            first = beside.front();
            beside.erase(beside.begin());
        }
        const ViewportText text{.subject = first.title, .caption = false};
        const Values view = with_range(viewport.view, shown_run.range);
        planner_.compare_plots(shown_run.compared);
        plan_ =
            planner_.plan(*first.snapshot, plots ? viewport.view : view, text,
                          {{area.left, area.top}, {area.right, area.bottom}}, context.scale, beside, zooms_);
        if (plots) draw_plots(context);
        draw_nets(context); // below the labels of axes
        draw_overlay(context);
        cut_ = cut_of(*plan_, viewport.view);
        if (!plots)
            draw_handles(context), draw_cut(context), section_.draw(*plan_, context),
                draw_legend_control(viewport.view, context);
        views_.clear();
        for (const PlannedView& shown : plan_->views)
            views_.push_back({shown.scene,
                              shown.camera,
                              {shown.rect.min.x, shown.rect.min.y, shown.rect.max.x, shown.rect.max.y}});
    }
    ImGui::End();
}

void ViewportPane::draw_nets(const FrameContext& context) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const PlannedView& shown : plan_->views) {
        if (handles_.empty() || !seen(handles_.back(), shown)) continue;
        list.PushClipRect(shown.rect.min, shown.rect.max, true);
        draw_control_net(handles_, list, shown, context.theme, context.scale);
        list.PopClipRect();
    }
}

/// Over the meshes that are on the screen, if those of the plan follow later.
void ViewportPane::draw_overlay(const FrameContext& context) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ViewportPlan shown = *plan_;
    for (std::size_t i = 0; i < shown.views.size() && on_screen_.size() == shown.views.size(); ++i) {
        PlannedView& view = shown.views[i];
        const ShownView& there = on_screen_[i];
        const bool here = there.rectangle.left == view.rect.min.x && there.rectangle.top == view.rect.min.y &&
                          there.rectangle.right == view.rect.max.x &&
                          there.rectangle.bottom == view.rect.max.y;
        const bool alike = there.scene.mesh->cell_count() == view.scene.mesh->cell_count() &&
                           has_axes(there.scene) == view.axes.has_value();
        if (!here || !alike || (there.scene == view.scene && there.camera == view.camera)) continue;
        view.scene = there.scene, view.camera = there.camera;
        if (view.axes) view.axes = shown_box(there.scene);
    }
    draw_viewport_overlay(list, shown, context.theme, context.scale);
}

void ViewportPane::offer_handles(std::vector<Handle> handles) {
    std::optional<Box> box;
    for (const Handle& handle : handles)
        if (handle.control)
            box = box ? merge(*box, bounding_box(*handle.control)) : bounding_box(*handle.control);
    planner_.show_also(box);
    handles_ = std::move(handles);
}

/// The mouse on the meshes of the last frame.
void ViewportPane::interact(Values& view, const ItemRectangle& area, const FrameContext& context) {
    ImGui::InvisibleButton("##viewport", {std::max(1.0F, area.width()), std::max(1.0F, area.height())},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                               ImGuiButtonFlags_MouseButtonRight);
    if (!plan_ || plan_->views.empty()) return;
    const float scale = context.scale;
    if (!use_legend(view, scale) && !drag_cut(view, scale) && !section_.interact(view, *plan_, scale) &&
        !drag_handle(scale))
        steer(view, scale);
    turn(view);
}

/// True if the mouse is on the legend.
bool ViewportPane::use_legend(Values& view, float scale) {
    const auto places = legend_of(*plan_, scale);
    return places && legend_.interact(view, *plan_->colouring, *places, scale);
}

void ViewportPane::draw_legend_control(Values& view, const FrameContext& context) {
    if (const auto places = legend_of(*plan_, context.scale))
        legend_.draw(view, *plan_->colouring, *places, context);
}

/// Other axes begin with all there is to see.
void ViewportPane::forget_zooms(const Values& view) {
    std::string x = view.text("x_axis") + view.text("layout"), y = view.text("color") + view.text("range");
    for (const char* key : {"log", "low", "high"}) y += " " + format_value(view.at(key));
    if (x != x_axis_) zooms_.clear();
    if (y != y_axis_)
        for (ColumnZoom& zoom : zooms_) zoom.values.reset();
    x_axis_ = std::move(x), y_axis_ = std::move(y);
}

/// Instead of plots without room.
void ViewportPane::say_too_small(const FrameContext& context) const {
    const ScreenRect& pane = plan_->rect;
    const std::string text = shortened("Too small to show the mesh: enlarge the window", pane.width());
    const ImVec2 size = text_size(text);
    const ImVec2 at{(pane.min.x + pane.max.x - size.x) / 2, (pane.min.y + pane.max.y - size.y) / 2};
    write_text(*ImGui::GetWindowDrawList(), at, context.theme.faint_text, text);
    context.items["viewport.too-small"] = {at.x, at.y, at.x + size.x, at.y + size.y};
}

/// As widgets, which the mouse zooms: those of a column together.
void ViewportPane::draw_plots(const FrameContext& context) {
    spinning_ = false;
    const auto drawable = [&](const PlannedPlot& plot) {
        return make_frame(plot.view, plot.rect, plot.zoom, context.scale).drawable();
    };
    if (std::none_of(plan_->plots.begin(), plan_->plots.end(), drawable)) return say_too_small(context);
    for (std::size_t i = 0; i < plan_->plots.size(); ++i) {
        PlannedPlot& plot = plan_->plots[i];
        ImGui::SetCursorScreenPos(plot.rect.min);
        const PlotZoom before = plot.zoom;
        plot_widget(("##plot" + std::to_string(i)).c_str(), plot.view,
                    {plot.rect.width(), plot.rect.height()}, plot.zoom, context.theme, context.scale);
        remember_item(context.items, "viewport.plot." + std::to_string(i));
        if (plot.zoom == before) continue;
        if (zooms_.size() <= plot.column) zooms_.resize(plot.column + 1);
        zooms_[plot.column].x = plot.zoom.x;
        (plot.spacing ? zooms_[plot.column].spacing : zooms_[plot.column].values) = plot.zoom.y;
        for (std::size_t k = i + 1; k < plan_->plots.size(); ++k) // in this frame already
            if (plan_->plots[k].column == plot.column) plan_->plots[k].zoom.x = plot.zoom.x;
    }
}

/// Where a view shows a handle; nothing in the views of other runs, which have their own monitors.
std::optional<Pixel> ViewportPane::seen(const Handle& handle, const PlannedView& shown) const {
    if (hides_active_ || shown.scene.physical != plan_->views.front().scene.physical) return std::nullopt;
    return pixel_of(handle, shown);
}

std::optional<std::size_t> ViewportPane::handle_at(ImVec2 at, float scale) const {
    const PlannedView& shown = view_at(*plan_, at);
    const Pixel pointer = pixel_in(shown, at);
    const double reach = handle_reach * static_cast<double>(scale);
    for (std::size_t i = 0; i < handles_.size(); ++i)
        if (const auto pixel = seen(handles_[i], shown))
            if (std::hypot(pixel->x - pointer.x, pixel->y - pointer.y) < reach) return i;
    return std::nullopt;
}

/// Moves the handle on which the button was pressed with the pointer; the camera stays. True if it did.
bool ViewportPane::drag_handle(float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated())
        held_ = ImGui::IsMouseDown(0) ? handle_at(io.MouseClickedPos[0], scale) : std::nullopt;
    if (held_ && *held_ >= handles_.size()) held_.reset(); // it no longer exists
    if (!held_) return false;
    const bool ends = ImGui::IsItemDeactivated();
    const ImVec2 clicked = io.MouseClickedPos[0];
    const float x = io.MousePos.x - clicked.x, y = io.MousePos.y - clicked.y, far = drag_threshold * scale;
    if ((ends || ImGui::IsItemActive()) && (dragging_ || x * x + y * y > far * far)) {
        const bool moved = !std::exchange(dragging_, true) || io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
        const PlannedView& shown = view_at(*plan_, clicked);
        const auto place = place_under(handles_[*held_], shown, pixel_in(shown, io.MousePos));
        if (place && moved) handle_move_ = {handles_[*held_], *place};
    }
    if (ImGui::IsItemActive()) return true;
    held_.reset();
    return std::exchange(dragging_, false); // no drag: a click
}

void ViewportPane::draw_handles(const FrameContext& context) {
    const std::size_t none = handles_.size();
    const bool hovered = !held_ && ImGui::IsItemHovered();
    const std::size_t lit =
        hovered ? handle_at(ImGui::GetIO().MousePos, context.scale).value_or(none) : held_.value_or(none);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const PlannedView& shown : plan_->views) {
        list.PushClipRect(shown.rect.min, shown.rect.max, true);
        for (std::size_t i = 0; i < handles_.size(); ++i) {
            const auto at = seen(handles_[i], shown);
            if (!at) continue;
            const float x = shown.rect.min.x + static_cast<float>(at->x),
                        y = shown.rect.min.y + static_cast<float>(at->y);
            draw_handle(handles_[i], list, {x, y}, lit == i, context.theme, context.scale);
            context.items[item_name(handles_[i])] = {x, y, x, y};
        }
        list.PopClipRect();
    }
    if (lit < none) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    if (lit < none && hovered)
        ImGui::SetTooltip("%s", handles_[lit].control ? "Drag this control point." : "Drag this centre.");
}

std::vector<CutHandle> ViewportPane::cut_handles_in(const PlannedView& shown, float scale) const {
    if (!offers_cut_) return {};
    return cut_handles(cut_, shown, arrow_of_cut * static_cast<double>(scale));
}

std::optional<CutHandle> ViewportPane::cut_handle_at(ImVec2 at, float scale) const {
    const PlannedView& shown = view_at(*plan_, at);
    const Pixel pointer = pixel_in(shown, at);
    const double reach = handle_reach * static_cast<double>(scale);
    for (const CutHandle& handle : cut_handles_in(shown, scale)) {
        const Pixel pixel = to_pixel(shown.camera, shown.size(), handle.place());
        if (std::hypot(pixel.x - pointer.x, pixel.y - pointer.y) < reach) return handle;
    }
    return std::nullopt;
}

/// Moves or turns the plane on whose handle the button was pressed. True if it did.
bool ViewportPane::drag_cut(Values& view, float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated()) {
        const auto handle =
            ImGui::IsMouseDown(0) ? cut_handle_at(io.MouseClickedPos[0], scale) : std::nullopt;
        held_cut_ = handle ? std::optional(HeldCut{*handle, cut_}) : std::nullopt;
    }
    if (!held_cut_) return false;
    const bool ends = ImGui::IsItemDeactivated();
    if (ends || ImGui::IsItemActive()) {
        const ImVec2 clicked = io.MouseClickedPos[0];
        const PlannedView& shown = view_at(*plan_, clicked);
        if (io.MousePos.x != clicked.x || io.MousePos.y != clicked.y)
            view.set("cut",
                     format_cut(with_cut_handle_at(held_cut_->before, held_cut_->handle, shown,
                                                   pixel_in(shown, clicked), pixel_in(shown, io.MousePos))));
    }
    if (!ImGui::IsItemActive()) held_cut_.reset();
    return true;
}

void ViewportPane::draw_cut(const FrameContext& context) {
    if (cut_.empty()) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto lit = held_cut_                ? std::optional(held_cut_->handle)
                     : ImGui::IsItemHovered() ? cut_handle_at(ImGui::GetIO().MousePos, context.scale)
                                              : std::nullopt;
    for (const PlannedView& shown : plan_->views) {
        const std::vector<CutHandle> handles = cut_handles_in(shown, context.scale);
        std::size_t which = handles.size();
        for (std::size_t i = 0; i < handles.size(); ++i) {
            const CutHandle& handle = handles[i];
            if (lit && handle.wedge == lit->wedge && handle.plane == lit->plane && handle.turns == lit->turns)
                which = i;
            const Pixel at = to_pixel(shown.camera, shown.size(), handle.place());
            const float x = shown.rect.min.x + static_cast<float>(at.x),
                        y = shown.rect.min.y + static_cast<float>(at.y);
            context.items[item_name(cut_, handle)] = {x, y, x, y};
        }
        list.PushClipRect(shown.rect.min, shown.rect.max, true);
        draw_cut_handles(list, cut_, handles, which, shown, context.theme, context.scale);
        list.PopClipRect();
    }
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    if (lit && !held_cut_)
        ImGui::SetTooltip("%s", lit->turns ? "Drag to turn the plane." : "Drag to move the plane.");
}

void ViewportPane::go_home(DocumentViewport& viewport) {
    zooms_.clear();
    if (plan_ && !plan_->views.empty())
        viewport.view.set(camera_key(plan_->views.front().scene), std::string());
    spun_ = 0;
    planner_.forget_home();
}

void ViewportPane::look_as(DocumentViewport& viewport, const std::string& camera) {
    viewport.view.set(plan_ && !plan_->views.empty() ? camera_key(plan_->views.front().scene) : "camera",
                      camera);
    spun_ = 0;
}

/// Rotates a mesh in space, except while the mouse drags it. When the rotation stops, the camera keeps it.
void ViewportPane::turn(Values& view) {
    const PlannedView& front = plan_->views.front();
    spinning_ = false;
    if (front.scene.planar()) return; // a projection does not rotate; the globe continues later
    const double rate = view.real("spin") * std::numbers::pi / 180;
    const std::string from = view.text(camera_key(front.scene)) + view.text("direction");
    if (from != spun_from_) spun_ = 0;
    spun_from_ = from;
    if (rate == 0 && spun_ != 0) set_camera(view, front, front.camera);
    spinning_ = rate != 0;
    constexpr double longest = 0.1; // seconds; longer if no frame was drawn
    if (rate != 0 && !dragging_)
        spun_ += rate * std::min(longest, static_cast<double>(ImGui::GetIO().DeltaTime));
    planner_.turn_by(spun_);
}

std::string ViewportPane::camera_text() const {
    if (!plan_ || plan_->views.empty()) return {};
    return format_camera(plan_->views.front().camera, plan_->views.front().size());
}

void ViewportPane::fix_range(DocumentViewport& viewport) const {
    if (!plan_) return;
    ColourRange range;
    if (!plan_->plots.empty()) {
        const PlannedPlot& plot = plan_->plots.front();
        const AxisRange shown = plot.zoom.y ? *plot.zoom.y : home_range(plot.view, true);
        range.low = from_axis(plot.view.y, shown.low), range.high = from_axis(plot.view.y, shown.high);
    } else if (const auto& colouring = plan_->colouring) {
        range = colouring->range;
    } else {
        return;
    }
    if (!(range.low < range.high)) return;
    viewport.view.set("range", std::string("fixed"));
    viewport.view.set("low", range.low);
    viewport.view.set("high", range.high);
}

void ViewportPane::set_camera(Values& view, const PlannedView& shown, Camera camera) {
    if (camera == shown.camera && spun_ == 0) return;
    // A camera that shows the whole ball still does so when the size of the view changes.
    const std::string before = view.text(camera_key(shown.scene));
    const bool whole = (before.empty() || shows_all(before)) && only_rotated(shown, camera);
    if (shown.rear) camera = from_behind(camera, pivot_of(shown.scene));
    view.set(camera_key(shown.scene), whole ? format_axes(camera) : format_camera(camera, shown.size()));
    spun_ = 0;
}

/// Drags pan or rotate, the wheel zooms at the pointer, a click picks, a double click centres a point.
void ViewportPane::steer(Values& view, float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    if (ImGui::IsItemActive()) {
        const int button = held_button();
        const float far = drag_threshold * scale;
        const bool begins = button >= 0 && !dragging_ && io.MouseDragMaxDistanceSqr[button] > far * far;
        // The first step includes the motion before it was clear that this is no click.
        if (button >= 0 && (begins || dragging_))
            drag(view, view_at(*plan_, io.MouseClickedPos[button]), button,
                 dragging_ ? io.MouseDelta : ImGui::GetMouseDragDelta(button, 0));
        dragging_ = dragging_ || begins;
    }
    const PlannedView& under = view_at(*plan_, io.MousePos);
    if (hovered && io.MouseWheel != 0) {
        Camera camera = under.camera;
        zoom(camera, under.size(), pixel_in(under, io.MousePos),
             std::pow(wheel_factor, static_cast<double>(io.MouseWheel)), under.scene.box);
        set_camera(view, under, camera);
    }
    if (hovered && ImGui::IsMouseDoubleClicked(0)) {
        const Pixel pointer = pixel_in(under, io.MousePos);
        const auto hit = pick_at(under.scene, under.camera, under.size(), pointer, 0);
        Camera camera = under.camera;
        if (under.scene.ball > 0 && hit)
            recentre(camera, under, hit->where);
        else
            camera.centre = hit ? hit->where : to_world(camera, under.size(), pointer);
        set_camera(view, under, camera);
        view.set("pick", picked_before_);
        dragging_ = true; // the button's release is no click
    }
    if (!ImGui::IsItemDeactivated()) return;
    const ImVec2 clicked = io.MouseClickedPos[0];
    const float x = io.MousePos.x - clicked.x, y = io.MousePos.y - clicked.y;
    const bool moved = x * x + y * y > drag_threshold * drag_threshold * scale * scale;
    if (!dragging_ && ImGui::IsMouseReleased(0) && moved) { // a drag within one frame
        drag(view, view_at(*plan_, clicked), 0, {x, y});
    } else if (!dragging_ && hovered && ImGui::IsMouseReleased(0)) {
        picked_before_ = view.text("pick");
        click(view, under, pixel_in(under, io.MousePos), scale);
    }
    dragging_ = false;
}

void ViewportPane::drag(Values& view, const PlannedView& shown, int button, ImVec2 step) {
    const ImGuiIO& io = ImGui::GetIO();
    const Pixel by{static_cast<double>(step.x), static_cast<double>(step.y)};
    Camera camera = shown.camera;
    if (shown.scene.planar() || button != 0 || io.KeyShift) {
        pan(camera, by);
    } else if (shown.scene.ball > 0) {
        const Pixel to = pixel_in(shown, io.MousePos);
        turn_ball(camera, shown.size(), {to.x - by.x, to.y - by.y}, to, pivot_of(shown.scene),
                  shown.scene.ball);
    } else {
        // A mesh rotates about its middle while that is visible.
        const Vec3 middle = shown.scene.box.centre();
        const Pixel seen = to_pixel(camera, shown.size(), middle);
        const bool visible =
            seen.x >= 0 && seen.y >= 0 && seen.x <= shown.size().width && seen.y <= shown.size().height;
        rotate(camera, shown.size(), by, visible ? middle : camera.centre);
    }
    set_camera(view, shown, camera);
}

void ViewportPane::click(Values& view, const PlannedView& shown, Pixel pointer, float scale) {
    const auto hit =
        pick_at(shown.scene, shown.camera, shown.size(), pointer, pick_reach * static_cast<double>(scale));
    view.set("pick", hit ? format_pick(hit->pick) : std::string());
}

} // namespace gaspard
