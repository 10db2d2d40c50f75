#include "gui/base/item_rectangles.hpp"

#include <imgui.h>

namespace gaspard {

void remember_item(ItemRectangles& items, const std::string& key) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    items[key] = {low.x, low.y, high.x, high.y};
}

} // namespace gaspard
