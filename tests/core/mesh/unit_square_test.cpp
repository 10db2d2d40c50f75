#include "core/base/error.hpp"
#include "core/mesh/domain_type.hpp"
#include "core/mesh/mesh.hpp"

#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

TEST(UnitSquare, NumbersNodesAndCellsRowByRow) {
    const int n = 3;
    const Mesh mesh = unit_square_mesh(n);
    EXPECT_EQ(mesh.kind, (CellKind{CellShape::quadrilateral, 1}));
    EXPECT_EQ(mesh.space_dimension, 2);
    ASSERT_EQ(mesh.node_count(), 16u);
    ASSERT_EQ(mesh.cell_count(), 9u);
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const Vec3 node = mesh.nodes[static_cast<std::size_t>(j * (n + 1) + i)];
            EXPECT_EQ(node, (Vec3{i / 3.0, j / 3.0, 0}));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto cell = mesh.cell(static_cast<std::size_t>(j * n + i));
            const int corners[4][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}};
            for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(cell[k], corners[k][1] * (n + 1) + corners[k][0]);
        }
}

TEST(UnitSquare, EndsAtOneExactly) {
    for (const int n : {1, 7, 49, 480}) {
        const Mesh mesh = unit_square_mesh(n);
        EXPECT_EQ(mesh.nodes[mesh.node_count() - 1], (Vec3{1, 1, 0}));
        EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(n)], (Vec3{1, 0, 0}));
    }
}

TEST(UnitSquare, RefusesNoCells) {
    EXPECT_THROW(unit_square_mesh(0), InternalError);
    EXPECT_THROW(unit_square_mesh(-3), InternalError);
}

TEST(Displacement, IsStraightInEuclideanSpace) {
    EXPECT_EQ(displacement({}, {0.25, 0, -1}, {8.5, 0.75, 3}), (Vec3{8.25, 0.75, 4}));
}

TEST(Displacement, IsTheShortestOfAllImagesOnTheTorus) {
    const Space torus{SpaceKind::periodic_square};
    std::mt19937 random(4);
    std::uniform_real_distribution<double> coordinate(-2, 3);
    for (int trial = 0; trial < 500; ++trial) {
        const Vec3 from{coordinate(random), coordinate(random), 0};
        const Vec3 to{coordinate(random), coordinate(random), 0};
        Vec3 best{1e9, 0, 0};
        for (int j = -6; j <= 6; ++j)
            for (int i = -6; i <= 6; ++i) {
                const Vec3 d = to + Vec3{static_cast<double>(i), static_cast<double>(j), 0} - from;
                if (norm(d) < norm(best)) best = d;
            }
        EXPECT_NEAR(norm(displacement(torus, from, to) - best), 0, 1e-14);
    }
}

TEST(Displacement, IsExactForPointsInTheSameHalf) {
    const Space torus{SpaceKind::periodic_square};
    EXPECT_EQ(displacement(torus, {0.5, 0.5, 0}, {0.75, 0.25, 0}), (Vec3{0.25, -0.25, 0}));
    EXPECT_EQ(displacement(torus, {0.125, 0.875, 0}, {0.875, 0.125, 0}), (Vec3{-0.25, 0.25, 0}));
}

TEST(PlaneDomain, IsATorusOrHasWalls) {
    const DomainType plane = plane_domain();
    Values values("domain", plane.rows);
    EXPECT_EQ(plane.space(values, {}).kind, SpaceKind::periodic_square);
    values.set("boundary", std::string("walls"));
    EXPECT_EQ(plane.space(values, {}).kind, SpaceKind::euclidean);
    EXPECT_EQ(values.integer("cells"), 60);
    EXPECT_THROW(values.set("cells", std::int64_t{3}), InputError);
    EXPECT_THROW(values.set("cells", std::int64_t{481}), InputError);
}

} // namespace
} // namespace gaspard
