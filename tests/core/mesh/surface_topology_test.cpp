// Small surfaces whose topology is known, oriented and not, manifold and not.
#include "core/base/error.hpp"
#include "core/mesh/sphere_mesh.hpp"
#include "core/mesh/surface_topology.hpp"
#include "support/messages.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace gaspard {
namespace {

using Numbers = std::vector<std::int32_t>;
using Loops = std::vector<Numbers>;

PolygonFaces faces_of(std::initializer_list<Numbers> list) {
    PolygonFaces faces;
    for (const auto& face : list) faces.add(face);
    return faces;
}

SurfaceTopology topology(std::size_t vertices, std::initializer_list<Numbers> list) {
    return {vertices, faces_of(list)};
}

/// A strip of n quadrilaterals, closed after a half twist: vertex 2 i and 2 i + 1 are across.
SurfaceTopology moebius_strip(std::int32_t n) {
    PolygonFaces faces;
    for (std::int32_t i = 0; i + 1 < n; ++i) faces.add(Numbers{2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    faces.add(Numbers{2 * n - 2, 1, 0, 2 * n - 1});
    return {static_cast<std::size_t>(2 * n), faces};
}

/// A torus of n x m quadrilaterals.
SurfaceTopology torus(std::int32_t n, std::int32_t m) {
    PolygonFaces faces;
    const auto at = [&](std::int32_t i, std::int32_t j) { return j % m * n + i % n; };
    for (std::int32_t j = 0; j < m; ++j)
        for (std::int32_t i = 0; i < n; ++i)
            faces.add(Numbers{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return {static_cast<std::size_t>(n * m), faces};
}

TEST(SurfaceTopology, DescribesASquareOfFourSquares) {
    const SurfaceTopology t(unit_square_mesh(2));
    EXPECT_EQ(t.edges().edges.size(), 12u);
    EXPECT_EQ(t.boundary_loops(), (Loops{{0, 1, 2, 5, 8, 7, 6, 3}})); // counterclockwise
    const auto middle = t.one_rings(4);
    ASSERT_EQ(middle.size(), 1u);
    EXPECT_TRUE(middle[0].closed);
    EXPECT_EQ(middle[0].neighbours, (Numbers{1, 5, 7, 3}));
    EXPECT_EQ(middle[0].faces, (Numbers{1, 3, 2, 0}));
    const auto side = t.one_rings(1);
    ASSERT_EQ(side.size(), 1u);
    EXPECT_FALSE(side[0].closed);
    EXPECT_EQ(side[0].neighbours, (Numbers{2, 4, 0}));
    EXPECT_EQ(side[0].faces, (Numbers{1, 0}));
    EXPECT_EQ(t.euler_characteristic(), 1);
    EXPECT_EQ(t.component_count(), 1u);
    EXPECT_TRUE(t.manifold() && t.orientable());
    EXPECT_TRUE(t.facts().empty());
}

TEST(SurfaceTopology, NamesTheFacesOfAnEdge) {
    const SurfaceTopology t(two_triangles()); // 0 1 2, 0 2 3
    const auto& edges = t.edges();
    ASSERT_EQ(edges.edges.size(), 5u);
    EXPECT_EQ(edges.edges[1].vertices, (std::array{0, 2}));
    const auto sides = edges.sides_of(edges.edges[1]);
    ASSERT_EQ(sides.size(), 2u);
    EXPECT_EQ(t.face_of_side(sides[0]), 0);
    EXPECT_EQ(t.face_of_side(sides[1]), 1);
    EXPECT_EQ(edges.sides_of(edges.edges[0]).size(), 1u);
}

TEST(SurfaceTopology, SeesOnlyTheCornersOfCurvedCells) {
    const SurfaceTopology curved(curved_square());
    EXPECT_EQ(curved.boundary_loops(), (Loops{{2, 3, 4, 5}}));
    EXPECT_EQ(curved.euler_characteristic(), 1);
    EXPECT_TRUE(curved.one_rings(0).empty()); // the node in the middle
}

TEST(SurfaceTopology, ASphereIsClosed) {
    for (const auto cells : {SphereCells::cubed, SphereCells::icosahedral}) {
        const SurfaceTopology t(sphere_mesh({.cells = cells, .resolution = 3}).quadratic);
        EXPECT_TRUE(t.boundary_loops().empty());
        EXPECT_EQ(t.euler_characteristic(), 2);
        EXPECT_TRUE(t.facts().empty());
    }
}

TEST(SurfaceTopology, ATorusHasCharacteristicZero) {
    const auto t = torus(5, 4);
    EXPECT_EQ(t.euler_characteristic(), 0);
    EXPECT_TRUE(t.boundary_loops().empty() && t.facts().empty());
    for (std::int32_t v = 0; v < 20; ++v) EXPECT_EQ(t.one_rings(v).at(0).neighbours.size(), 4u);
}

TEST(SurfaceTopology, AHoleHasALoopOfItsOwnClockwise) {
    PolygonFaces faces;
    for (const std::int32_t cell : {0, 1, 2, 3, 5, 6, 7, 8}) { // 3 x 3 squares without the middle one
        const std::int32_t a = cell / 3 * 4 + cell % 3;
        faces.add(Numbers{a, a + 1, a + 5, a + 4});
    }
    const SurfaceTopology t(16, faces);
    EXPECT_EQ(t.boundary_loops(), (Loops{{0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}, {5, 9, 10, 6}}));
    EXPECT_EQ(t.euler_characteristic(), 0);
}

TEST(SurfaceTopology, FindsReversedFaces) {
    const auto t = topology(4, {{0, 1, 2}, {0, 3, 2}});
    ASSERT_EQ(t.inconsistent_edges().size(), 1u);
    EXPECT_EQ(t.reversed_faces(), (Numbers{1}));
    EXPECT_TRUE(t.orientable() && t.manifold());
    EXPECT_EQ(t.facts(), (std::vector<std::string>{"the faces at edge 0-2 have opposite orientations"}));
    EXPECT_EQ(t.boundary_loops(), (Loops{{0, 1, 2, 3}})); // as the first face is oriented
    EXPECT_EQ(t.one_rings(0).at(0).neighbours, (Numbers{1, 2, 3}));
}

TEST(SurfaceTopology, AMoebiusStripCannotBeOriented) {
    for (const std::int32_t n : {3, 4, 7}) {
        const auto t = moebius_strip(n);
        EXPECT_FALSE(t.orientable());
        EXPECT_TRUE(t.manifold());
        EXPECT_TRUE(t.reversed_faces().empty());
        EXPECT_EQ(t.facts(), std::vector<std::string>{"not orientable"});
        EXPECT_EQ(t.euler_characteristic(), 0);
        const auto loops = t.boundary_loops();
        ASSERT_EQ(loops.size(), 1u); // one edge only, twice as long
        EXPECT_EQ(loops[0].size(), static_cast<std::size_t>(2 * n));
        EXPECT_EQ(std::set(loops[0].begin(), loops[0].end()).size(), loops[0].size());
        for (std::int32_t v = 0; v < 2 * n; ++v) {
            const auto rings = t.one_rings(v);
            ASSERT_EQ(rings.size(), 1u);
            EXPECT_FALSE(rings[0].closed);
            ASSERT_EQ(rings[0].neighbours.size(), 3u);
            EXPECT_EQ(rings[0].neighbours[1], v ^ 1); // the one across lies between
            EXPECT_EQ(rings[0].faces.size(), 2u);
        }
    }
}

TEST(SurfaceTopology, AProjectivePlaneIsClosedAndCannotBeOriented) {
    // The icosahedron with opposite vertices made one.
    const auto t = topology(6, {{0, 1, 2},
                                {0, 2, 3},
                                {0, 3, 4},
                                {0, 4, 5},
                                {0, 5, 1},
                                {1, 2, 4},
                                {2, 3, 5},
                                {3, 4, 1},
                                {4, 5, 2},
                                {5, 1, 3}});
    EXPECT_EQ(t.euler_characteristic(), 1);
    EXPECT_FALSE(t.orientable());
    EXPECT_TRUE(t.manifold() && t.boundary_loops().empty());
    for (std::int32_t v = 0; v < 6; ++v) {
        const auto rings = t.one_rings(v);
        ASSERT_EQ(rings.size(), 1u);
        EXPECT_TRUE(rings[0].closed);
        EXPECT_EQ(std::set(rings[0].neighbours.begin(), rings[0].neighbours.end()).size(), 5u);
        EXPECT_EQ(std::set(rings[0].faces.begin(), rings[0].faces.end()).size(), 5u);
    }
}

TEST(SurfaceTopology, NamesAComplexEdge) {
    const auto t = topology(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    EXPECT_FALSE(t.manifold());
    EXPECT_EQ(t.facts(), std::vector<std::string>{"edge 0-1 has three faces"});
    EXPECT_EQ(t.facts(3, 1), std::vector<std::string>{"edge 1-2 has three faces"});
    EXPECT_EQ(t.component_count(), 1u);
    EXPECT_EQ(t.boundary_loops().size(), 3u); // cut there, three triangles
    EXPECT_EQ(t.one_rings(0).size(), 3u);
}

TEST(SurfaceTopology, TwoClosedSurfacesMayShareAnEdge) {
    // Two tetrahedra; the shared edge has four faces and is a cut.
    const auto t =
        topology(6, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}, {0, 5, 1}, {1, 5, 4}, {5, 0, 4}});
    EXPECT_EQ(t.facts(), std::vector<std::string>{"edge 0-1 has four faces"});
    EXPECT_TRUE(t.orientable());
    EXPECT_EQ(t.boundary_loops(), (Loops{{0, 1}, {0, 1}}));
    EXPECT_EQ(t.one_rings(0).size(), 2u);
    EXPECT_TRUE(t.one_rings(3).at(0).closed);
}

TEST(SurfaceTopology, NamesAPinchedVertex) {
    const auto t = topology(5, {{0, 1, 2}, {2, 3, 4}});
    EXPECT_EQ(t.pinched_vertices(), (Numbers{2}));
    EXPECT_EQ(t.facts(), std::vector<std::string>{"vertex 2 joins 2 fans of faces"});
    EXPECT_EQ(t.component_count(), 2u);
    EXPECT_EQ(t.boundary_loops(), (Loops{{0, 1, 2}, {2, 3, 4}}));
    ASSERT_EQ(t.one_rings(2).size(), 2u);
    EXPECT_EQ(t.one_rings(2)[0].neighbours, (Numbers{0, 1}));
    EXPECT_EQ(t.one_rings(2)[1].neighbours, (Numbers{3, 4}));
}

TEST(SurfaceTopology, CountsComponentsInTheOrderOfFaces) {
    const auto t = topology(9, {{0, 1, 2}, {6, 7, 8}, {3, 4, 5}, {2, 1, 3}});
    const auto components = t.components();
    EXPECT_EQ(Numbers(components.begin(), components.end()), (Numbers{0, 1, 2, 0}));
    EXPECT_EQ(t.component_count(), 3u);
}

TEST(SurfaceTopology, RefusesImpossibleFaces) {
    const auto message = [](std::initializer_list<Numbers> list) {
        return message_of<InputError>([&] { topology(4, list); });
    };
    EXPECT_EQ(message({{0, 1, 2}, {0, 1, 4}}), "face 1 names vertex 4, but there are 4 vertices");
    EXPECT_EQ(message({{0, -1, 2}}), "face 0 names vertex -1, but there are 4 vertices");
    EXPECT_EQ(message({{0, 1}}), "face 0 has fewer than three corners");
    EXPECT_EQ(message({{0, 1, 2, 1}}), "face 0 has vertex 1 twice");
}

TEST(SurfaceTopology, OfNoFacesIsEmpty) {
    const auto t = topology(3, {});
    EXPECT_EQ(t.euler_characteristic(), 0);
    EXPECT_TRUE(t.boundary_loops().empty() && t.one_rings(2).empty() && t.manifold() && t.orientable());
}

} // namespace
} // namespace gaspard
