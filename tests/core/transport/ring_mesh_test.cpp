// Counts, areas and angles of meshes of rings, and DOLFIN's mesh of the disk.
#include "core/mesh/surface_topology.hpp"
#include "core/transport/delaunay_flips.hpp"
#include "core/transport/ring_mesh.hpp"
#include "support/convex_curves.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

std::vector<double> triangle_areas(const Mesh& mesh) {
    std::vector<double> areas;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        const auto at = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(mesh.cell(c)[k])]; };
        areas.push_back(cross(at(1) - at(0), at(2) - at(0)).z / 2);
    }
    return areas;
}

double sum_of_areas(const Mesh& mesh) {
    double sum = 0;
    for (const double area : triangle_areas(mesh)) sum += area;
    return sum;
}

TEST(RingMesh, HasItsCountsAndPositiveAreas) {
    for (const auto& [name, curve] : all_curves())
        for (const int n : {1, 2, 7, 20}) {
            const auto [mesh, parameters, boundary] = ring_mesh(*curve, n);
            const auto rings = static_cast<std::size_t>(n);
            EXPECT_EQ(mesh.cell_count(), 6 * rings * rings);
            EXPECT_EQ(mesh.node_count(), 1 + 3 * rings * (rings + 1));
            const SurfaceTopology topology(mesh);
            EXPECT_EQ(topology.euler_characteristic(), 1) << name;
            EXPECT_TRUE(topology.manifold() && topology.inconsistent_edges().empty()) << name;
            const auto areas = triangle_areas(mesh);
            EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0) << name << ", " << n;
            EXPECT_EQ(topology.boundary_loops(), (std::vector<std::vector<std::int32_t>>{boundary})) << name;
            for (std::size_t i = 0; i < boundary.size(); ++i)
                EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(boundary[i])], curve->point(parameters[i]));
        }
}

TEST(RingMesh, ItsAreaConvergesWithOrderTwo) {
    for (const auto& [name, curve] : all_curves()) {
        const auto error = [&, &of = curve](int n) {
            return of->area() - sum_of_areas(ring_mesh(*of, n).mesh);
        };
        const double coarse = error(40), fine = error(80);
        EXPECT_GT(fine, 0) << name;
        EXPECT_NEAR(std::log2(coarse / fine), 2, 0.25) << name;
    }
}

TEST(RingMesh, OfTheUnitDiskIsThatOfDolfin) {
    const Mesh mesh = ring_mesh(*ellipse({}, 1, 1), 2).mesh;
    // UnitDiscMesh.create(comm, 2, 1, 2).cells(), whose corners are sorted
    const std::vector<std::int32_t> cells = {0, 1,  2,  0, 2, 3,  0, 3,  4,  0, 4,  5,  0, 5, 6,  0, 1,  6,
                                             1, 7,  8,  1, 2, 8,  2, 8,  9,  2, 9,  10, 2, 3, 10, 3, 10, 11,
                                             3, 11, 12, 3, 4, 12, 4, 12, 13, 4, 13, 14, 4, 5, 14, 5, 14, 15,
                                             5, 15, 16, 5, 6, 16, 6, 16, 17, 6, 17, 18, 1, 6, 18, 1, 7,  18};
    std::vector<std::int32_t> ours = mesh.cells;
    for (std::size_t i = 0; i < ours.size(); i += 3)
        std::sort(ours.begin() + static_cast<std::ptrdiff_t>(i),
                  ours.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    EXPECT_EQ(ours, cells);
    EXPECT_LT(norm(mesh.nodes[3] - Vec3{-0.25, std::sqrt(3) / 4, 0}), 1e-15);
    EXPECT_LT(norm(mesh.nodes[8] - Vec3{std::sqrt(0.75), 0.5, 0}), 1e-15);
    const std::vector<double> longest = {0.17491853131052743, 0.08899870183108566,
                                         0.04487676753668422}; // hmax()
    for (std::size_t i = 0; i < longest.size(); ++i)
        EXPECT_NEAR(triangle_quality(ring_mesh(*ellipse({}, 1, 1), 8 << i).mesh).longest_edge, longest[i],
                    1e-14);
}

TEST(RingMesh, LongDomainsHaveGoodAngles) {
    const auto smallest = [](const ConvexCurve& curve) {
        return triangle_quality(ring_mesh(curve, 32).mesh).smallest_angle;
    };
    EXPECT_GT(smallest(*ellipse({}, 1, 1)), 44);
    EXPECT_GT(smallest(*ellipse({}, 2, 1)), 35);
    EXPECT_GT(smallest(*ellipse({}, 5, 1)), 29);
    EXPECT_GT(smallest(*rounded_rectangle({}, 1, 1, 8)), 36);
    EXPECT_GT(smallest(*rounded_polygon(square_corners(), 0.1)), 30);
}

TEST(TriangleQuality, OfTwoTriangles) {
    const auto quality = triangle_quality(two_triangles());
    EXPECT_NEAR(quality.smallest_angle, 45, 1e-13);
    EXPECT_NEAR(quality.largest_angle, 90, 1e-13);
    EXPECT_NEAR(quality.longest_edge, std::sqrt(2), 1e-15);
    EXPECT_EQ(quality.shortest_edge, 1);
}

TEST(DelaunayFlips, ExchangeALongDiagonalAndKeepThoseOnACircle) {
    Mesh square = two_triangles();
    const auto before = square.cells;
    flip_to_delaunay(square);
    EXPECT_EQ(square.cells, before);
    square.nodes.set(2, {2, 2, 0}); // its diagonal becomes longer than the other one
    flip_to_delaunay(square);
    EXPECT_NEAR(sum_of_areas(square), 2, 1e-15);
    const SurfaceTopology topology(square);
    for (const auto& edge : topology.edges().edges)
        EXPECT_NE(edge.vertices, (std::array<std::int32_t, 2>{0, 2}));
    EXPECT_EQ(topology.edges().edges.size(), 5u);
}

TEST(DelaunayFlips, LeaveNoPairOfAnglesAbovePi) {
    const Mesh mesh = ring_mesh(*ellipse({}, 5, 1, 33), 12).mesh;
    const SurfaceTopology topology(mesh);
    const auto opposite = [&](std::uint32_t side) { // the angle opposite to it in its triangle
        const std::uint32_t first = side / 3 * 3;
        const auto at = [&](std::uint32_t k) {
            return mesh.nodes[static_cast<std::size_t>(mesh.cells[first + (side - first + k) % 3])];
        };
        const Vec3 a = at(0) - at(2), b = at(1) - at(2);
        return std::atan2(cross(a, b).z, dot(a, b));
    };
    for (const auto& edge : topology.edges().edges)
        if (const auto sides = topology.edges().sides_of(edge); sides.size() == 2) {
            EXPECT_LE(opposite(sides[0]) + opposite(sides[1]), std::numbers::pi + 1e-9);
        }
}

} // namespace
} // namespace gaspard
