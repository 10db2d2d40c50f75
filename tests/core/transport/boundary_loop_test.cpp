// Meshes of convex domains are taken in, others are refused with the reason.
#include "core/base/error.hpp"
#include "core/transport/boundary_loop.hpp"
#include "core/transport/ring_mesh.hpp"
#include "support/convex_curves.hpp"
#include "support/messages.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

using NodeNumbers = std::vector<std::int32_t>;

Mesh triangles_of(std::initializer_list<Vec3> nodes, NodeNumbers cells) {
    return mesh_of({CellShape::triangle, 1}, 2, nodes, std::move(cells));
}

std::string refusal(const Mesh& mesh) {
    return message_of<InputError>([&] { convex_mesh(mesh); });
}

/// The strip between two lines of n + 1 nodes each.
Mesh strip(const std::vector<Vec3>& inner, const std::vector<Vec3>& outer) {
    Mesh mesh;
    mesh.kind = {CellShape::triangle, 1};
    const auto n = static_cast<std::int32_t>(inner.size()) - 1;
    mesh.nodes = Points(2 * inner.size());
    for (std::size_t i = 0; i < inner.size(); ++i)
        mesh.nodes.set(2 * i, inner[i]), mesh.nodes.set(2 * i + 1, outer[i]);
    for (std::int32_t i = 0; i < n; ++i)
        mesh.cells.insert(mesh.cells.end(), {2 * i, 2 * i + 1, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 2});
    return mesh;
}

/// A strip around the origin that approaches it, so that it overlaps itself after one turn.
Mesh spiral(double turns) {
    std::vector<Vec3> inner, outer;
    const auto disk = ellipse({}, 1, 1);
    for (int i = 0; i <= 60; ++i) {
        const double t = turns * i / 60;
        inner.push_back((1 - 0.1 * t) * disk->point(t)), outer.push_back((2 - 0.1 * t) * disk->point(t));
    }
    return strip(inner, outer);
}

TEST(BoundaryLoop, TakesInAMeshOfRings) {
    for (const auto& [name, curve] : all_curves()) {
        const auto rings = ring_mesh(*curve, 6);
        const auto [mesh, boundary] = convex_mesh(rings.mesh);
        EXPECT_EQ(mesh.cells, rings.mesh.cells) << name;
        EXPECT_EQ(boundary, rings.boundary_nodes) << name;
    }
}

TEST(BoundaryLoop, ReversesClockwiseTriangles) {
    const auto [mesh, boundary] =
        convex_mesh(triangles_of({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}, {0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.cells, (NodeNumbers{0, 2, 1, 0, 3, 2}));
    EXPECT_EQ(boundary, (NodeNumbers{0, 3, 2, 1}));
}

TEST(BoundaryLoop, ProjectsAPlaneOfConstantHeight) {
    Mesh mesh = two_triangles();
    mesh.space_dimension = 3;
    std::fill(mesh.nodes.z.begin(), mesh.nodes.z.end(), 7.0);
    const Mesh flat = convex_mesh(mesh).mesh;
    EXPECT_EQ(flat.space_dimension, 2);
    EXPECT_EQ(flat.nodes.z, std::vector<double>(4, 0.0));
    mesh.nodes.z[2] = 8;
    EXPECT_EQ(refusal(mesh), "the mesh must lie in a plane z = const, but its z is between 7 and 8");
}

TEST(BoundaryLoop, AllowsNodesOnStraightSidesInSinglePrecision) {
    const auto mesh =
        convex_mesh(triangles_of({{0, 0, 0}, {0.5, 1e-7, 0}, {1, 0, 0}, {0.5, 1, 0}}, {0, 1, 3, 1, 2, 3}));
    EXPECT_EQ(mesh.boundary_nodes, (NodeNumbers{0, 1, 2, 3}));
    const auto curve = boundary_curve(mesh, 0.01);
    const auto triangle = rounded_polygon(listed_points({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}}), 0.01);
    EXPECT_NEAR(curve->area(), triangle->area(), 1e-6);
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {0.5, 1e-4, 0}, {1, 0, 0}, {0.5, 1, 0}}, {0, 1, 3, 1, 2, 3})),
              "the boundary of the mesh is not convex at node 1 at (0.5, 10⁻⁴)");
}

