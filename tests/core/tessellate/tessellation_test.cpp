#include "core/spline/spline_domain.hpp"
#include "core/tessellate/tessellation.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <set>

namespace gaspard {
namespace {

double area(const Points& p, const Tessellation& t) {
    double sum = 0;
    for (std::size_t i = 0; i < t.triangles.size(); i += 3)
        sum += norm(cross(p[t.triangles[i + 1]] - p[t.triangles[i]],
                          p[t.triangles[i + 2]] - p[t.triangles[i]])) /
               2;
    return sum;
}

double length(const Points& p, const Tessellation& t) {
    double sum = 0;
    for (std::size_t i = 0; i < t.segments.size(); i += 2)
        sum += norm(p[t.segments[i + 1]] - p[t.segments[i]]);
    return sum;
}

std::set<std::pair<std::uint32_t, std::uint32_t>> distinct_segments(const Tessellation& t) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::size_t i = 0; i < t.segments.size(); i += 2)
        found.insert(std::minmax({t.segments[i], t.segments[i + 1]}));
    return found;
}

TEST(Tessellation, OfStraightSquaresUsesTheNodesThemselves) {
    const Mesh mesh = unit_square_mesh(5);
    const Tessellation t = tessellate(mesh);
    EXPECT_EQ(t.point_count, mesh.node_count());
    EXPECT_TRUE(t.starts.empty());
    EXPECT_EQ(t.triangles.size(), 3U * 2 * 25);
    EXPECT_EQ(shown_points(t, mesh.nodes), mesh.nodes);
    EXPECT_NEAR(area(mesh.nodes, t), 1, 1e-14);
}

TEST(Tessellation, TrianglesHaveTheOrientationAndIndexOfTheirCells) {
    const Mesh mesh = unit_square_mesh(3);
    const Tessellation t = tessellate(mesh);
    for (std::size_t i = 0; i < t.triangle_cells.size(); ++i) {
        const Vec3 a = mesh.nodes[t.triangles[3 * i]], b = mesh.nodes[t.triangles[3 * i + 1]],
                   c = mesh.nodes[t.triangles[3 * i + 2]];
        EXPECT_GT(cross(b - a, c - a).z, 0);
        const Vec3 middle = (1.0 / 3) * (a + b + c);
        const auto column = static_cast<std::uint32_t>(3 * middle.x),
                   row = static_cast<std::uint32_t>(3 * middle.y);
        EXPECT_EQ(t.triangle_cells[i], 3 * row + column);
    }
}

TEST(Tessellation, DrawsEverySharedEdgeOnce) {
    const Tessellation t = tessellate(unit_square_mesh(4));
    EXPECT_EQ(t.segments.size(), 2U * 2 * 4 * 5);
    EXPECT_EQ(distinct_segments(t).size(), 40U);
    EXPECT_NEAR(length(unit_square_mesh(4).nodes, t), 10, 1e-13);
}

TEST(Tessellation, RecordsTheNeighboursOfSegments) {
    const Mesh mesh = unit_square_mesh(4);
    const Tessellation t = tessellate(mesh);
    ASSERT_EQ(t.segment_sides.size(), t.segments.size());
    std::size_t borders = 0;
    for (std::size_t i = 0; i < t.segments.size(); i += 2) {
        const Vec3 a = mesh.nodes[t.segments[i]], along = mesh.nodes[t.segments[i + 1]] - a;
        const auto distance = [&](std::uint32_t p) {
            return cross(along, mesh.nodes[p] - a).z / norm(along);
        };
        const double first = distance(t.segment_sides[i]), second = distance(t.segment_sides[i + 1]);
        EXPECT_NEAR(std::abs(first), 0.25, 1e-14);
        if (t.segment_sides[i] == t.segment_sides[i + 1])
            ++borders;
        else
            EXPECT_NEAR(second, -first, 1e-14); // at the other side
    }
    EXPECT_EQ(borders, 16U);
}

