// Where the items of a window were drawn in the last frame, by key ("monitor.amplitude", "action.run",
// "viewport"), in window coordinates from the top left. For tests and synthetic input.
#pragma once

#include <map>
#include <string>

namespace gaspard {

struct ItemRectangle {
    float left = 0, top = 0, right = 0, bottom = 0;

    float width() const { return right - left; }
    float height() const { return bottom - top; }
    float center_x() const { return (left + right) / 2; }
    float center_y() const { return (top + bottom) / 2; }
    friend bool operator==(const ItemRectangle&, const ItemRectangle&) = default;
    bool contains(float x, float y) const { return x >= left && x < right && y >= top && y < bottom; }
};

using ItemRectangles = std::map<std::string, ItemRectangle, std::less<>>;

/// Notes where ImGui has drawn its last item.
void remember_item(ItemRectangles& items, const std::string& key);

} // namespace gaspard
