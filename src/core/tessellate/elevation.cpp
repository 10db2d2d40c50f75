#include "core/tessellate/elevation.hpp"

#include "core/base/box.hpp"
#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

std::vector<double> elevations(const Mesh& mesh, const Colouring& colouring, double factor) {
    const bool plane = mesh.space_dimension == 2 && cell_dimension(mesh.kind) == 2;
    if (!plane || factor == 0 || colouring.place != FieldPlace::node) return {};
    if (!(colouring.range.low < colouring.range.high)) return {};
    GASPARD_CHECK(colouring.values.size() == mesh.node_count());
    const double highest = factor * longest_side(bounding_box(mesh.nodes)) / 2;
    std::vector<double> z;
    z.reserve(colouring.values.size());
    for (const double value : colouring.values) {
        const double place = std::isfinite(value) ? colouring.range.position(value) : 0;
        z.push_back(highest * std::clamp(place, 0.0, 1.0));
    }
    return z;
}

Points raised(Points points, const std::vector<double>& z) {
    if (z.empty()) return points;
    GASPARD_CHECK(z.size() == points.size());
    points.z = z;
    return points;
}

} // namespace gaspard
