// Meshes between the computational (λ = 0) and the physical one (λ = 1), as view.blend says.
#pragma once

#include "core/tessellate/ticks.hpp"

#include <string>

namespace gaspard {

/// xi + lambda (x - xi), exact at both ends.
inline double blended(double xi, double x, double lambda) {
    return lambda == 1 ? x : lambda == 0 ? xi : (1 - lambda) * xi + lambda * x;
}

/// "physical", "λ = 0.5"
inline std::string blend_title(double blend) {
    return blend == 1 ? "physical" : "λ = " + short_number(blend, 3);
}

} // namespace gaspard
