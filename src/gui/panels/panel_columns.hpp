// The columns of a parameter panel.
#pragma once

#include <algorithm>
#include <imgui.h>

namespace gaspard {

/// Columns of a row, in window coordinates, scaled by the font: numbers begin at `field`, and other controls,
/// beside their labels, at `control`; both end at `end`, before the reset button.
struct PanelColumns {
    float field, control, end, reset;
    float wide() const { return std::max(1.0F, end - control); }
};

inline PanelColumns columns() {
    const float em = ImGui::GetFontSize();
    PanelColumns c{};
    c.reset = ImGui::GetWindowContentRegionMax().x - 1.35F * em;
    c.field = ImGui::GetWindowContentRegionMin().x;
    c.end = c.reset - 0.25F * em;
    c.control = c.field + std::min(7.4F * em, 0.45F * (c.end - c.field));
    return c;
}

} // namespace gaspard
