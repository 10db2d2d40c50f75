// Rows that the dialogs of figures and films have in common: labels in one column, numbers, parts of a view.
#pragma once

#include "core/base/parameter.hpp"
#include "gui/base/item_rectangles.hpp"

#include <string>

namespace gaspard {

inline constexpr double least_image_pixels = 64, most_image_pixels = 8192; // as view.width

/// Begins a row: what follows stands in a column of its own.
void label_before(const char* label);
/// A field for a number, in a usual width; true when it was changed. `format` as of printf.
bool number_field(const char* id, double& value, const char* format);
/// Check boxes for axes, legend, caption and notes of a view. Keys "KEYS.axes", "KEYS.legend",
/// "KEYS.caption", "KEYS.note".
void draw_shown_parts(Values& view, const std::string& keys, ItemRectangles& items);

} // namespace gaspard
