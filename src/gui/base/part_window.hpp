// An ImGui window that is a fixed part of the layout.
#pragma once

#include "gui/base/item_rectangles.hpp"

#include <algorithm>
#include <imgui.h>

namespace gaspard {

/// Begins a window that fills a part of the layout; ImGui::End() ends it. `above`: over other parts.
inline void begin_part(const char* name, const ItemRectangle& part,
                       ImGuiWindowFlags flags = ImGuiWindowFlags_NoScrollbar |
                                                ImGuiWindowFlags_NoScrollWithMouse,
                       bool above = false) {
    constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                       ImGuiWindowFlags_NoFocusOnAppearing; // what is dragged stays so
    // ImGui puts such a window behind all others when it is made, which is where parts belong.
    if (!above) flags |= ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImGui::SetNextWindowPos({part.left, part.top});
    ImGui::SetNextWindowSize({std::max(1.0F, part.width()), std::max(1.0F, part.height())});
    ImGui::Begin(name, nullptr, fixed | flags);
}

} // namespace gaspard
