#include "gui/viewport_pane.hpp"

#include "gui/part_window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>
#include <numbers>

namespace gaspard {

namespace {

constexpr float drag_threshold = 4; // pixels at scale 1: less is a click
constexpr double pick_reach = 8;    // likewise
constexpr double wheel_factor = 1.15;

Pixel pixel_in(const PlannedPicture& shown, ImVec2 mouse) {
    return {static_cast<double>(mouse.x - shown.rect.min.x), static_cast<double>(mouse.y - shown.rect.min.y)};
}

/// The picture that a position belongs to; of those beside each other the nearer one.
const PlannedPicture& picture_at(const ViewportPlan& plan, ImVec2 at) {
    const auto away = [at](const PlannedPicture& shown) {
        const ScreenRect& r = shown.rect;
        return std::max({r.min.x - at.x, at.x - r.max.x, r.min.y - at.y, at.y - r.max.y});
    };
    return *std::min_element(plan.pictures.begin(), plan.pictures.end(),
                             [&](const auto& a, const auto& b) { return away(a) < away(b); });
}

/// A point of a ball comes to face the viewer. A ball that is seen whole stays where it is in the picture;
/// of one that is not the point comes to the middle.
void recentre(Camera& camera, const PlannedPicture& shown, Vec3 where) {
    const Vec3 pivot = pivot_of(shown.picture);
    bring_to_front(camera, where, pivot);
    const double across = 2 * shown.picture.ball / camera.scale;
    if (across > std::min(shown.size().width, shown.size().height)) camera.centre = pivot;
}

/// The button that is held; -1 for none.
int held_button() {
    for (const int button : {0, 1, 2})
        if (ImGui::IsMouseDown(button)) return button;
    return -1;
}

} // namespace

void ViewportPane::frame(const DocumentRun& run, DocumentViewport& viewport, const ItemRectangle& area,
                         const FrameContext& context) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    begin_part("##viewport", area,
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    ImGui::InvisibleButton("##picture", {std::max(1.0F, area.width()), std::max(1.0F, area.height())},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                               ImGuiButtonFlags_MouseButtonRight);
    remember_item(context.items, "viewport");
    if (plan_) steer(viewport.view, context.scale), turn(viewport.view);
    if (run.snapshot) {
        const ViewportText text{.title = {}, .subject = run.title, .report = {}, .caption = false};
        plan_ = planner_.plan(*run.snapshot, viewport.view, text,
                              {{area.left, area.top}, {area.right, area.bottom}}, context.scale);
        draw_viewport_overlay(*ImGui::GetWindowDrawList(), *plan_, context.theme, context.scale);
        pictures_.clear();
        for (const PlannedPicture& shown : plan_->pictures)
            pictures_.push_back({shown.picture,
                                 shown.camera,
                                 {shown.rect.min.x, shown.rect.min.y, shown.rect.max.x, shown.rect.max.y}});
    }
    ImGui::End();
}

void ViewportPane::go_home(DocumentViewport& viewport) {
    if (plan_) viewport.view.set(camera_key(plan_->pictures.front().picture), std::string());
    spun_ = 0;
    planner_.forget_home();
}

void ViewportPane::look_as(DocumentViewport& viewport, const std::string& camera) {
    viewport.view.set(plan_ ? camera_key(plan_->pictures.front().picture) : "camera", camera);
    spun_ = 0;
}

/// A mesh in space goes on turning, unless the mouse holds it; where it stops it stays.
void ViewportPane::turn(Values& view) {
    const PlannedPicture& front = plan_->pictures.front();
    const double rate = front.picture.planar() ? 0 : view.real("spin") * std::numbers::pi / 180;
    const std::string from = view.text("camera") + view.text("direction");
    if (from != spun_from_) spun_ = 0;
    spun_from_ = from;
    if (rate == 0 && spun_ != 0) set_camera(view, front, front.camera);
    spinning_ = rate != 0;
    constexpr double longest = 0.1; // seconds; more has passed only where nothing was drawn
    if (rate != 0 && !dragging_)
        spun_ += rate * std::min(longest, static_cast<double>(ImGui::GetIO().DeltaTime));
    planner_.turn_by(spun_);
}

std::string ViewportPane::camera_text() const {
    if (!plan_) return {};
    return format_camera(plan_->pictures.front().camera, plan_->pictures.front().size());
}

void ViewportPane::fix_range(DocumentViewport& viewport) const {
    if (!plan_ || plan_->pictures.front().picture.colouring == nullptr) return;
    const ColourRange& range = plan_->pictures.front().picture.colouring->range;
    if (!(range.low < range.high)) return;
    viewport.view.set("range", std::string("fixed"));
    viewport.view.set("low", range.low);
    viewport.view.set("high", range.high);
}

void ViewportPane::set_camera(Values& view, const PlannedPicture& shown, Camera camera) {
    if (camera == shown.camera && spun_ == 0) return;
    if (shown.rear) camera = from_behind(camera, pivot_of(shown.picture));
    view.set(camera_key(shown.picture), format_camera(camera, shown.size()));
    spun_ = 0;
}

/// Drags pan or turn, the wheel zooms to the pointer, a click picks, a double click brings a point to the
/// middle.
void ViewportPane::steer(Values& view, float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    if (ImGui::IsItemActive()) {
        const int button = held_button();
        const float far = drag_threshold * scale;
        const bool begins = button >= 0 && !dragging_ && io.MouseDragMaxDistanceSqr[button] > far * far;
        if (begins || dragging_) drag(view, picture_at(*plan_, io.MouseClickedPos[std::max(0, button)]));
        dragging_ = dragging_ || begins;
    }
    const PlannedPicture& under = picture_at(*plan_, io.MousePos);
    if (hovered && io.MouseWheel != 0) {
        Camera camera = under.camera;
        zoom(camera, under.size(), pixel_in(under, io.MousePos),
             std::pow(wheel_factor, static_cast<double>(io.MouseWheel)), under.picture.box);
        set_camera(view, under, camera);
    }
    if (hovered && ImGui::IsMouseDoubleClicked(0)) {
        const Pixel pointer = pixel_in(under, io.MousePos);
        const auto hit = pick_at(under.picture, under.camera, under.size(), pointer, 0);
        Camera camera = under.camera;
        if (under.picture.ball > 0 && hit)
            recentre(camera, under, hit->where);
        else
            camera.centre = hit ? hit->where : to_world(camera, under.size(), pointer);
        set_camera(view, under, camera);
        view.set("pick", picked_before_);
        dragging_ = true; // the button's release is no click
    }
    if (!ImGui::IsItemDeactivated()) return;
    if (!dragging_ && hovered && ImGui::IsMouseReleased(0)) {
        picked_before_ = view.text("pick");
        click(view, under, pixel_in(under, io.MousePos), scale);
    }
    dragging_ = false;
}

void ViewportPane::drag(Values& view, const PlannedPicture& shown) {
    const ImGuiIO& io = ImGui::GetIO();
    const int button = held_button();
    if (button < 0) return;
    // What was held back until it was clear that this is no click comes with the first step.
    const ImVec2 step = dragging_ ? io.MouseDelta : ImGui::GetMouseDragDelta(button, 0);
    const Pixel by{static_cast<double>(step.x), static_cast<double>(step.y)};
    Camera camera = shown.camera;
    if (shown.picture.planar() || button != 0 || io.KeyShift) {
        pan(camera, by);
    } else if (shown.picture.ball > 0) {
        const Pixel to = pixel_in(shown, io.MousePos);
        turn_ball(camera, shown.size(), {to.x - by.x, to.y - by.y}, to, pivot_of(shown.picture),
                  shown.picture.ball);
    } else {
        // A mesh turns about its own middle as long as that is to be seen.
        const Vec3 middle = shown.picture.box.centre();
        const Pixel seen = to_pixel(camera, shown.size(), middle);
        const bool visible =
            seen.x >= 0 && seen.y >= 0 && seen.x <= shown.size().width && seen.y <= shown.size().height;
        rotate(camera, shown.size(), by, visible ? middle : camera.centre);
    }
    set_camera(view, shown, camera);
}

void ViewportPane::click(Values& view, const PlannedPicture& shown, Pixel pointer, float scale) {
    const auto hit =
        pick_at(shown.picture, shown.camera, shown.size(), pointer, pick_reach * static_cast<double>(scale));
    view.set("pick", hit ? format_pick(hit->pick) : std::string());
}

} // namespace gaspard
