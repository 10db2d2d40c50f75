#include "core/base/error.hpp"
#include "core/mesh/mesh.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace gaspard {
namespace {

const std::vector<CellKind> all_kinds = {{CellShape::line, 1},          {CellShape::line, 2},
                                         {CellShape::triangle, 1},      {CellShape::triangle, 2},
                                         {CellShape::quadrilateral, 1}, {CellShape::quadrilateral, 2},
                                         {CellShape::hexahedron, 1},    {CellShape::hexahedron, 2}};

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
    const double h = 1.0 / 64; // central differences are exact for degree 2 in each variable
    const auto difference = [&](Vec3 point, Vec3 step, std::size_t i) {
        return (at(point + step).values[i] - at(point - step).values[i]) / (2 * h);
    };
    const int dimension = cell_dimension(GetParam());
    for (const Vec3 point : random_points()) {
        const At shape = at(point);
        for (std::size_t i = 0; i < shape.values.size(); ++i) {
            EXPECT_NEAR(shape.gradients[i].x, difference(point, {h, 0, 0}, i), 1e-12);
            EXPECT_NEAR(shape.gradients[i].y, dimension > 1 ? difference(point, {0, h, 0}, i) : 0, 1e-12);
            EXPECT_NEAR(shape.gradients[i].z, dimension > 2 ? difference(point, {0, 0, h}, i) : 0, 1e-12);
        }
    }
}

TEST_P(Shapes, AreOfTheOrderTheirKindSays) {
    // Degree 1 reproduces s + 2 t + 3 u, degree 2 also the square of it.
    const auto linear = [](Vec3 p) { return p.x + 2 * p.y + 3 * p.z; };
    const auto nodes = reference_nodes(GetParam());
    double worst = 0;
    for (const Vec3 point : random_points()) {
        const At shape = at(point);
        double sum = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            sum += shape.values[i] * linear(nodes[i]) * linear(nodes[i]);
        worst = std::max(worst, std::abs(sum - linear(point) * linear(point)));
    }
    if (GetParam().order == 2)
        EXPECT_LT(worst, 1e-13);
    else
        EXPECT_GT(worst, 0.1);
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
        if (GetParam().order == 2) {
            EXPECT_GE(edge[2], corners_per_cell(GetParam()));
            EXPECT_EQ(nodes[static_cast<std::size_t>(edge[2])], 0.5 * (a + b));
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

TEST(CellKind, TurnsFacesOutward) {
    for (const int order : {1, 2}) {
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
    EXPECT_THROW(nodes_per_cell({CellShape::quadrilateral, 3}), InternalError);
    EXPECT_THROW(cell_edges({CellShape::line, 0}), InternalError);
}

} // namespace
} // namespace gaspard
