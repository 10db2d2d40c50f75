// Elements on meshes of disks and other convex domains.
#pragma once

#include "core/transport/lagrange_triangles.hpp"
#include "core/transport/ring_mesh.hpp"

#include <cmath>
#include <memory>
#include <numbers>

namespace gaspard {

inline LagrangeTriangles elements_on(const std::shared_ptr<const ConvexCurve>& curve, int rings, int degree,
                                     bool curved) {
    const RingMesh mesh = ring_mesh(*curve, rings);
    BoundarySides boundary{.nodes = mesh.boundary_nodes};
    if (curved)
        boundary.point = [&](std::size_t side, double s) {
            const auto& t = mesh.boundary_parameters;
            return curve->point(t[side] + s * ((side + 1 < t.size() ? t[side + 1] : t[0] + 1) - t[side]));
        };
    return {mesh.mesh, boundary, degree};
}

inline LagrangeTriangles disk_elements(int rings, int degree, bool curved) {
    return elements_on(ellipse({}, 1, 1), rings, degree, curved);
}

} // namespace gaspard