TEST(BoundaryLoop, ItsCurveIsNearItsPolygon) {
    const auto mesh = convex_mesh(ring_mesh(*ellipse({3, 4, 0}, 2, 1), 20).mesh);
    const auto curve = boundary_curve(mesh, 0.02);
    for (const auto node : mesh.boundary_nodes)
        EXPECT_NEAR(curve->gauge(mesh.mesh.nodes[static_cast<std::size_t>(node)]).value, 1, 1e-3);
    EXPECT_LT(norm(curve->centre() - Vec3{3, 4, 0}), 1e-12);
    const auto square = boundary_curve(convex_mesh(two_triangles()), 0.1);
    EXPECT_NEAR(square->area(), 1 - (4 - std::numbers::pi) * 0.01, 1e-14);
    EXPECT_EQ(message_of<InputError>([] { boundary_curve(convex_mesh(two_triangles()), 0.7); }),
              "the radius 0.7 of the corners is too large for the sides of the polygon; the largest is 0.5");
}

TEST(BoundaryLoop, RefusesOtherCells) {
    EXPECT_EQ(refusal(unit_square_mesh(2)),
              "a mesh of a convex domain must consist of triangles with straight edges, not of cells "
              "\"quadrilateral, order 1\"");
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}}, {})), "the mesh has no triangles");
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 3})),
              "the mesh is not one of triangles: face 0 names vertex 3, but there are 3 vertices");
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}}, {0, 1, 2})),
              "node 3 belongs to no triangle");
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {0, 1, 2})),
              "each coordinate of node 2 must be a finite number");
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {1e-8, 0, 0}, {0, 1e-8, 0}}, {0, 1, 2})),
              "the size of the mesh must be between 10⁻⁶ and 2×10⁶, not 10⁻⁸");
}

TEST(BoundaryLoop, RefusesOtherSurfaces) {
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}},
                                   {0, 1, 2, 3, 4, 5})),
              "the mesh must be connected, but it has 2 parts");
    EXPECT_EQ(
        refusal(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {0, 1, 2, 1, 3, 4})),
        "the mesh is not a manifold: vertex 1 joins 2 fans of faces");
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2})),
              "the mesh is a closed surface without a boundary");
    Mesh ring = ring_mesh(*ellipse({}, 1, 1), 3).mesh;
    ring.cells.erase(ring.cells.begin(), ring.cells.begin() + 18); // the triangles at the centre
    for (auto& node : ring.cells) --node;
    Points nodes(ring.node_count() - 1);
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set(i, ring.nodes[i + 1]);
    ring.nodes = nodes;
    EXPECT_EQ(refusal(ring), "the mesh must have one boundary, but it has 2, as there are holes");
}

TEST(BoundaryLoop, RefusesDegenerateAndFoldedTriangles) {
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {0, 1, 2, 0, 2, 3})),
              "triangle 0 is degenerate, its nodes lie on one line");
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.9, 0.2, 0}}, {0, 1, 2, 0, 2, 3})),
              "triangles 0 and 1 have opposite orientations; all must be anticlockwise, or all clockwise");
}

TEST(BoundaryLoop, RefusesBoundariesThatAreNotConvex) {
    EXPECT_EQ(refusal(triangles_of({{0, 0, 0}, {1, 0, 0}, {0.4, 0.4, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3})),
              "the boundary of the mesh is not convex at node 2 at (0.4, 0.4)");
    EXPECT_EQ(refusal(spiral(0.6)).substr(0, 52), "the boundary of the mesh is not convex at node 60 at");
    EXPECT_EQ(refusal(spiral(1.5)).substr(0, 39), "the boundary of the mesh crosses itself");
}

} // namespace
} // namespace gaspard
