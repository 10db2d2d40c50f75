// The control points of a planar patch as the text of a scenario value: "x y, x y, ...", first direction
// fastest. Dragging a point in the window writes it.
#pragma once

#include "core/base/points.hpp"

#include <string>
#include <string_view>

namespace gaspard {

/// Throws InputError unless the text lists exactly `count` points of two finite numbers.
Points parse_control_points(std::string_view text, std::size_t count);
/// The inverse of parse_control_points; numbers read back to the same doubles.
std::string format_control_points(const Points& control);

} // namespace gaspard
