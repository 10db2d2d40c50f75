#include "gui/viewport_pane.hpp"

#include "gui/part_window.hpp"
#include "gui/viewport.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace gaspard {

namespace {

Size size_of(const ItemRectangle& area) {
    return {static_cast<double>(std::max(1.0F, area.width())),
            static_cast<double>(std::max(1.0F, area.height()))};
}

} // namespace

void ViewportPane::frame(const DocumentRun& run, DocumentViewport& viewport, const ItemRectangle& area,
                         const FrameContext& context) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    begin_part("##viewport", area,
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    const Size size = size_of(area);
    ImGui::InvisibleButton("##picture", {static_cast<float>(size.width), static_cast<float>(size.height)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
    remember_item(context.items, "viewport");
    if (run.snapshot) draw_picture(run, viewport, area, context);
    ImGui::End();
}

void ViewportPane::draw_picture(const DocumentRun& run, DocumentViewport& viewport, const ItemRectangle& area,
                                const FrameContext& context) {
    const MeshPicture picture =
        maker_.make(*run.snapshot, viewport.view.text("color"), viewport.view.real("blend"));
    const ViewportText text{.title = {}, .subject = run.title, .report = {}, .caption = false};
    const Size size = size_of(area);
    // Home stays where it is while the mesh moves, lest the picture tremble.
    if (home_of_ != picture.tessellation || home_size_.width != size.width ||
        home_size_.height != size.height) {
        home_ = home(picture.box, size, viewport_insets(picture, text, size, context.scale));
        home_of_ = picture.tessellation;
        home_size_ = size;
    }
    draw_viewport_overlay(*ImGui::GetWindowDrawList(), picture, text,
                          {{area.left, area.top}, {area.right, area.bottom}}, context.theme, context.scale);
    steer_camera(viewport, area, picture);
    pictures_ = {{picture, viewport.camera.value_or(home_), area}};
}

void ViewportPane::go_home(DocumentViewport& viewport) {
    viewport.camera.reset();
    home_of_.reset();
}

/// Left or middle drag pans, the wheel zooms to the pointer, a double click goes home.
void ViewportPane::steer_camera(DocumentViewport& viewport, const ItemRectangle& area,
                                const MeshPicture& picture) {
    const ImGuiIO& io = ImGui::GetIO();
    const Camera before = viewport.camera.value_or(home_);
    Camera seen = before;
    if (ImGui::IsItemActive() && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
        pan(seen, {static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y)});
    if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
        const Pixel pointer{static_cast<double>(io.MousePos.x - area.left),
                            static_cast<double>(io.MousePos.y - area.top)};
        zoom(seen, size_of(area), pointer, std::pow(1.15, static_cast<double>(io.MouseWheel)), picture.box);
    }
    if (seen != before) viewport.camera = seen;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) go_home(viewport);
}

} // namespace gaspard
