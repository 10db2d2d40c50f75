// The energy errors of an error study as a table, which fills while one watches.
#pragma once

#include "gui/base/item_rectangles.hpp"
#include "gui/document/error_study.hpp"

namespace gaspard {

/// Draws into the current ImGui window: a row per value of what varies, a column per line. Notes
/// "errors.0.1" of the cell in the first row and the second line, once its run is done.
void draw_error_table(const ErrorStudy& study, ItemRectangles& items);

} // namespace gaspard
