// "Why adapt?": the interpolation errors of the uniform and of the adapted mesh, as numbers.
#pragma once

#include "core/session/snapshot.hpp"
#include "gui/base/item_rectangles.hpp"

#include <string>

namespace gaspard {

enum class WhyWish {
    none,
    measure, ///< measure the errors from now on
    maps,    ///< show the errors of both meshes side by side
    factors, ///< colour the cells by how many times their error has become smaller
};

/// "4.1 times smaller", "1.3 times larger", "the same".
std::string factor_text(double ratio);

/// Draws into the current ImGui window. `snapshot` may be null. Keys "why.measure", "why.maps",
/// "why.factors", and "why.l2", "why.maximum", "why.h1" of the lines of the table.
WhyWish draw_why(const Snapshot* snapshot, bool measured, ItemRectangles& items);

} // namespace gaspard
