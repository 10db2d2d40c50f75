// A number as one wide field: its label at the left, its value at the right, and a fill as wide as the
// value's place within its range. Dragging along it changes the value (with Shift ten times as finely), a
// double click or a click with Ctrl asks for a text field, and arrow keys, and the wheel while the pointer is
// on it, step the field that was clicked last.
#pragma once

#include "gui/base/frame_context.hpp"

#include <optional>
#include <string>

namespace gaspard {

struct ValueField {
    std::string label, symbol, value;
    std::optional<double> position{}; ///< within the range, 0 to 1; empty: it cannot be dragged
    bool focused = false;             ///< it was clicked last
    bool keys = true;                 ///< then keys step it
    bool wheel = true;                ///< and so does the wheel
};

struct ValueFieldAnswer {
    std::optional<double> position{}; ///< the new one
    int steps = 0;                    ///< of wheel and keys
    bool type = false;                ///< a text field is asked for
    bool clicked = false, hovered = false;
};

/// An item of this width and of the height of a frame.
ValueFieldAnswer draw_value_field(const char* id, const ValueField& field, float width, const Theme& theme);

} // namespace gaspard
