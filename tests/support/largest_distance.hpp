// The largest distance between corresponding points of two meshes.
#pragma once

#include "core/base/points.hpp"

#include <algorithm>

namespace gaspard {

inline double largest_distance(const Points& a, const Points& b) {
    double distance = 0;
    for (std::size_t i = 0; i < a.size(); ++i) distance = std::max(distance, norm(a[i] - b[i]));
    return distance;
}

} // namespace gaspard
