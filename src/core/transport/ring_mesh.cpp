#include "core/transport/ring_mesh.hpp"

#include "core/base/check.hpp"
#include "core/transport/delaunay_flips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gaspard {

namespace {

/// The number of the first node of ring i.
std::int32_t ring_start(std::int32_t i) { return i == 0 ? 0 : 1 + 3 * i * (i - 1); }

/// Between rings i - 1 and i: per sixth, i triangles with an edge on ring i and i - 1 with one on ring i - 1.
void add_ring(std::vector<std::int32_t>& cells, std::int32_t i) {
    const auto outer = [&](std::int32_t j) { return ring_start(i) + j % (6 * i); };
    const auto inner = [&](std::int32_t j) { return i == 1 ? 0 : ring_start(i - 1) + j % (6 * (i - 1)); };
    for (std::int32_t sixth = 0; sixth < 6; ++sixth)
        for (std::int32_t k = 0; k < i; ++k) {
            const std::int32_t j = sixth * i + k, below = sixth * (i - 1) + k;
            cells.insert(cells.end(), {inner(below), outer(j), outer(j + 1)});
            if (k + 1 < i) cells.insert(cells.end(), {inner(below), outer(j + 1), inner(below + 1)});
        }
}

} // namespace

RingMesh ring_mesh(const ConvexCurve& curve, int rings) {
    GASPARD_CHECK(rings >= 1);
    RingMesh result;
    Mesh& mesh = result.mesh;
    mesh.kind = {CellShape::triangle, 1};
    mesh.nodes = Points(static_cast<std::size_t>(ring_start(rings + 1)));
    mesh.nodes.set(0, curve.centre());
    for (std::int32_t i = 1; i <= rings; ++i) {
        for (std::int32_t j = 0; j < 6 * i; ++j) {
            const double t = j / (6.0 * i);
            const Vec3 p = curve.point(t);
            const std::int32_t node = ring_start(i) + j;
            mesh.nodes.set(
                static_cast<std::size_t>(node),
                i == rings ? p : curve.centre() + static_cast<double>(i) / rings * (p - curve.centre()));
            if (i < rings) continue;
            result.boundary_nodes.push_back(node);
            result.boundary_parameters.push_back(t);
        }
        add_ring(mesh.cells, i);
    }
    flip_to_delaunay(mesh);
    return result;
}

TriangleQuality triangle_quality(const Mesh& mesh) {
    GASPARD_CHECK(mesh.kind == (CellKind{CellShape::triangle, 1}));
    TriangleQuality quality{180, 0, 0, std::numeric_limits<double>::infinity()};
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto corner = [&](std::size_t i) {
                return mesh.nodes[static_cast<std::size_t>(mesh.cell(c)[(k + i) % 3])];
            };
            const Vec3 a = corner(1) - corner(0), b = corner(2) - corner(0);
            const double angle = std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
            quality.smallest_angle = std::min(quality.smallest_angle, angle);
            quality.largest_angle = std::max(quality.largest_angle, angle);
            quality.longest_edge = std::max(quality.longest_edge, norm(a));
            quality.shortest_edge = std::min(quality.shortest_edge, norm(a));
        }
    return quality;
}

} // namespace gaspard
