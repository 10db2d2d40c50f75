#include "gui/viewport/cut_handles.hpp"

#include "gui/viewport/handles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

namespace {

constexpr std::array<Vec3, 3> box_axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr double snapping = 0.9976; // cosine of four degrees

bool across_axis(const CutPlane& plane) {
    return std::any_of(box_axes.begin(), box_axes.end(),
                       [&](Vec3 axis) { return std::abs(dot(plane.normal, axis)) > 1 - 1e-12; });
}

std::vector<Vec3> box_corners(const Box& box) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back({(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                           (i & 4) != 0 ? box.high.z : box.low.z});
    return corners;
}

/// How far a plane is to move along its normal for a step on the screen.
double step_along(Vec3 normal, Vec3 step, Vec3 viewer, Vec3 up) {
    const Vec3 seen = normal - dot(normal, viewer) * viewer;
    const double square = dot(seen, seen);
    // Of a normal along the line of sight nothing is seen: up is away from the viewer.
    if (square < 0.03) return dot(normal, viewer) > 0 ? -dot(step, up) : dot(step, up);
    return dot(step, seen) / square;
}

CutPlane moved_along(CutPlane plane, Vec3 foot, double step, const Box& box) {
    double low = 1e300, high = -1e300;
    for (const Vec3 corner : box_corners(box)) {
        const double along = dot(plane.normal, corner - foot);
        low = std::min(low, along), high = std::max(high, along);
    }
    const Vec3 place = foot + std::clamp(step, low, high) * plane.normal;
    const double side = longest_side(box);
    plane.at = {rounded_within(side, place.x), rounded_within(side, place.y), rounded_within(side, place.z)};
    return plane;
}

CutPlane turned_to(CutPlane plane, const CutHandle& handle, Vec3 step, Vec3 viewer, double side) {
    const Vec3 arrow = handle.tip - handle.foot;
    const double length = norm(arrow);
    Vec3 across = arrow - dot(arrow, viewer) * viewer + step;
    const double away = norm(across);
    if (away > length) across = (length / away) * across;
    const double deep = std::sqrt(std::max(0.0, length * length - dot(across, across)));
    plane.normal = (1 / length) * (across + (dot(arrow, viewer) < 0 ? -deep : deep) * viewer);
    for (const Vec3 axis : box_axes)
        if (const double along = dot(plane.normal, axis); std::abs(along) > snapping)
            plane.normal = along < 0 ? -1 * axis : axis;
    const Vec3 foot = handle.foot;
    plane.at = {rounded_within(side, foot.x), rounded_within(side, foot.y), rounded_within(side, foot.z)};
    return plane;
}

} // namespace

std::vector<CutHandle> cut_handles(const std::vector<CutWedge>& cut, const PlannedView& shown,
                                   double length) {
    std::vector<CutHandle> handles;
    const Vec3 middle = shown.scene.home_box.centre();
    for (std::size_t w = 0; w < cut.size(); ++w)
        for (std::size_t p = 0; p < cut[w].size(); ++p) {
            const CutPlane& plane = cut[w][p];
            const Vec3 foot = across_axis(plane) ? middle - plane.distance(middle) * plane.normal : plane.at;
            const Vec3 tip = foot + (length * shown.camera.scale) * plane.normal;
            for (const bool turns : {true, false}) handles.push_back({w, p, turns, foot, tip});
        }
    return handles;
}

std::vector<CutWedge> with_cut_handle_at(std::vector<CutWedge> cut, const CutHandle& handle,
                                         const PlannedView& shown, Pixel from, Pixel to) {
    CutPlane& plane = cut[handle.wedge][handle.plane];
    const Box& box = shown.scene.home_box;
    const Vec3 viewer = towards_viewer(shown.camera);
    const Vec3 step = to_world(shown.camera, shown.size(), to) - to_world(shown.camera, shown.size(), from);
    if (handle.turns)
        plane = turned_to(plane, handle, step, viewer, longest_side(box));
    else
        plane = moved_along(plane, handle.foot, step_along(plane.normal, step, viewer, shown.camera.up), box);
    return cut;
}

std::vector<Vec3> plane_in_box(const CutPlane& plane, const Box& box) {
    const std::vector<Vec3> corners = box_corners(box);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 8; ++i)
        for (const std::size_t bit : {1U, 2U, 4U}) {
            if ((i & bit) != 0) continue;
            const double a = plane.distance(corners[i]), b = plane.distance(corners[i | bit]);
            if ((a < 0) != (b < 0))
                points.push_back(corners[i] + (a / (a - b)) * (corners[i | bit] - corners[i]));
        }
    if (points.size() < 3) return points;
    Vec3 middle;
    for (const Vec3 p : points) middle = middle + (1.0 / static_cast<double>(points.size())) * p;
    const Vec3 right = any_across(plane.normal), up = cross(plane.normal, right);
    const auto angle = [&](Vec3 p) { return std::atan2(dot(p - middle, up), dot(p - middle, right)); };
    std::sort(points.begin(), points.end(), [&](Vec3 a, Vec3 b) { return angle(a) < angle(b); });
    return points;
}

CutPlane usual_cut(const Box& box, Vec3 towards_viewer) {
    Vec3 best = box_axes[0];
    for (const Vec3 axis : box_axes)
        if (std::abs(dot(axis, towards_viewer)) > std::abs(dot(best, towards_viewer))) best = axis;
    const double side = longest_side(box), middle = rounded_within(side, dot(best, box.centre()));
    return {dot(best, towards_viewer) < 0 ? -1 * best : best, middle * best};
}

void draw_cut_handles(ImDrawList& list, const std::vector<CutWedge>& cut,
                      const std::vector<CutHandle>& handles, std::size_t lit, const PlannedView& shown,
                      const Theme& theme, float scale) {
    const auto on_screen = [&](Vec3 place) {
        const Pixel p = to_pixel(shown.camera, shown.size(), place);
        return ImVec2{shown.rect.min.x + static_cast<float>(p.x), shown.rect.min.y + static_cast<float>(p.y)};
    };
    if (lit < handles.size()) {
        std::vector<ImVec2> outline;
        const CutHandle& held = handles[lit];
        for (const Vec3 p : plane_in_box(cut[held.wedge][held.plane], shown.scene.home_box))
            outline.push_back(on_screen(p));
        list.AddPolyline(outline.data(), static_cast<int>(outline.size()), packed(theme.accent, 0.8F),
                         ImDrawFlags_Closed, 1.5F * scale);
    }
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const bool bright = i == lit;
        const ImVec2 foot = on_screen(handles[i].foot), tip = on_screen(handles[i].tip);
        const std::pair<float, ImU32> strokes[] = {
            {4.5F, packed(theme.background, bright ? 1.0F : 0.75F)},
            {bright ? 2.2F : 1.6F, packed(theme.accent, bright ? 1.0F : 0.9F)}};
        for (const auto& [width, ink] : strokes) {
            if (handles[i].turns) { // first, below the foot
                list.AddLine(foot, tip, ink, width * scale);
                list.AddCircleFilled(tip, ((bright ? 3.5F : 2.5F) + width / 2) * scale, ink, 20);
            } else {
                list.AddCircle(foot, (bright ? 8.0F : 6.5F) * scale, ink, 32, width * scale);
            }
        }
    }
}

std::string item_name(const std::vector<CutWedge>& cut, const CutHandle& handle) {
    std::size_t number = handle.plane;
    for (std::size_t w = 0; w < handle.wedge; ++w) number += cut[w].size();
    return "cut." + std::to_string(number) + (handle.turns ? ".tip" : ".foot");
}

} // namespace gaspard
