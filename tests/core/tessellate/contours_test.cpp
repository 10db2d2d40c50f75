#include "core/mesh/mesh.hpp"
#include "core/tessellate/contours.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace gaspard {
namespace {

using Levels = std::vector<double>;

TEST(ContourLevels, AreMultiplesOfTheSmallestRoundStepThatIsLargeEnough) {
    const ContourLevels ten = contour_levels({0, 1.63}, 10);
    EXPECT_EQ(ten.values, (Levels{0.2, 0.4, 0.6, 0.8, 1, 1.2, 1.4, 1.6}));
    EXPECT_EQ(ten.text, "every 0.2");
    EXPECT_EQ(contour_levels({0, 1.63}, 16).values.size(), 16U) << "steps of 0.1";
    EXPECT_EQ(contour_levels({0, 1.63}, 15).values.size(), 8U);
    EXPECT_EQ(contour_levels({-3, 3}, 5).values, (Levels{-2, -1, 0, 1, 2})) << "the ends are none";
    EXPECT_EQ(contour_levels({2e-9, 9e-9}, 2).values, (Levels{5e-9}));
    EXPECT_EQ(contour_levels({2.1e-9, 9e-9}, 4).values, (Levels{4e-9, 6e-9, 8e-9}));
    EXPECT_EQ(contour_levels({1e5, 4.5e5}, 4).values, (Levels{2e5, 3e5, 4e5}));
    for (int most = 1; most <= 100; ++most) {
        const std::size_t count = contour_levels({-0.37, 12.9}, most).values.size();
        EXPECT_LE(count, static_cast<std::size_t>(most));
        EXPECT_GE(3 * count + 3, static_cast<std::size_t>(most)) << "not far fewer";
    }
}

TEST(ContourLevels, OfALogarithmicRangeArePowersOfTenAndTheirMultiples) {
    EXPECT_EQ(contour_levels({1, 100, true}, 20).values,
              (Levels{2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 30, 40, 50, 60, 70, 80, 90}));
    const ContourLevels some = contour_levels({0.5, 300, true}, 10);
    EXPECT_EQ(some.values, (Levels{1, 2, 5, 10, 20, 50, 100, 200}));
    EXPECT_EQ(some.text, "at 1, 2, 5, 10");
    const ContourLevels few = contour_levels({0.5, 300, true}, 4);
    EXPECT_EQ(few.values, (Levels{1, 10, 100}));
    EXPECT_EQ(few.text, "every decade");
    const ContourLevels sparse = contour_levels({2e-9, 3, true}, 5);
    EXPECT_EQ(sparse.values, (Levels{1e-8, 1e-6, 1e-4, 1e-2, 1}));
    EXPECT_EQ(sparse.text, "every 2 decades");
    EXPECT_EQ(contour_levels({2, 7, true}, 5).values, (Levels{3, 4, 5, 6})) << "within a decade";
}

TEST(ContourLevels, ThereAreNoneInARangeWithoutAnythingBetween) {
    const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
    EXPECT_TRUE(contour_levels({2, 2}, 10).values.empty());
    EXPECT_TRUE(contour_levels({0, 1}, 0).values.empty());
    EXPECT_TRUE(contour_levels({0, 1}, 0).text.empty());
    EXPECT_TRUE(contour_levels({-huge, huge}, 10).values.empty());
    EXPECT_LE(contour_levels({1, std::nextafter(1, 2)}, 10).values.size(), 10U);
    EXPECT_LE(contour_levels({0, tiny}, 10).values.size(), 10U);
    EXPECT_LE(contour_levels({tiny, huge, true}, 10).values.size(), 10U);
}

/// u = 3 x - y + 2 on a mesh whose nodes are moved.
class ContourLines : public testing::Test {
  protected:
    static double u(Vec3 x) { return 3 * x.x - x.y + 2; }
    explicit ContourLines() : mesh_(unit_square_mesh(7)), x_(mesh_.nodes) {
        for (std::size_t i = 0; i < x_.size(); ++i) {
            x_.x[i] += 0.03 * std::sin(9 * x_.y[i]);
            x_.y[i] += 0.02 * std::sin(7 * x_.x[i]);
            values_.push_back(u(x_[i]));
        }
        shape_ = tessellate(mesh_);
    }
    Mesh mesh_;
    Points x_;
    Levels values_;
    Tessellation shape_;
};

TEST_F(ContourLines, OfALinearFunctionAreStraight) {
    const Levels levels = {1.5, 2, 3.25, 4.4};
    const auto lines = contour_lines(shape_, values_, levels);
    std::map<std::uint32_t, int> count;
    for (const ContourSegment& segment : lines) {
        ++count[segment.level];
        for (const ContourPoint& point : {segment.from, segment.to}) {
            EXPECT_LT(point.a, point.b);
            EXPECT_NEAR(u(point.in(x_)), levels[segment.level], 1e-13);
        }
    }
    ASSERT_EQ(count.size(), 4U);
    for (const auto& [level, segments] : count) EXPECT_GE(segments, 5) << level;
    // Nearly all ends are shared with a neighbour: the others lie on the border.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> ends;
    for (const ContourSegment& segment : lines)
        if (segment.level == 1)
            for (const ContourPoint& point : {segment.from, segment.to}) ++ends[{point.a, point.b}];
    EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [](const auto& end) { return end.second == 1; }), 2);
    for (const auto& [edge, times] : ends) EXPECT_LE(times, 2);
}

