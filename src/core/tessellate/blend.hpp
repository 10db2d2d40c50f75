// Meshes between the computational (t = 0) and the physical one (t = 1), as view.blend says.
#pragma once

#include "core/tessellate/ticks.hpp"

#include <string>

namespace gaspard {

/// xi + t (x - xi), exact at both ends.
inline double blended(double xi, double x, double t) {
    return t == 1 ? x : t == 0 ? xi : (1 - t) * xi + t * x;
}

/// "physical", "t = 0.5"
inline std::string blend_title(double t) { return t == 1 ? "physical" : "t = " + short_number(t, 3); }

} // namespace gaspard
