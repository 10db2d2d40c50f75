#include "core/base/error.hpp"
#include "core/mesh/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace gaspard {
namespace {

const std::vector<CellKind> all_kinds = {
    {CellShape::line, 1},          {CellShape::line, 2},          {CellShape::triangle, 1},
    {CellShape::triangle, 2},      {CellShape::quadrilateral, 1}, {CellShape::quadrilateral, 2},
    {CellShape::hexahedron, 1},    {CellShape::hexahedron, 2},    {CellShape::line, 3},
    {CellShape::quadrilateral, 3}, {CellShape::line, 4},          {CellShape::quadrilateral, 4},
    {CellShape::line, 7},          {CellShape::quadrilateral, 7}, {CellShape::hexahedron, 3},
    {CellShape::hexahedron, 7}};

class Shapes : public testing::TestWithParam<CellKind> {
  protected:
    struct At {
        std::vector<double> values;
        std::vector<Vec3> gradients;
    };
    At at(Vec3 point) const {
        const auto n = static_cast<std::size_t>(nodes_per_cell(GetParam()));
        At result{std::vector<double>(n, 7.0), std::vector<Vec3>(n, Vec3{7, 7, 7})};
        shape_functions(GetParam(), point, result.values, result.gradients);
        return result;
    }
    std::vector<Vec3> random_points() const {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(0, 1);
        std::vector<Vec3> points(20);
        for (Vec3& p : points) {
            p = {unit(random), unit(random), unit(random)};
            if (cell_dimension(GetParam()) < 2) p.y = 0;
            if (cell_dimension(GetParam()) < 3) p.z = 0;
            if (GetParam().shape == CellShape::triangle && p.x + p.y > 1) p.x = 1 - p.x, p.y = 1 - p.y;
        }
        return points;
    }
};

std::string kind_name(const testing::TestParamInfo<CellKind>& run) {
    const std::vector<std::string> names = {"line", "triangle", "quadrilateral", "hexahedron"};
    return names[static_cast<std::size_t>(run.param.shape)] + std::to_string(run.param.order);
}
INSTANTIATE_TEST_SUITE_P(Kinds, Shapes, testing::ValuesIn(all_kinds), kind_name);

TEST_P(Shapes, AddUpToOneAndReproducePositions) {
    const auto nodes = reference_nodes(GetParam());
    for (const Vec3 point : random_points()) {
        const At shape = at(point);
        double sum = 0;
        Vec3 slope, position;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            sum += shape.values[i];
            slope = slope + shape.gradients[i];
            position = position + shape.values[i] * nodes[i];
        }
        EXPECT_NEAR(sum, 1, 1e-14);
        EXPECT_NEAR(norm(slope), 0, 1e-13);
        EXPECT_NEAR(norm(position - point), 0, 1e-14);
    }
}

TEST_P(Shapes, AreOneAtTheirNodeAndZeroAtOthers) {
    const auto nodes = reference_nodes(GetParam());
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        const At shape = at(nodes[j]);
        for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_EQ(shape.values[i], i == j ? 1 : 0);
    }
}

TEST_P(Shapes, HaveTheGradientsOfTheirDifferences) {
    const bool high = GetParam().order > 2;
    const double h = high ? 1.0 / 4096 : 1.0 / 64, tolerance = high ? 1e-8 : 1e-12;
    const auto central = [&](Vec3 point, Vec3 step, std::size_t i) {
        return (at(point + step).values[i] - at(point - step).values[i]) / (2 * h);
    };
    const auto difference = [&](Vec3 point, Vec3 step, std::size_t i) { // exact for degree 2, or 4
        return high ? (4 * central(point, step, i) - central(point, 2 * step, i) / 2) / 3
                    : central(point, step, i);
    };
    const int dimension = cell_dimension(GetParam());
    for (const Vec3 point : random_points()) {
        const At shape = at(point);
        for (std::size_t i = 0; i < shape.values.size(); ++i) {
            EXPECT_NEAR(shape.gradients[i].x, difference(point, {h, 0, 0}, i), tolerance);
            EXPECT_NEAR(shape.gradients[i].y, dimension > 1 ? difference(point, {0, h, 0}, i) : 0, tolerance);
            EXPECT_NEAR(shape.gradients[i].z, dimension > 2 ? difference(point, {0, 0, h}, i) : 0, tolerance);
        }
    }
}

TEST_P(Shapes, AreOfTheOrderTheirKindSays) {
    // Degree k reproduces powers of s + 2 t + 3 u up to the k-th.
    const auto nodes = reference_nodes(GetParam());
    const auto worst = [&](int exponent) {
        const auto power = [exponent](Vec3 p) { return std::pow(p.x + 2 * p.y + 3 * p.z, exponent); };
        double most = 0;
        for (const Vec3 point : random_points()) {
            const At shape = at(point);
            double sum = 0;
            for (std::size_t i = 0; i < nodes.size(); ++i) sum += shape.values[i] * power(nodes[i]);
            most = std::max(most, std::abs(sum - power(point)));
        }
        return most;
    };
    const int order = GetParam().order;
    EXPECT_LT(worst(order), 1e-14 * std::pow(6, order));
    EXPECT_GT(worst(order + 1), order > 1 ? 1e-6 : 0.1);
}

