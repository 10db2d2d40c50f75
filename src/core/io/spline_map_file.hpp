// map.json: the adapted map of a spline patch; degrees, knots and coefficients of each component.
#pragma once

#include "core/method/method.hpp"

#include <optional>
#include <string>

namespace gaspard {

/// nullopt for states of other domains. Numbers read back to the same doubles.
std::optional<std::string> spline_map_json(const State& state);

} // namespace gaspard
