// Points that are dragged in the window, such as the control points of a planar patch or the corners of a
// quadrilateral, as the text of a scenario value: "x y, x y, ...", of a patch the
// first direction fastest.
#pragma once

#include "core/base/points.hpp"

#include <string>
#include <string_view>

namespace gaspard {

/// Throws InputError, with the key, unless the text is a list of points of two finite numbers.
Points parse_points(std::string_view text, const std::string& key);
/// Throws InputError, with the key and what it belongs to, unless the text lists exactly `count` points of
/// two finite numbers.
Points parse_control_points(std::string_view text, std::size_t count,
                            const std::string& key = "domain.control_points",
                            const std::string& owner = "the patch");
/// The inverse of parse_control_points; numbers read back to the same doubles.
std::string format_control_points(const Points& control);

} // namespace gaspard