TEST_P(Shapes, HaveEdgesWithTheirMiddleMidway) {
    const std::map<CellShape, std::size_t> count = {{CellShape::line, 1},
                                                    {CellShape::triangle, 3},
                                                    {CellShape::quadrilateral, 4},
                                                    {CellShape::hexahedron, 12}};
    const auto edges = cell_edges(GetParam());
    const auto nodes = reference_nodes(GetParam());
    EXPECT_EQ(edges.size(), count.at(GetParam().shape));
    std::vector<std::pair<int, int>> seen;
    for (const auto& edge : edges) {
        ASSERT_EQ(edge.size(), static_cast<std::size_t>(GetParam().order + 1));
        for (std::size_t end : {0, 1}) EXPECT_LT(edge[end], corners_per_cell(GetParam()));
        const Vec3 a = nodes[static_cast<std::size_t>(edge[0])], b = nodes[static_cast<std::size_t>(edge[1])];
        const double length = norm(b - a);
        if (GetParam().shape == CellShape::triangle)
            EXPECT_TRUE(length == 1 || length == std::sqrt(2.0)) << length;
        else
            EXPECT_EQ(length, 1); // along one side: no diagonals
        for (std::size_t k = 2; k < edge.size(); ++k) {
            EXPECT_GE(edge[k], corners_per_cell(GetParam()));
            const double t = (static_cast<double>(k) - 1) / GetParam().order;
            EXPECT_LT(norm(nodes[static_cast<std::size_t>(edge[k])] - ((1 - t) * a + t * b)), 1e-15);
        }
        seen.emplace_back(std::min(edge[0], edge[1]), std::max(edge[0], edge[1]));
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_TRUE(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
}

TEST_P(Shapes, RefuseRoomOfTheWrongSize) {
    const auto n = static_cast<std::size_t>(nodes_per_cell(GetParam()));
    std::vector<double> values(n + 1);
    std::vector<Vec3> gradients(n);
    EXPECT_THROW(shape_functions(GetParam(), {}, values, gradients), InternalError);
}

TEST(CellKind, NumbersNodesAsInVtk) {
    const auto centre = [](CellKind kind, std::vector<int> corners) {
        Vec3 sum;
        for (const int corner : corners) sum = sum + reference_nodes(kind)[static_cast<std::size_t>(corner)];
        return 1.0 / static_cast<double>(corners.size()) * sum;
    };
    const CellKind square{CellShape::quadrilateral, 2}, cube{CellShape::hexahedron, 2};
    const auto corners = reference_nodes({CellShape::hexahedron, 1});
    const std::vector<Vec3> expected = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                        {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    EXPECT_TRUE(std::equal(corners.begin(), corners.end(), expected.begin(), expected.end()));
    EXPECT_EQ(reference_nodes(square)[8], (Vec3{.5, .5, 0}));
    // VTK_TRIQUADRATIC_HEXAHEDRON: 8 corners, 12 edges (bottom, top, uprights), 6 faces, the middle.
    const std::vector<std::vector<int>> beyond_corners = {{0, 1},
                                                          {1, 2},
                                                          {2, 3},
                                                          {3, 0},
                                                          {4, 5},
                                                          {5, 6},
                                                          {6, 7},
                                                          {7, 4},
                                                          {0, 4},
                                                          {1, 5},
                                                          {2, 6},
                                                          {3, 7},
                                                          {0, 3, 7, 4},
                                                          {1, 2, 6, 5},
                                                          {0, 1, 5, 4},
                                                          {3, 2, 6, 7},
                                                          {0, 1, 2, 3},
                                                          {4, 5, 6, 7},
                                                          {0, 1, 2, 3, 4, 5, 6, 7}};
    ASSERT_EQ(nodes_per_cell(cube), 27);
    for (std::size_t i = 0; i < beyond_corners.size(); ++i)
        EXPECT_EQ(reference_nodes(cube)[8 + i], centre(cube, beyond_corners[i])) << 8 + i;
}

// vtkHigherOrderQuadrilateral: corners, then edges in the directions of s and t (below, right, above, left),
// then rows.
TEST(CellKind, NumbersNodesOfHigherOrderAsInVtk) {
    for (const int k : {2, 3, 5, highest_order}) {
        const auto nodes = reference_nodes({CellShape::quadrilateral, k});
        ASSERT_EQ(nodes.size(), static_cast<std::size_t>((k + 1) * (k + 1)));
        const auto number = [k](int i, int j) {
            const bool at_side = i == 0 || i == k, at_end = j == 0 || j == k;
            if (at_side && at_end) return i > 0 ? (j > 0 ? 2 : 1) : (j > 0 ? 3 : 0);
            if (at_end) return 4 + (j > 0 ? 2 * (k - 1) : 0) + i - 1;
            if (at_side) return 4 + (i > 0 ? k - 1 : 3 * (k - 1)) + j - 1;
            return 4 * k + (k - 1) * (j - 1) + i - 1;
        };
        for (int j = 0; j <= k; ++j)
            for (int i = 0; i <= k; ++i)
                EXPECT_EQ(nodes[static_cast<std::size_t>(number(i, j))],
                          (Vec3{static_cast<double>(i) / k, static_cast<double>(j) / k, 0}));
    }
}

// vtkHigherOrderHexahedron::PointIndexFromIJK of VTK 9: corners, edges along the axes, faces x, y, z, inside.
TEST(CellKind, NumbersNodesOfHexahedraAsInVtk) {
    for (const int k : {2, 3, 4, highest_order}) {
        const auto nodes = reference_nodes({CellShape::hexahedron, k});
        ASSERT_EQ(nodes.size(), static_cast<std::size_t>((k + 1) * (k + 1) * (k + 1)));
        const int m = k - 1;
        const auto number = [k, m](int i, int j, int l) {
            const bool x = i == 0 || i == k, y = j == 0 || j == k, z = l == 0 || l == k;
            const int corner = i > 0 ? (j > 0 ? 2 : 1) : (j > 0 ? 3 : 0);
            if (x && y && z) return corner + (l > 0 ? 4 : 0);
            if (y && z) return 8 + (j > 0 ? 2 * m : 0) + (l > 0 ? 4 * m : 0) + i - 1;
            if (x && z) return 8 + (i > 0 ? m : 3 * m) + (l > 0 ? 4 * m : 0) + j - 1;
            if (x && y) return 8 + 8 * m + corner * m + l - 1;
            const int faces = 8 + 12 * m;
            if (x) return faces + (i > 0 ? m * m : 0) + (l - 1) * m + j - 1;
            if (y) return faces + 2 * m * m + (j > 0 ? m * m : 0) + (l - 1) * m + i - 1;
            if (z) return faces + 4 * m * m + (l > 0 ? m * m : 0) + (j - 1) * m + i - 1;
            return faces + 6 * m * m + ((l - 1) * m + j - 1) * m + i - 1;
        };
        const auto place = [k](int i) { return static_cast<double>(i) / k; };
        for (int l = 0; l <= k; ++l)
            for (int j = 0; j <= k; ++j)
                for (int i = 0; i <= k; ++i)
                    EXPECT_LT(norm(nodes[static_cast<std::size_t>(number(i, j, l))] -
                                   Vec3{place(i), place(j), place(l)}),
                              1e-15);
    }
}

TEST(CellKind, TurnsFacesOutward) {
    for (const int order : {1, 2, 5}) {
        const CellKind kind{CellShape::hexahedron, order};
        const auto nodes = reference_nodes(kind);
        const auto node = [&](int i) { return nodes[static_cast<std::size_t>(i)]; };
        std::map<std::pair<int, int>, int> sides;
        ASSERT_EQ(cell_faces(kind).size(), 6u);
        for (const auto& face : cell_faces(kind)) {
            ASSERT_EQ(face.size(), 4u);
            const Vec3 middle = 0.25 * (node(face[0]) + node(face[1]) + node(face[2]) + node(face[3]));
            const Vec3 outward = middle - Vec3{.5, .5, .5};
            for (std::size_t k = 0; k < 4; ++k) {
                const Vec3 a = node(face[k]), b = node(face[(k + 1) % 4]), c = node(face[(k + 2) % 4]);
                EXPECT_EQ(cross(b - a, c - b), 2 * outward);
                ++sides[{face[k], face[(k + 1) % 4]}];
            }
        }
        EXPECT_EQ(sides.size(), 24u); // every edge once in each direction: the surface is closed
        for (const auto& [side, count] : sides) {
            EXPECT_EQ(count, 1);
            EXPECT_TRUE(sides.contains({side.second, side.first}));
        }
    }
    EXPECT_TRUE(cell_faces({CellShape::quadrilateral, 1}).empty());
}

TEST(CellKind, RefusesOrdersThatAreNotThere) {
    EXPECT_THROW(nodes_per_cell({CellShape::quadrilateral, highest_order + 1}), InternalError);
    EXPECT_THROW(nodes_per_cell({CellShape::triangle, 3}), InternalError);
    EXPECT_THROW(cell_edges({CellShape::line, 0}), InternalError);
}

} // namespace
} // namespace gaspard
