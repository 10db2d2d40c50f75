// The icons of buttons, drawn as lines, so that they do not depend on a font.
#pragma once

#include <imgui.h>

namespace gaspard {

enum class Icon {
    none,
    run,
    pause,
    step,
    back,
    to_start,
    to_end,
    loop,
    blend,
    reset,
    home,
    image,
    film,
    save,
    undo,
    redo
};

/// Within a square of `size` around `center`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 colour);

/// A button with an icon before its label, which may be empty; `width` 0 fits the label. True when pressed.
bool icon_button(const char* id, Icon icon, const char* label, float width = 0);
/// How wide it is with this label.
float icon_button_width(const char* label);

/// An eye as a button, an open one or one crossed out. True when pressed.
bool eye_button(const char* id, bool crossed, ImU32 colour, ImU32 hovered);

} // namespace gaspard
