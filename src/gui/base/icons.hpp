// The small signs on buttons, drawn as lines so that no font need have them.
#pragma once

#include <imgui.h>

namespace gaspard {

enum class Icon { none, run, pause, step, reset, home, image, save };

/// Within a square of `size` around `center`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 colour);

/// A button with a sign before its label; `width` 0 fits it. True when pressed.
bool icon_button(const char* id, Icon icon, const char* label, float width = 0);

} // namespace gaspard
