#pragma once

#include "core/scenario/scenario.hpp"

namespace gaspard {

/// As a scenario of its own, such as one that is written to a file: title and description end with
/// " (modified)" if it was modified.
Scenario with_own_names(Scenario scenario);

} // namespace gaspard
