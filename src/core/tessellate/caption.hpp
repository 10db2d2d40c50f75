// What the caption of a picture says of an iterate.
#pragma once

#include "core/session/snapshot.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// "plane, ring", "iteration 52", "residual 9.8×10⁻⁹", "equidistribution 0.0367", "converged". `subject`
/// names what is solved; it may be empty. An iterate before the last has no status; if `last_iteration` is
/// given, it is "iteration 12 of 52".
std::vector<std::string> caption_parts(const std::string& subject, const StepReport& report,
                                       int last_iteration = 0);

} // namespace gaspard
