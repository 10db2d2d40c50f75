// Tessellations within a tolerance, compared with the surfaces of the cells at many points.
#include "core/base/error.hpp"
#include "core/tessellate/fine_tessellation.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/messages.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>

namespace gaspard {
namespace {

using Piece = std::pair<std::uint32_t, std::uint32_t>;

Vec3 closest(Vec3 p, Vec3 a, Vec3 b) {
    const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    return a + t * (b - a);
}

double distance_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 normal = cross(b - a, c - a);
    const auto inside = [&](Vec3 from, Vec3 to) { return dot(cross(to - from, p - from), normal) >= 0; };
    if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(dot(p - a, normal)) / norm(normal);
    return std::min({norm(p - closest(p, a, b)), norm(p - closest(p, b, c)), norm(p - closest(p, c, a))});
}

/// The largest distance of points of the cells from their triangles.
double error_of(const Mesh& mesh, const Points& x, const Tessellation& t) {
    const Points points = shown_points(t, x);
    std::vector<std::vector<std::size_t>> triangles(mesh.cell_count());
    for (std::size_t i = 0; i < t.triangle_cells.size(); ++i) triangles[t.triangle_cells[i]].push_back(3 * i);
    const auto nodes = static_cast<std::size_t>(nodes_per_cell(mesh.kind));
    std::vector<double> values(nodes);
    std::vector<Vec3> gradients(nodes);
    double error = 0;
    constexpr int n = 7; // not a power of two
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= (mesh.kind.shape == CellShape::triangle ? n - i : n); ++j) {
                shape_functions(mesh.kind, {static_cast<double>(i) / n, static_cast<double>(j) / n, 0},
                                values, gradients);
                Vec3 p;
                for (std::size_t k = 0; k < nodes; ++k)
                    p = p + values[k] * x[static_cast<std::size_t>(mesh.cell(c)[k])];
                double nearest = std::numeric_limits<double>::infinity();
                for (const std::size_t first : triangles[c])
                    nearest = std::min(nearest, distance_to_triangle(p, points[t.triangles[first]],
                                                                     points[t.triangles[first + 1]],
                                                                     points[t.triangles[first + 2]]));
                error = std::max(error, nearest);
            }
    return error;
}

/// How often each side of a triangle occurs, with its direction.
std::map<Piece, int> sides_of(const Tessellation& t) {
    std::map<Piece, int> sides;
    for (std::size_t i = 0; i < t.triangles.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++sides[{t.triangles[i + k], t.triangles[i + (k + 1) % 3]}];
    return sides;
}

std::size_t cracks(const Tessellation& t) {
    const auto sides = sides_of(t);
    return static_cast<std::size_t>(std::count_if(sides.begin(), sides.end(), [&](const auto& side) {
        return side.second != 1 || !sides.contains({side.first.second, side.first.first});
    }));
}

/// A sphere with cells of very different sizes, concentrated at the north pole.
Points pulled(const Points& sphere) {
    Points x = sphere;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 p = sphere[i] + Vec3{0.1, 0.2, 0.7};
        x.set(i, (1 / norm(p)) * p);
    }
    return x;
}

class FineTessellationTest : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Tolerances, FineTessellationTest, testing::Values(3e-2, 5e-3, 1e-3));

TEST_P(FineTessellationTest, IsWithinTheToleranceAtXiAndAtX) {
    for (const Mesh& mesh : {cubed_sphere_mesh(2), round_octahedron()}) {
        const Points x = pulled(mesh.nodes);
        const Tessellation t = tessellate_within(mesh, x, GetParam());
        const double allowed = 2 * GetParam(); // the sphere's diameter is 2
        const double at_xi = error_of(mesh, mesh.nodes, t), at_x = error_of(mesh, x, t);
        EXPECT_LE(at_xi, allowed);
        EXPECT_LE(at_x, allowed);
        EXPECT_GT(std::max(at_xi, at_x), allowed / 8) << "it is too fine";
    }
}

TEST_P(FineTessellationTest, HasNoCracks) {
    for (const Mesh& mesh : {cubed_sphere_mesh(2), round_octahedron()}) {
        const Tessellation t = tessellate_within(mesh, pulled(mesh.nodes), GetParam());
        EXPECT_EQ(cracks(t), 0U);
        const auto triangles = t.triangle_cells.size(), sides = sides_of(t).size() / 2;
        EXPECT_EQ(t.point_count + triangles - sides, 2U) << "Euler: a sphere";
    }
}

TEST(FineTessellation, TerminatesForTangledMeshesWithoutCracks) {
    const Mesh mesh = cubed_sphere_mesh(2);
    Points x = mesh.nodes;
    for (std::size_t i = 0; i < x.size(); ++i) { // random positions on the sphere
        const double height = std::fmod(0.618 * static_cast<double>(i), 2) - 1,
                     angle = 2.4 * static_cast<double>(i);
        const double radius = std::sqrt(1 - height * height);
        x.set(i, {radius * std::cos(angle), radius * std::sin(angle), height});
    }
    EXPECT_EQ(cracks(tessellate_within(mesh, x, 5e-3)), 0U);
}

