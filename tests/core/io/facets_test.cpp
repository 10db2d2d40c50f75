// Boundary facets of meshes of every kind, and the names of sides.
#include "core/io/facets.hpp"
#include "core/io/mesh_outline.hpp"
#include "core/spline/spline_domain.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

std::size_t count_border(const Mesh& mesh) { return border(mesh).size(); }

TEST(Facets, TheBorderIsWhatOneCellAloneHas) {
    EXPECT_EQ(count_border(three_lines()), 2u);
    EXPECT_EQ(count_border(two_triangles()), 4u);
    EXPECT_EQ(count_border(unit_square_mesh(5)), 20u);
    EXPECT_EQ(count_border(of_order_two(unit_square_mesh(2))), 8u);
    EXPECT_EQ(count_border(two_cubes()), 10u);
    EXPECT_EQ(count_border(of_order_two(two_cubes())), 10u);
}

TEST(Facets, OfACurvedFacetTheMiddleNodesFollowTheCorners) {
    for (const Mesh& mesh : {of_order_two(two_cubes()), of_order_two(unit_square_mesh(2))}) {
        const Facets facets = border(mesh);
        const auto corners = static_cast<std::size_t>(facets.corners);
        ASSERT_EQ(facets.nodes_each, corners == 4 ? 9 : 3);
        for (std::size_t f = 0; f < facets.size(); ++f) {
            const auto p = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(facets[f][i])]; };
            const std::size_t edges = corners == 2 ? 1 : corners;
            for (std::size_t i = 0; i < edges; ++i)
                EXPECT_EQ(p(corners + i), 0.5 * (p(i) + p((i + 1) % corners)));
        }
    }
}

TEST(Facets, OfSurfacesTheCellsAreSeenAndOfSolidsTheBorder) {
    EXPECT_EQ(shown_faces(three_lines()).size(), 0u);
    const Facets square = shown_faces(unit_square_mesh(3));
    EXPECT_EQ(square.nodes, unit_square_mesh(3).cells);
    EXPECT_EQ(shown_faces(two_cubes()).size(), 10u);
}

TEST(Facets, ABoxHasNamedSides) {
    const Mesh mesh = two_cubes();
    const auto groups = border_groups(mesh, border(mesh));
    std::vector<std::pair<std::string, std::size_t>> found;
    for (const auto& group : groups) found.emplace_back(group.name, group.facets.size());
    EXPECT_EQ(found, (std::vector<std::pair<std::string, std::size_t>>{
                         {"left", 1}, {"right", 1}, {"front", 2}, {"back", 2}, {"bottom", 2}, {"top", 2}}));
}

Side joined(const std::vector<Side>& line) { return {line.front().from, line.back().to}; }

void expect_connected(const std::vector<Side>& line) {
    for (std::size_t i = 1; i < line.size(); ++i) EXPECT_EQ(line[i - 1].to, line[i].from);
}

std::vector<Side> all_edges(const Mesh& mesh) {
    std::vector<Side> sides;
    for (const auto& edge : edges_of(shown_faces(mesh))) sides.push_back(edge.side);
    return sides;
}

TEST(Outline, EveryEdgeIsThereOnceWithTheFacesBesideIt) {
    const Mesh mesh = unit_square_mesh(3);
    const auto edges = edges_of(shown_faces(mesh));
    ASSERT_EQ(edges.size(), 24u);
    std::size_t at_border = 0;
    for (const auto& edge : edges) {
        if (edge.faces[0] == edge.faces[1]) ++at_border;
        for (const auto face : edge.faces) {
            const auto cell = mesh.cell(face);
            EXPECT_NE(std::find(cell.begin(), cell.end(), edge.side.from), cell.end());
            EXPECT_NE(std::find(cell.begin(), cell.end(), edge.side.to), cell.end());
        }
    }
    EXPECT_EQ(at_border, 12u);
}

TEST(Outline, TheEdgesOfASquareAreItsRowsAndColumns) {
    const Mesh mesh = unit_square_mesh(6);
    const auto lines = chain(all_edges(mesh), mesh.nodes);
    ASSERT_EQ(lines.size(), 14u);
    for (const auto& line : lines) {
        EXPECT_EQ(line.size(), 6u);
        expect_connected(line);
        const Side whole = joined(line);
        const Vec3 d =
            mesh.nodes[static_cast<std::size_t>(whole.to)] - mesh.nodes[static_cast<std::size_t>(whole.from)];
        EXPECT_EQ(norm(d), 1) << "straight from one side to the other";
    }
}

TEST(Outline, EveryEdgeIsInOneLineOnly) {
    for (const Mesh& mesh : {two_triangles(), of_order_two(unit_square_mesh(3)), two_cubes()}) {
        const auto edges = all_edges(mesh);
        std::size_t count = 0;
        for (const auto& line : chain(edges, mesh.nodes)) {
            count += line.size();
            expect_connected(line);
            for (const Side& side : line)
                EXPECT_TRUE(std::find(edges.begin(), edges.end(), side) != edges.end() ||
                            std::find(edges.begin(), edges.end(), side.reversed()) != edges.end());
        }
        EXPECT_EQ(count, edges.size());
    }
}

TEST(Outline, SidesOfHighOrderGoThroughTheirNodesInOrder) {
    for (const int order : {2, 3, 7}) {
        const Mesh mesh = *SplineDomain(order, 2, square_map()).mesh();
        const auto edges = all_edges(mesh);
        EXPECT_EQ(edges.size(), 12u);
        for (const Side& edge : edges)
            for (const Side& side : {edge, edge.reversed()}) {
                ASSERT_EQ(side.inside().size(), static_cast<std::size_t>(order - 1));
                const auto at = [&](std::int32_t node) { return mesh.nodes[static_cast<std::size_t>(node)]; };
                const Vec3 step = (1.0 / order) * (at(side.to) - at(side.from));
                for (std::size_t k = 0; k < side.inside().size(); ++k)
                    EXPECT_LT(
                        norm(at(side.inside()[k]) - at(side.from) - (static_cast<double>(k) + 1) * step),
                        1e-15);
            }
    }
}

double area_within(const std::vector<std::vector<Side>>& loops, const Points& nodes) {
    double twice = 0;
    for (const auto& loop : loops) {
        expect_connected(loop);
        EXPECT_EQ(loop.back().to, loop.front().from) << "closed";
        for (const Side& side : loop)
            twice +=
                cross(nodes[static_cast<std::size_t>(side.from)], nodes[static_cast<std::size_t>(side.to)]).z;
    }
    return twice / 2;
}

TEST(Outline, ARegionHasNoLinesInside) {
    const Mesh mesh = unit_square_mesh(4);
    const Facets faces = shown_faces(mesh);
    std::vector<std::uint32_t> all, ring, corners = {0, 5};
    for (std::uint32_t f = 0; f < 16; ++f) {
        all.push_back(f);
        if (f != 5) ring.push_back(f);
    }
    const auto whole = outline(faces, all);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0].size(), 16u);
    EXPECT_EQ(area_within(whole, mesh.nodes), 1);
    EXPECT_EQ(outline(faces, ring).size(), 2u) << "with a hole";
    EXPECT_EQ(area_within(outline(faces, ring), mesh.nodes), 15.0 / 16);
    EXPECT_EQ(area_within(outline(faces, corners), mesh.nodes), 2.0 / 16) << "two cells that share a corner";
    EXPECT_TRUE(outline(faces, {}).empty());
}

} // namespace
} // namespace gaspard
