// The sizes of the texts around the meshes of a viewport, for its planner and for drawing.
#pragma once

#include "gui/viewport/viewport.hpp"

#include <string>
#include <vector>

namespace gaspard {

// At scale 1.
constexpr float viewport_margin = 14, viewport_gap = 6;

inline float viewport_line_height() { return ImGui::GetFontSize() * 1.35F; }

/// Parts of the caption, so many to a line as fit.
std::vector<std::vector<std::string>> caption_lines(const ViewportText& text, float width, float scale);
float caption_height(const ViewportText& text, float width, float scale);
float title_height(const std::string& title, float scale);
/// What the caption leaves.
ScreenRect above_caption(const ViewportPlan& plan, float scale);

} // namespace gaspard
