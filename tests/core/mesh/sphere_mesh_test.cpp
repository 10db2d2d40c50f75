#include "core/base/error.hpp"
#include "core/mesh/domain_type.hpp"
#include "core/mesh/sphere_mesh.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <random>
#include <set>

namespace gaspard {
namespace {

const std::vector<SphereGrid> grids = {
    {SphereCells::cubed, 1},       {SphereCells::cubed, 2},
    {SphereCells::cubed, 5},       {SphereCells::cubed, 5, MidNodes::equiangular},
    {SphereCells::icosahedral, 0}, {SphereCells::icosahedral, 1},
    {SphereCells::icosahedral, 3}};

std::size_t corners_of(const Mesh& mesh) { return static_cast<std::size_t>(corners_per_cell(mesh.kind)); }
Vec3 node_of(const Mesh& mesh, std::int32_t number) { return mesh.nodes[static_cast<std::size_t>(number)]; }

TEST(SphereMesh, HasTheCellsAndNodesThatItsNameSays) {
    for (const int k : {1, 2, 5}) {
        const auto surface = sphere_mesh({SphereCells::cubed, k});
        const auto cells = static_cast<std::size_t>(6 * k * k);
        EXPECT_EQ(surface.quadratic.cell_count(), cells);
        EXPECT_EQ(surface.vertex_count, cells + 2);
        EXPECT_EQ(surface.quadratic.node_count(), 4 * cells + 2);
    }
    for (const int r : {0, 1, 3}) {
        const auto surface = sphere_mesh({SphereCells::icosahedral, r});
        const auto cells = std::size_t{20} << 2 * r;
        EXPECT_EQ(surface.quadratic.cell_count(), cells);
        EXPECT_EQ(surface.vertex_count, cells / 2 + 2);
        EXPECT_EQ(surface.quadratic.node_count(), 2 * cells + 2);
    }
}

TEST(SphereMesh, IsAClosedSurfaceOnTheSphereThatFacesOutward) {
    for (const auto& grid : grids) {
        const auto surface = sphere_mesh(grid);
        const Mesh& mesh = surface.quadratic;
        for (std::size_t i = 0; i < mesh.node_count(); ++i) EXPECT_NEAR(norm(mesh.nodes[i]), 1, 1e-15);
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t>
            edges; // directed, with the node between
        for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
            const auto cell = mesh.cell(c);
            for (const auto& edge : cell_edges(mesh.kind)) {
                const auto at = [&](std::size_t i) { return cell[static_cast<std::size_t>(edge[i])]; };
                EXPECT_TRUE(edges.try_emplace({at(0), at(1)}, at(2)).second);
                EXPECT_LT(static_cast<std::size_t>(std::max(at(0), at(1))), surface.vertex_count);
                EXPECT_GE(static_cast<std::size_t>(at(2)), surface.vertex_count);
            }
            const Vec3 a = node_of(mesh, cell[0]), b = node_of(mesh, cell[1]), d = node_of(mesh, cell[2]);
            EXPECT_GT(dot(cross(b - a, d - a), a + b + d), 0);
        }
        for (const auto& [edge, between] : edges) {
            ASSERT_TRUE(edges.contains({edge.second, edge.first}));
            EXPECT_EQ(edges.at({edge.second, edge.first}), between);
        }
    }
}

TEST(SphereMesh, PutsNodesBetweenVerticesWhereTheirPlacementSays) {
    const auto surface = sphere_mesh({SphereCells::cubed, 3});
    for (std::size_t c = 0; c < surface.quadratic.cell_count(); ++c) {
        const auto cell = surface.quadratic.cell(c);
        const auto at = [&](std::size_t i) { return node_of(surface.quadratic, cell[i]); };
        const auto expect_along = [&](Vec3 sum, Vec3 node) {
            EXPECT_NEAR(norm((1 / norm(sum)) * sum - node), 0, 1e-15);
        };
        for (std::size_t e = 0; e < 4; ++e) expect_along(at(e) + at((e + 1) % 4), at(4 + e));
        expect_along(at(0) + at(1) + at(2) + at(3), at(8));
    }
    // Equiangular nodes of a mesh are the vertices of the one of half the size.
    const auto coarse = sphere_mesh({SphereCells::cubed, 3, MidNodes::equiangular});
    const auto fine = sphere_mesh({SphereCells::cubed, 6});
    const auto key = [](Vec3 p) {
        return std::array{std::llround(1e9 * p.x), std::llround(1e9 * p.y), std::llround(1e9 * p.z)};
    };
    std::set<std::array<long long, 3>> vertices, nodes;
    for (std::size_t i = 0; i < fine.vertex_count; ++i) vertices.insert(key(fine.quadratic.nodes[i]));
    for (std::size_t i = 0; i < coarse.quadratic.node_count(); ++i)
        nodes.insert(key(coarse.quadratic.nodes[i]));
    EXPECT_EQ(nodes, vertices);
}

TEST(SphereMesh, StraightenedKeepsVerticesAndCells) {
    for (const auto& grid : grids) {
        const auto surface = sphere_mesh(grid);
        const Mesh straight = straightened(surface);
        EXPECT_EQ(straight.kind.order, 1);
        ASSERT_EQ(straight.node_count(), surface.vertex_count);
        ASSERT_EQ(straight.cell_count(), surface.quadratic.cell_count());
        for (std::size_t c = 0; c < straight.cell_count(); ++c)
            for (std::size_t n = 0; n < corners_of(straight); ++n)
                EXPECT_EQ(straight.cell(c)[n], surface.quadratic.cell(c)[n]);
    }
}

TEST(SphereMesh, LocatesPointsNearWhereTheirCellsPutThem) {
    std::mt19937 random(1);
    std::normal_distribution<double> coordinate;
    for (const auto& grid : grids) {
        const Mesh mesh = sphere_mesh(grid).quadratic;
        const auto count = static_cast<std::size_t>(nodes_per_cell(mesh.kind));
        std::vector<double> shapes(count);
        std::vector<Vec3> gradients(count);
        const auto back = [&](const CellPlace& place) {
            shape_functions(mesh.kind, place.at, shapes, gradients);
            Vec3 p;
            for (std::size_t n = 0; n < count; ++n)
                p = p + shapes[n] * node_of(mesh, mesh.cell(place.cell)[n]);
            return p;
        };
        const double width = std::sqrt(4 * std::numbers::pi / static_cast<double>(mesh.cell_count()));
        for (int trial = 0; trial < 300; ++trial) {
            Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
            const CellPlace place = locate(grid, p);
            ASSERT_LT(place.cell, mesh.cell_count());
            EXPECT_GE(std::min(place.at.x, place.at.y), -1e-12);
            EXPECT_LE(std::max(place.at.x, place.at.y), 1 + 1e-12);
            EXPECT_LT(angle_between(back(place), p), 0.08 * width * std::min(1.0, width));
        }
        for (std::size_t i = 0; i < mesh.node_count();
             i += 7) // corners and edges belong to any of their cells
            EXPECT_LT(angle_between(back(locate(grid, mesh.nodes[i])), mesh.nodes[i]),
                      0.08 * width * std::min(1.0, width) + 1e-12);
    }
}

TEST(SphereDomains, SayWhichMeshTheirValuesMean) {
    Values cubed("domain", cubed_sphere_domain().rows);
    EXPECT_EQ(cubed_sphere_grid(cubed), (SphereGrid{SphereCells::cubed, 16, MidNodes::normalised}));
    cubed.set("cells", std::int64_t{128});
    cubed.set("mid_nodes", std::string("equiangular"));
    EXPECT_EQ(cubed_sphere_grid(cubed), (SphereGrid{SphereCells::cubed, 128, MidNodes::equiangular}));
    EXPECT_THROW(cubed.set("geometry_order", std::int64_t{3}), InputError);
    Values triangles("domain", icosahedral_sphere_domain().rows);
    EXPECT_EQ(icosahedral_sphere_grid(triangles), (SphereGrid{SphereCells::icosahedral, 4}));
    EXPECT_EQ(icosahedral_sphere_domain().space(triangles, {}).kind, SpaceKind::sphere);
    triangles.set("radius", 6371e3);
}

} // namespace
} // namespace gaspard
