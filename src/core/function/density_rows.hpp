// Parameter rows that densities from pictures and from fields share.
#pragma once

#include "core/base/parameter.hpp"

#include <string>

namespace gaspard {

ParameterRow contrast_row(const std::string& help);
ParameterRow invert_row(const std::string& help);
ParameterRow gamma_row(const std::string& help);
/// Without a unit, which the caller adds.
ParameterRow blur_row();

} // namespace gaspard
