// The rows of the section "view": how a viewport shows a run.
#pragma once

#include "core/base/parameter.hpp"

#include <vector>

namespace gaspard {

std::vector<ParameterRow> view_rows();

} // namespace gaspard