TEST(Tessellation, FillsTriangularCells) {
    const Mesh mesh = two_triangles();
    const Tessellation t = tessellate(mesh);
    EXPECT_EQ(t.triangles, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(distinct_segments(t).size(), 5U);
}

TEST(Tessellation, PlacesPointsOnTheSurfaceOfACurvedSquare) {
    Mesh mesh = curved_square();
    const Tessellation t = tessellate(mesh, 8);
    EXPECT_EQ(t.point_count, 81U);
    EXPECT_EQ(t.triangles.size(), 3U * 128);
    EXPECT_EQ(t.segments.size(), 2U * 32);
    // Fields given by quadratic polynomials are shown exactly.
    std::vector<double> square(mesh.node_count());
    for (std::size_t i = 0; i < square.size(); ++i)
        square[i] = mesh.nodes.x[i] * mesh.nodes.x[i] - mesh.nodes.x[i] * mesh.nodes.y[i];
    const Points points = shown_points(t, mesh.nodes);
    const std::vector<double> shown = shown_values(t, square);
    for (std::size_t p = 0; p < t.point_count; ++p)
        EXPECT_NEAR(shown[p], points.x[p] * points.x[p] - points.x[p] * points.y[p], 1e-14);
}

TEST(Tessellation, WeightsOfEveryPointSumToOne) {
    const Tessellation t = tessellate(curved_square(), 5);
    for (std::size_t p = 0; p < t.point_count; ++p)
        EXPECT_NEAR(
            std::accumulate(t.weights.begin() + t.starts[p], t.weights.begin() + t.starts[p + 1], 0.0), 1,
            1e-14);
}

/// A disk of four curved triangles around the origin; midpoints of the outer edges on the circle.
Mesh curved_disk() {
    Mesh mesh;
    mesh.kind = {CellShape::triangle, 2};
    mesh.nodes = Points(13);
    const double pi = std::acos(-1.0);
    const auto polar = [](double r, double angle) {
        return Vec3{r * std::cos(angle), r * std::sin(angle), 0};
    };
    for (std::size_t q = 0; q < 4; ++q) {
        const double angle = pi / 2 * static_cast<double>(q);
        mesh.nodes.set(1 + q, polar(1, angle));
        mesh.nodes.set(5 + q, polar(0.5, angle));
        mesh.nodes.set(9 + q, polar(1, angle + pi / 4));
        const int a = static_cast<int>(q), b = (a + 1) % 4;
        for (const int node : {0, 1 + a, 1 + b, 5 + a, 9 + a, 5 + b}) mesh.cells.push_back(node);
    }
    return mesh;
}

TEST(Tessellation, CurvedTrianglesMeetWithoutGapsAndFollowTheCircle) {
    const Mesh mesh = curved_disk();
    const Tessellation t = tessellate(mesh, 8);
    EXPECT_EQ(t.point_count,
              1U + 4 * 8 + 4 * 28); // centre, inner spokes' and outer points, and those between
    const Points points = shown_points(t, mesh.nodes);
    // The outer edges are parabolas through the circle's points.
    const double chord = std::sqrt(2.0), height = 1 - std::sqrt(0.5);
    const double root = std::sqrt(chord * chord + 16 * height * height);
    const double arc = root / 2 + chord * chord / (8 * height) * std::log((4 * height + root) / chord);
    EXPECT_NEAR(area(points, t), 4 * (0.5 + chord * height * 2 / 3), 0.02);
    EXPECT_EQ(t.segments.size(), 2U * 8 * 8);
    EXPECT_NEAR(length(points, t), 4 + 4 * arc, 0.02);
}

TEST(Tessellation, ShowsOnlyTheBoundaryOfSolids) {
    const Mesh mesh = two_cubes();
    const Tessellation t = tessellate(mesh);
    EXPECT_EQ(t.triangles.size(), 3U * 2 * 10); // 12 faces except the two interior ones
    EXPECT_NEAR(area(mesh.nodes, t), 10, 1e-14);
    EXPECT_EQ(distinct_segments(t).size(), 20U);
    EXPECT_EQ(t.segments.size(), 40U);
}

TEST(Tessellation, ConsistsOfSegmentsForLines) {
    const Mesh mesh = three_lines();
    const Tessellation t = tessellate(mesh);
    EXPECT_TRUE(t.triangles.empty());
    EXPECT_EQ(t.segments, (std::vector<std::uint32_t>{0, 2, 2, 3, 3, 1}));
    EXPECT_EQ(t.segment_sides, (std::vector<std::uint32_t>{0, 0, 2, 2, 3, 3})); // no neighbours
    EXPECT_EQ(t.segment_cells, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(point_means(t, std::vector<double>{1, 3, 9}), (std::vector<double>{1, 9, 2, 6}));
}

TEST(Tessellation, PointMeansAverageTheAdjacentTriangles) {
    const Tessellation t = tessellate(two_triangles());
    EXPECT_EQ(point_means(t, std::vector<double>{2, 6}), (std::vector<double>{4, 2, 4, 6}));
    EXPECT_TRUE(t.segment_cells.empty());
    EXPECT_EQ(t.cuts, 1);
    EXPECT_EQ(tessellate(curved_square(), 5).cuts, 5);
}

TEST(Tessellation, CurvesDeviateByLessThanAThousandthOfAnEdge) {
    for (const int k : {1, 2, 5, 16}) {
        const Mesh mesh = cubed_sphere_mesh(k);
        const Tessellation t = tessellate(mesh, cuts_for(mesh, mesh.nodes));
        const Points points = shown_points(t, mesh.nodes);
        double stray = 0; // distance of the midpoint of a piece, which lies on a parabola, from the sphere
        for (std::size_t i = 0; i < t.segments.size(); i += 2) {
            const Vec3 a = points[t.segments[i]], b = points[t.segments[i + 1]];
            const double sagitta = (norm(a) + norm(b)) / 2 - norm(0.5 * (a + b));
            stray = std::max(stray, sagitta / (t.cuts * norm(b - a)));
        }
        EXPECT_LT(stray, k == 1 ? 2.5e-3 : 1.1e-3) << k << ": " << t.cuts << " pieces";
        EXPECT_LE(t.triangles.size() / 3, 600000U);
    }
    EXPECT_EQ(cuts_for(unit_square_mesh(3), unit_square_mesh(3).nodes), 1) << "straight";
}

TEST(Tessellation, RecordsTheNeighboursOfCurvedSegments) {
    const Mesh mesh = cubed_sphere_mesh(3);
    const Tessellation t = tessellate(mesh, 4);
    const Points points = shown_points(t, mesh.nodes);
    for (std::size_t i = 0; i < t.segments.size(); i += 2) {
        const Vec3 a = points[t.segments[i]], along = points[t.segments[i + 1]] - a;
        for (std::size_t side = 0; side < 2; ++side) {
            const Vec3 across = points[t.segment_sides[i + side]] - a;
            EXPECT_NEAR(norm(cross(along, across)) / norm(along), std::numbers::pi / 6, 0.2)
                << "a cell's width";
        }
    }
}

TEST(Tessellation, OutlinesAreClosedLinesAroundCells) {
    const Mesh mesh = cubed_sphere_mesh(2);
    const Tessellation t = tessellate(mesh, 4);
    const std::vector<std::uint32_t> cells{3, 7};
    const auto loops = cell_outlines(t, cells);
    ASSERT_EQ(loops.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(loops[k].size(), 16U);
        for (int corner = 0; corner < 4; ++corner) {
            const auto node =
                static_cast<std::uint32_t>(mesh.cell(cells[k])[static_cast<std::size_t>(corner)]);
            EXPECT_TRUE(std::any_of(loops[k].begin(), loops[k].end(),
                                    [&](std::uint32_t p) { return t.node_of(p) == node; }));
        }
    }
    EXPECT_TRUE(cell_outlines(t, {}).empty());
}

TEST(Tessellation, FollowsMovedNodes) {
    const Mesh mesh = curved_square();
    const Tessellation t = tessellate(mesh, 4);
    Points lifted = mesh.nodes;
    for (double& z : lifted.z) z += 3;
    const Points before = shown_points(t, mesh.nodes), after = shown_points(t, lifted);
    for (std::size_t p = 0; p < t.point_count; ++p) EXPECT_NEAR(after.z[p], before.z[p] + 3, 1e-13);
}

// Cells of a patch have the degree of its splines: what is drawn is the map, at every point.
TEST(Tessellation, CellsOfHighOrderCarryPolynomialsOfTheirDegree) {
    for (const int degree : {3, 5, 7}) {
        const Mesh mesh = *SplineDomain(degree, 2, square_map()).mesh();
        const auto map = [degree](Vec3 p) {
            return Vec3{p.x + 0.3 * std::pow(p.x * p.y, degree), p.y - std::pow(1 - p.x, degree) * p.y * p.y,
                        0};
        };
        Points x(mesh.node_count());
        for (std::size_t i = 0; i < x.size(); ++i) x.set(i, map(mesh.nodes[i]));
        for (const int cuts : {2, degree, 2 * degree}) {
            const Tessellation made = tessellate(mesh, cuts);
            const Points from = shown_points(made, mesh.nodes), to = shown_points(made, x);
            EXPECT_EQ(from.size(), static_cast<std::size_t>((2 * cuts + 1) * (2 * cuts + 1)));
            std::size_t nodes = 0;
            for (std::uint32_t p = 0; p < from.size(); ++p) {
                EXPECT_LT(norm(to[p] - map(from[p])), 1e-12);
                if (const auto node = made.node_of(p)) {
                    ++nodes;
                    EXPECT_EQ(to[p], x[*node]);
                }
            }
            if (cuts % degree == 0)
                EXPECT_EQ(nodes, mesh.node_count());
            else
                EXPECT_LT(nodes, mesh.node_count());
        }
        EXPECT_EQ(cuts_for(mesh, x) % degree, 0) << "every node is shown";
    }
}

} // namespace
} // namespace gaspard
