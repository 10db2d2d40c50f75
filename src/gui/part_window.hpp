// An ImGui window that is a fixed part of the layout.
#pragma once

#include "gui/item_rectangles.hpp"

#include <algorithm>
#include <imgui.h>

namespace gaspard {

/// Begins a window that fills a part of the layout; ImGui::End() ends it.
inline void begin_part(const char* name, const ItemRectangle& part,
                       ImGuiWindowFlags flags = ImGuiWindowFlags_NoScrollbar |
                                                ImGuiWindowFlags_NoScrollWithMouse) {
    constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
    ImGui::SetNextWindowPos({part.left, part.top});
    ImGui::SetNextWindowSize({std::max(1.0F, part.width()), std::max(1.0F, part.height())});
    ImGui::Begin(name, nullptr, fixed | flags);
}

} // namespace gaspard
