#include "gui/app/edges.hpp"

#include "gui/base/part_window.hpp"
#include "gui/base/settings.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace gaspard {

namespace {

/// How a position of the pointer gives a setting: 0 at `zero`, 1 a `span` farther, along x or y.
struct EdgeTravel {
    bool horizontal = true;
    float zero = 0, span = 1;
};

void draw_edge(const char* name, const ItemRectangle& edge, const EdgeTravel& travel, Values& settings,
               const char* setting, const FrameContext& context) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    begin_part(name, edge, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar, true);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton(name, {std::max(1.0F, edge.width()), std::max(1.0F, edge.height())});
    remember_item(context.items, name);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(travel.horizontal ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled({edge.left, edge.top}, {edge.right, edge.bottom},
                                                  packed(context.theme.accent, 0.5F));
    }
    if (ImGui::IsItemActive() && travel.span != 0) {
        const ImVec2 pointer = ImGui::GetIO().MousePos;
        const double value =
            static_cast<double>(((travel.horizontal ? pointer.x : pointer.y) - travel.zero) / travel.span);
        if (std::isfinite(value)) settings.set(setting, within(settings, setting, value));
    }
    ImGui::End();
}

} // namespace

void draw_edges(const Layout& layout, Values& settings, const FrameContext& context) {
    const float right = ImGui::GetIO().DisplaySize.x, bottom = layout.second_plot.bottom;
    if (layout.sidebar.width() > 0)
        draw_edge("edge.sidebar", layout.sidebar_edge, {true, 0, ImGui::GetFontSize()}, settings,
                  "sidebar_width", context);
    if (!settings.boolean("plots")) return;
    const EdgeTravel travel = layout.plots_beside ? EdgeTravel{true, right, layout.sidebar.width() - right}
                                                  : EdgeTravel{false, bottom, layout.viewport.top - bottom};
    draw_edge("edge.plots", layout.plots_edge, travel, settings, "plots_share", context);
}

} // namespace gaspard
