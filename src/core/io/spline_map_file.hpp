// map.json: the adapted map of a spline patch, its components each with degrees, knots and coefficients.
#pragma once

#include "core/method/method.hpp"

#include <optional>
#include <string>

namespace gaspard {

/// Nothing for states that are not of a patch. Numbers read back to the same doubles.
std::optional<std::string> spline_map_json(const State& state);

} // namespace gaspard
