// The rows of the section "output": what a run writes, and what the window exports.
#pragma once

#include "core/base/parameter.hpp"

#include <vector>

namespace gaspard {

std::vector<ParameterRow> output_rows();

} // namespace gaspard