TEST_F(ContourLines, RunAlongEdgesOnWhichTheFieldHasTheLevel) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = std::abs(mesh_.nodes.x[i] - 3.0 / 7) - 0.5;
    const Levels ridge = {-0.5};
    EXPECT_TRUE(contour_lines(shape_, values_, ridge).empty()) << "a minimum is reached, but not crossed";
    for (double& value : values_) value = -value;
    const Levels top = {0.5};
    double length = 0;
    for (const ContourSegment& segment : contour_lines(shape_, values_, top)) {
        const Vec3 from = segment.from.in(mesh_.nodes), to = segment.to.in(mesh_.nodes);
        length += norm(to - from);
        EXPECT_NEAR(from.x, 3.0 / 7, 1e-9);
    }
    EXPECT_NEAR(length, 2, 1e-9) << "the edge of length 1, once for each side";
}

TEST_F(ContourLines, AreNotDrawnByRoundingOrWhereValuesAreMissing) {
    const Levels zero = {0};
    for (std::size_t i = 0; i < values_.size(); ++i)
        values_[i] = mesh_.nodes.x[i] > 0.5 ? mesh_.nodes.x[i] : (i % 2 == 0 ? 1e-15 : -1e-15);
    EXPECT_TRUE(contour_lines(shape_, values_, zero).empty());
    const Levels half = {0.3};
    const std::size_t count = contour_lines(shape_, values_, half).size();
    EXPECT_GE(count, 14U);
    values_[27] = std::nan("");
    const auto rest = contour_lines(shape_, values_, half);
    EXPECT_LT(rest.size(), count);
    EXPECT_GT(rest.size(), count - 7);
}

TEST(ContourLinesOnCurvedCells, LieOnTheTrianglesThatAreDrawn) {
    // One quadratic cell, u = r^2: exact at shown points, linear between.
    Mesh mesh;
    mesh.kind = {CellShape::quadrilateral, 2};
    mesh.space_dimension = 2;
    mesh.nodes = Points(9);
    mesh.nodes.x = {0, 1, 1, 0, 0.5, 1, 0.5, 0, 0.5};
    mesh.nodes.y = {0, 0, 1, 1, 0, 0.5, 1, 0.5, 0.5};
    mesh.cells = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    const Tessellation shape = tessellate(mesh, 16);
    Levels nodes;
    for (std::size_t i = 0; i < 9; ++i) nodes.push_back(dot(mesh.nodes[i], mesh.nodes[i]));
    const Points shown = shown_points(shape, mesh.nodes);
    const Levels values = shown_values(shape, nodes), levels = {0.49};
    const auto lines = contour_lines(shape, values, levels);
    EXPECT_GE(lines.size(), 16U);
    for (const ContourSegment& segment : lines)
        for (const ContourPoint& point : {segment.from, segment.to})
            EXPECT_NEAR(norm(point.in(shown)), 0.7, 2e-3);
}

} // namespace
} // namespace gaspard
