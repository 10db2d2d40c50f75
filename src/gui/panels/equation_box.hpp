// The equation of a section's type, typeset, and the values of its parameters by their symbols: "A = 10".
#pragma once

#include "core/base/parameter.hpp"
#include "gui/base/frame_context.hpp"

#include <string>

namespace gaspard {

/// "A = 10   B = 200   c = (0.5, 0.5)": numbers by their symbols, the coordinates of a point together; empty
/// if there are none.
std::string values_by_symbol(const Values& values);

/// The same of a monitor that moves, with its time first: "t = 0.34   A = 10   ...".
std::string values_at_time(const Values& values, double t);

/// In the current ImGui window, `width` wide, with such a text of the values below the equation. An equation
/// that is a sentence, or too wide, is written as text; with `or_text` false, nothing is drawn then.
void draw_equation_box(const std::string& equation, const std::string& values, float width,
                       const Theme& theme, bool or_text = true);

} // namespace gaspard
