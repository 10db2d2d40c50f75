// The stages of a derived monitor that can be looked at.
#pragma once

#include "core/base/field.hpp"

#include <vector>

namespace gaspard {

/// u, indicator, averaged and limited; the monitor itself is what follows.
std::vector<FieldInfo> derived_fields();

} // namespace gaspard
