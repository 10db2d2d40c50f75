// A rectangle on the screen in ImGui's coordinates, y downwards.
#pragma once

#include <imgui.h>

namespace gaspard {

struct ScreenRect {
    ImVec2 min, max;
    float width() const { return max.x - min.x; }
    float height() const { return max.y - min.y; }
    bool contains(ImVec2 p) const { return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y; }
};

} // namespace gaspard
