// Control points of a patch in the plane as a value of a scenario: "x y, x y, ...", fastest in the first
// direction. The window writes it when a point is dragged.
#pragma once

#include "core/base/points.hpp"

#include <string>
#include <string_view>

namespace gaspard {

/// Throws InputError where the text is not `count` points of two finite numbers.
Points parse_control_points(std::string_view text, std::size_t count);
/// Reads back to the same doubles.
std::string format_control_points(const Points& control);

} // namespace gaspard