TEST(FineTessellation, RejectsTooManyTriangles) {
    const Mesh mesh = curved_square();
    EXPECT_NE(message_of<MachineError>([&] {
                  tessellate_within(mesh, mesh.nodes, 1e-16);
              }).find("increase the tolerance"),
              std::string::npos);
}

/// One cell of this order whose nodes are anywhere in the unit square.
std::pair<Mesh, Points> tangled_cell(int order) {
    const CellKind kind{CellShape::quadrilateral, order};
    Mesh mesh{.kind = kind, .space_dimension = 2, .nodes = {}, .cells = {}};
    const auto nodes = reference_nodes(kind);
    mesh.nodes = Points(nodes.size());
    Points x(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        mesh.nodes.set(i, nodes[i]);
        mesh.cells.push_back(static_cast<std::int32_t>(i));
        x.set(i, {std::fmod(0.618 * static_cast<double>(i), 1), std::fmod(0.755 * static_cast<double>(i), 1),
                  0});
    }
    return {std::move(mesh), std::move(x)};
}

TEST(FineTessellation, DoesNotWorkWithoutEndOnTangledCellsOfHighOrder) {
    const auto [mesh, x] = tangled_cell(7);
    EXPECT_NE(message_of<MachineError>([&] {
                  tessellate_within(mesh, x, 1e-4, 1'000'000);
              }).find("would take too long, because cells fold or bend strongly; increase the tolerance"),
              std::string::npos);
    EXPECT_NO_THROW(tessellate_within(mesh, mesh.nodes, 1e-4, 0)) << "a straight cell";
    const auto [cubic, y] = tangled_cell(3);
    EXPECT_GT(tessellate_within(cubic, y, 1e-3).triangle_cells.size(), 10000U) << "the default is enough";
}

TEST(FineTessellation, TheCrackTestDetectsACrack) {
    const Mesh mesh = cubed_sphere_mesh(2);
    Tessellation t = tessellate_within(mesh, mesh.nodes, 1e-2);
    t.triangles.resize(t.triangles.size() - 3);
    EXPECT_EQ(cracks(t), 3U);
}

TEST(FineTessellation, CellEdgesAreSidesOfTriangles) {
    const Mesh mesh = cubed_sphere_mesh(2);
    const Tessellation t = tessellate_within(mesh, pulled(mesh.nodes), 1e-3);
    const auto sides = sides_of(t);
    std::set<std::uint32_t> corners;
    for (const auto point : tessellate(mesh, 1).segments) corners.insert(point);
    std::size_t lines = 0, ends = 0;
    for (std::size_t i = 0; i < t.segments.size(); i += 2) {
        EXPECT_TRUE(sides.contains({t.segments[i], t.segments[i + 1]}));
        if (i == 0 || t.segments[i] != t.segments[i - 1]) ++lines;
        ends += corners.count(t.segments[i]);
    }
    EXPECT_EQ(ends, 48U) << "every edge begins at a corner, and only there";
    EXPECT_LE(lines, 48U);
    EXPECT_EQ(t.segment_sides.size(), t.segments.size());
}

TEST(FineTessellation, SubdividesLargeCellsMoreThanSmallOnes) {
    const Mesh mesh = cubed_sphere_mesh(4);
    const Points x = pulled(mesh.nodes);
    const Tessellation t = tessellate_within(mesh, x, 5e-4);
    std::vector<std::size_t> count(mesh.cell_count(), 0);
    for (const auto cell : t.triangle_cells) ++count[cell];
    const auto uniform = tessellate_within(mesh, mesh.nodes, 5e-4).triangle_cells.size();
    EXPECT_GE(*std::max_element(count.begin(), count.end()),
              2 * *std::min_element(count.begin(), count.end()));
    EXPECT_LT(t.triangle_cells.size(), 3 * uniform) << "not every cell as fine as the largest";
}

TEST(FineTessellation, AQuarterOfTheToleranceDoublesTheNumberOfPieces) {
    const Mesh mesh = cubed_sphere_mesh(2);
    std::size_t before = 0;
    for (const double tolerance : {4e-3, 1e-3, 2.5e-4}) {
        const std::size_t pieces = tessellate_within(mesh, mesh.nodes, tolerance).segments.size() / 2;
        if (before > 0) {
            EXPECT_EQ(pieces, 2 * before);
        }
        before = pieces;
    }
}

