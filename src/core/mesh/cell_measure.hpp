// Tangents of a cell at a point, and the signed length, area or volume that they span.
#pragma once

#include "core/mesh/mesh.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace gaspard {

/// dx/ds, dx/dt and dx/du at a point of the reference cell; zero beyond the cell's dimension.
using Tangents = std::array<Vec3, 3>;

/// `node(k)` is the position of the cell's node k, `gradients` (nodes per cell) those of the shape functions.
template <class Node>
Tangents cell_tangents(int dimension, std::span<const Vec3> gradients, const Node& node) {
    Tangents t{};
    const Vec3 origin = node(0); // the gradients add up to zero; this keeps digits far from the origin
    for (std::size_t k = 0; k < gradients.size(); ++k) {
        const Vec3 g = gradients[k], p = node(k) - origin;
        t[0] = t[0] + g.x * p;
        if (dimension > 1) t[1] = t[1] + g.y * p;
        if (dimension > 2) t[2] = t[2] + g.z * p;
    }
    return t;
}

/// |dx/ds|, |dx/ds x dx/dt| or det dx/d(s,t,u). Of a line, and of a surface in space, the sign is negative
/// where it faces away from `reference`.
inline double signed_measure(int dimension, int space_dimension, const Tangents& of,
                             const Tangents& reference) {
    if (dimension == 2 && space_dimension == 2) return of[0].x * of[1].y - of[0].y * of[1].x;
    if (dimension == 1) return std::copysign(norm(of[0]), dot(of[0], reference[0]));
    const Vec3 normal = cross(of[0], of[1]);
    if (dimension == 3) return dot(normal, of[2]);
    return std::copysign(norm(normal), dot(normal, cross(reference[0], reference[1])));
}

/// The largest reference measure, relative to that of the whole cell, of a point at which the computational
/// cell counts as degenerate: its edge is a single point there, or its edges are parallel, which polynomials
/// reproduce to their order only. The ratio of measures says nothing at such a point.
inline constexpr double degenerate_measure = 1e-2;

} // namespace gaspard
