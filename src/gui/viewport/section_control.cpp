#include "gui/viewport/section_control.hpp"

#include "gui/viewport/handles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

namespace {

constexpr float end_reach = 11, end_radius = 5; // pixels at scale 1

/// Only where x is shown, flat.
bool shows_section(const PlannedView& shown) {
    const MeshScene& scene = shown.scene;
    return scene.planar() && scene.blend > 0 && !scene.projection && has_section_line(*scene.mesh);
}

ImVec2 on_screen_at(const PlannedView& shown, Vec3 place) {
    const Pixel p = to_pixel(shown.camera, shown.size(), place);
    return {shown.rect.min.x + static_cast<float>(p.x), shown.rect.min.y + static_cast<float>(p.y)};
}

struct LineEnd {
    const PlannedView* shown;
    std::size_t end;
};

std::optional<LineEnd> line_end_at(const ViewportPlan& plan, ImVec2 at, float scale) {
    if (!plan.section) return std::nullopt;
    const std::array<Vec3, 2> ends = {plan.section->from, plan.section->to};
    for (const PlannedView& shown : plan.views) {
        if (!shows_section(shown) || !shown.rect.contains(at)) continue;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const ImVec2 end = on_screen_at(shown, ends[i]);
            if (std::hypot(end.x - at.x, end.y - at.y) < end_reach * scale) return LineEnd{&shown, i};
        }
    }
    return std::nullopt;
}

} // namespace

void draw_section_line(ImDrawList& list, const PlannedView& shown, const SectionLine& line,
                       const Theme& theme, float scale) {
    if (!shows_section(shown)) return;
    const ImVec2 a = on_screen_at(shown, line.from), b = on_screen_at(shown, line.to);
    list.PushClipRect(shown.rect.min, shown.rect.max, true);
    list.AddLine(a, b, packed(theme.background), 4 * scale); // to be seen on any colour
    list.AddLine(a, b, packed(theme.text), 1.6F * scale);
    for (const ImVec2 end : {a, b}) list.AddCircleFilled(end, 2.5F * scale, packed(theme.text), 16);
    list.PopClipRect();
}

SectionLine usual_section_line(const MeshScene& scene) {
    const Box& box = scene.home_box;
    const double span = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    const auto rounded_place = [span](double value) { return rounded_within(span, value) + 0.0; }; // no -0
    const double y = rounded_place((box.low.y + box.high.y) / 2);
    return {{rounded_place(box.low.x), y, 0}, {rounded_place(box.high.x), y, 0}};
}

bool SectionControl::interact(Values& view, const ViewportPlan& plan, float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated()) {
        const auto found =
            ImGui::IsMouseDown(0) ? line_end_at(plan, io.MouseClickedPos[0], scale) : std::nullopt;
        held_ = found ? std::optional(found->end) : std::nullopt;
    }
    if (!held_) return false;
    if (!plan.section) {
        held_.reset();
        return false;
    }
    const ImVec2 clicked = io.MouseClickedPos[0];
    const bool moved = io.MousePos.x != clicked.x || io.MousePos.y != clicked.y;
    for (const PlannedView& shown : plan.views) {
        if (!moved || !shows_section(shown) || !shown.rect.contains(clicked)) continue;
        const Vec3 place = to_world(shown.camera, shown.size(),
                                    {static_cast<double>(io.MousePos.x - shown.rect.min.x),
                                     static_cast<double>(io.MousePos.y - shown.rect.min.y)});
        const Box& box = shown.scene.home_box;
        const double span = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
        const Vec3 end = {rounded_within(span, place.x), rounded_within(span, place.y), 0};
        SectionLine line = *plan.section;
        (*held_ == 0 ? line.from : line.to) = end;
        if (line.length() > 1e-3 * span) view.set("section", format_section_line(line));
    }
    if (!ImGui::IsItemActive()) held_.reset();
    return true;
}

void SectionControl::draw(const ViewportPlan& plan, const FrameContext& context) const {
    if (!plan.section) return;
    const auto under =
        ImGui::IsItemHovered() ? line_end_at(plan, ImGui::GetIO().MousePos, context.scale) : std::nullopt;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::array<Vec3, 2> ends = {plan.section->from, plan.section->to};
    for (const PlannedView& shown : plan.views) {
        if (!shows_section(shown)) continue;
        list.PushClipRect(shown.rect.min, shown.rect.max, true);
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const ImVec2 at = on_screen_at(shown, ends[i]);
            const bool lit = held_ ? *held_ == i : under && under->end == i;
            list.AddCircleFilled(at, (end_radius + (lit ? 2.0F : 0.0F)) * context.scale,
                                 packed(context.theme.accent), 24);
            list.AddCircle(at, (end_radius + (lit ? 2.0F : 0.0F)) * context.scale,
                           packed(context.theme.background), 24, 1.5F * context.scale);
            context.items["section." + std::to_string(i)] = {at.x, at.y, at.x, at.y};
        }
        list.PopClipRect();
    }
    if (held_ || under) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    if (under && !held_) ImGui::SetTooltip("Drag this end of the section line.");
}

/// False if there are no values.
bool SectionPlotMaker::follow(const ViewportPlan& plan) {
    if (!plan.section || plan.views.empty()) return false;
    const MeshScene& scene = plan.views.back().scene;
    if (!has_section_line(*scene.mesh) || !scene.colouring) return false;
    if (shape_ == scene.tessellation && shown_ == scene.physical && colouring_ == scene.colouring &&
        line_ == plan.section)
        return true;
    shape_ = scene.tessellation, shown_ = scene.physical, colouring_ = scene.colouring;
    line_ = plan.section;
    values_ = values_on_line(*shape_, *shown_, *colouring_, *line_);
    return true;
}

Plot SectionPlotMaker::plot(const ViewportPlan& plan) {
    if (follow(plan)) return section_line_plot(values_, *colouring_);
    Plot plot;
    const bool planar = !plan.views.empty() && has_section_line(*plan.views.front().scene.mesh);
    plot.title = !planar        ? "Only a mesh in the plane is cut by a line"
                 : plan.section ? "Without colours there are no values"
                                : "No line: view.section is empty";
    return plot;
}

std::string SectionPlotMaker::csv(const ViewportPlan& plan) {
    return follow(plan) ? section_line_csv(values_, *colouring_, *line_) : std::string();
}

} // namespace gaspard