TEST(FineTessellation, DoesNotSubdivideStraightCells) {
    for (const Mesh& mesh : {unit_square_mesh(4), disk_mesh(2), two_cubes(), three_lines()}) {
        const Tessellation fine = tessellate_within(mesh, mesh.nodes, 1e-5), coarse = tessellate(mesh);
        EXPECT_EQ(fine.triangles, coarse.triangles);
        EXPECT_EQ(fine.triangle_cells, coarse.triangle_cells);
        EXPECT_EQ(fine.segments, coarse.segments);
        EXPECT_EQ(fine.segment_cells, coarse.segment_cells);
        EXPECT_EQ(fine.segment_sides, coarse.segment_sides);
        EXPECT_EQ(fine.point_count, mesh.node_count());
    }
    const Mesh flat = of_order_two(unit_square_mesh(2)); // order 2, but straight
    EXPECT_EQ(tessellate_within(flat, flat.nodes, 1e-5).triangles.size(), 3U * 8);
}

TEST(FineTessellation, SubdividesTheInteriorOfABilinearSaddle) {
    const Mesh saddle = mesh_of({CellShape::quadrilateral, 1}, 3,
                                {{0, 0, 0}, {1, 0, .5}, {1, 1, 0}, {0, 1, .5}}, {0, 1, 2, 3});
    const Tessellation t = tessellate_within(saddle, saddle.nodes, 1e-3);
    EXPECT_EQ(t.segments.size(), 2U * 4) << "its edges are straight";
    EXPECT_LE(error_of(saddle, saddle.nodes, t), 1e-3);
    const Points points = shown_points(t, saddle.nodes); // the nodes, and those between
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(points[i], saddle.nodes[i]);
    EXPECT_GT(t.point_count, 4U);
}

TEST(FineTessellation, SubdividesCurvedLines) {
    // A parabola of height 1/4 over [0, 1]: with n pieces the error is 1 / (4 n^2).
    const Mesh arc = mesh_of({CellShape::line, 2}, 2, {{0, 0, 0}, {1, 0, 0}, {.5, .25, 0}}, {0, 1, 2});
    const Tessellation t = tessellate_within(arc, arc.nodes, 0.25 / 64 * 1.01);
    EXPECT_EQ(t.segments.size(), 2U * 8);
    EXPECT_EQ(t.segment_cells, std::vector<std::uint32_t>(8, 0));
    EXPECT_TRUE(t.triangles.empty());
    for (std::size_t i = 0; i < t.segments.size(); ++i) EXPECT_EQ(t.segment_sides[i], t.segments[i / 2 * 2]);
    const Points points = shown_points(t, arc.nodes);
    for (std::size_t i = 0; i < 8; ++i) {
        const double s = static_cast<double>(i) / 8;
        EXPECT_NEAR(points.x[t.segments[2 * i]], s, 1e-15);
        EXPECT_NEAR(points.y[t.segments[2 * i]], s * (1 - s), 1e-15);
    }
}

TEST(FineTessellation, ShowsTheBoundaryOfSolids) {
    const Mesh cubes = of_order_two(two_cubes());
    Points x = cubes.nodes;
    for (std::size_t i = 0; i < x.size(); ++i) x.z[i] += 0.2 * x.x[i] * x.x[i];
    const Tessellation t = tessellate_within(cubes, x, 1e-3);
    EXPECT_EQ(cracks(t), 0U);
    EXPECT_GT(t.triangle_cells.size(), 20U);
}

TEST(FineTessellation, IsScaleInvariant) {
    const Mesh mesh = cubed_sphere_mesh(2);
    Mesh earth = mesh;
    for (auto* coordinate : {&earth.nodes.x, &earth.nodes.y, &earth.nodes.z})
        for (double& value : *coordinate) value *= 8192; // a power of two: the same digits
    const Tessellation small = tessellate_within(mesh, pulled(mesh.nodes), 1e-3);
    Points x = pulled(mesh.nodes);
    for (auto* coordinate : {&x.x, &x.y, &x.z})
        for (double& value : *coordinate) value *= 8192;
    EXPECT_EQ(tessellate_within(earth, x, 1e-3).triangles, small.triangles);
}

TEST(FineTessellation, RejectsNonFinitePositions) {
    const Mesh mesh = curved_square();
    Points x = mesh.nodes;
    x.z[3] = std::numeric_limits<double>::infinity();
    EXPECT_THROW(tessellate_within(mesh, x, 1e-3), InternalError);
}

// A field that varies along a straight edge is drawn by its nodes, and not by the ends of the edge.
TEST(FineTessellation, CutsStraightEdgesOfHighOrderIntoTheirOrderOrMore) {
    const CellKind kind{CellShape::quadrilateral, 5};
    Mesh square{.kind = kind, .space_dimension = 2, .nodes = {}, .cells = {}};
    const auto nodes = reference_nodes(kind);
    square.nodes = Points(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        square.nodes.set(i, nodes[i]);
        square.cells.push_back(static_cast<std::int32_t>(i));
    }
    const Tessellation t = tessellate_within(square, square.nodes, 1e-2);
    EXPECT_EQ(t.segments.size() / 2, 4U * 8) << "8 pieces: the power of two from 5 on";
    EXPECT_EQ(t.triangle_cells.size(), 2U * 8 * 8);
    EXPECT_EQ(cracks(t), 4U * 8) << "only the border has one triangle";
}

} // namespace
} // namespace gaspard
