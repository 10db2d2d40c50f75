#include "core/diagnostics/cell_quality.hpp"
#include "support/small_meshes.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>

namespace gaspard {
namespace {

constexpr double degree = std::numbers::pi / 180;

CellQuality quality_of(const Mesh& mesh, const std::vector<double>& monitor = {}) {
    return CellQualityMeter(std::make_shared<const Mesh>(mesh)).measure(mesh.nodes, monitor);
}

template <class Map>
Mesh mapped(Mesh mesh, const Map& map) {
    for (std::size_t i = 0; i < mesh.node_count(); ++i) mesh.nodes.set(i, map(mesh.nodes[i]));
    return mesh;
}

template <class Function>
std::vector<double> at_nodes(const Mesh& mesh, const Function& function) {
    std::vector<double> values;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) values.push_back(function(mesh.nodes[i]));
    return values;
}

const std::vector<Mesh> squares = {unit_square_mesh(2), of_order_two(unit_square_mesh(2))};

TEST(CellQuality, OfSquaresAndCubesIsIdealAtAnySize) {
    for (const Mesh& shape : {squares[0], squares[1], two_cubes(), of_order_two(two_cubes())})
        for (const double size : {1.0, 1e8, 1e-8}) {
            SCOPED_TRACE(cell_name(shape.kind) + ", size " + std::to_string(size));
            const Mesh mesh = mapped(shape, [size](Vec3 p) { return size * p; });
            const CellQuality q = quality_of(mesh, at_nodes(mesh, [](Vec3 p) { return 1 + p.x; }));
            for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
                EXPECT_NEAR(q.aspect_ratio[i], 1, 1e-7);
                EXPECT_NEAR(q.skewness[i], 0, 1e-12);
                EXPECT_NEAR(q.orthogonality[i], 0, 1e-10);
                EXPECT_NEAR(q.alignment[i], 0, 1e-6);
            }
        }
}

TEST(CellQuality, OfAStretchedRectangleIsTheRatioOfItsSides) {
    for (const Mesh& shape : squares) {
        const Mesh mesh = mapped(shape, [](Vec3 p) { return Vec3{5 * p.x, p.y, 0}; });
        const CellQuality q = quality_of(mesh);
        EXPECT_NEAR(q.aspect_ratio[0], 5, 1e-12);
        EXPECT_NEAR(q.skewness[0], 0, 1e-12);
        EXPECT_NEAR(q.orthogonality[0], 0, 1e-10);
        EXPECT_TRUE(q.alignment.empty());
    }
    const Mesh box = mapped(two_cubes(), [](Vec3 p) { return Vec3{2 * p.x, 6 * p.y, 3 * p.z}; });
    EXPECT_NEAR(quality_of(box).aspect_ratio[0], 3, 1e-12);
}

TEST(CellQuality, OfAShearedSquareFollowsTheAngle) {
    const double angle = 30;
    const double s = std::sin(angle * degree), c = std::cos(angle * degree);
    for (const Mesh& shape : squares) {
        const Mesh mesh = mapped(shape, [&](Vec3 p) { return Vec3{p.x + s * p.y, c * p.y, 0}; });
        const CellQuality q = quality_of(mesh);
        EXPECT_NEAR(q.aspect_ratio[0], std::sqrt((1 + s) / (1 - s)), 1e-12);
        EXPECT_NEAR(q.skewness[0], angle / 90, 1e-12);
        EXPECT_NEAR(q.orthogonality[0], angle, 1e-9);
    }
    const Mesh solid = mapped(two_cubes(), [&](Vec3 p) { return Vec3{p.x, p.y + s * p.x, p.z}; });
    const double slope = std::atan(s) / degree; // of the line between the centres; the side is not sheared
    const CellQuality q = quality_of(solid);
    EXPECT_NEAR(q.orthogonality[0], slope, 1e-9);
    EXPECT_NEAR(q.skewness[0], slope / 90, 1e-12);
}

TEST(CellQuality, OfTriangles) {
    const double height = std::sqrt(3.0) / 2;
    const Mesh equilateral =
        mesh_of({CellShape::triangle, 1}, 2, {{0, 0, 0}, {1, 0, 0}, {.5, height, 0}, {1.5, height, 0}},
                {0, 1, 2, 1, 3, 2});
    CellQuality q = quality_of(equilateral);
    EXPECT_NEAR(q.aspect_ratio[0], 1, 1e-7);
    EXPECT_NEAR(q.skewness[1], 0, 1e-12);
    EXPECT_NEAR(q.orthogonality[1], 0, 1e-9);
    // A right triangle with equal legs: angles of 45°, 45° and 90°. Its A = W⁻¹ has
    // AᵀA = [[1, −1/√3], [−1/√3, 5/3]], whose eigenvalues are 2 and 2/3.
    for (const Mesh& mesh : {two_triangles(), of_order_two(two_triangles())}) {
        q = quality_of(mesh);
        EXPECT_NEAR(q.aspect_ratio[0], std::sqrt(3.0), 1e-12);
        EXPECT_NEAR(q.skewness[0], 0.25, 1e-12);
        EXPECT_NEAR(q.orthogonality[0], 0, 1e-9);
    }
}

TEST(CellQuality, IsAlignedWhereTheCellIsThinAlongTheGradient) {
    for (const Mesh& shape : {squares[0], squares[1], two_triangles()}) {
        const Mesh mesh = mapped(shape, [](Vec3 p) { return Vec3{3 * p.x, p.y, 0}; });
        const bool triangles = shape.kind.shape == CellShape::triangle;
        const auto along = at_nodes(mesh, [](Vec3 p) { return 1 + p.y; });
        const auto across = at_nodes(mesh, [](Vec3 p) { return 1 + p.x; });
        const auto both = at_nodes(mesh, [](Vec3 p) { return 1 + p.x + p.y; });
        // Squares: q = 1, p = 9. Triangles: A Aᵀ = [[9, 0], [0, 1]] W⁻¹W⁻ᵀ ...: q = 4/3, p = 4/3 * 9 = 12
        const double expected = 0.8;
        EXPECT_NEAR(quality_of(mesh, along).alignment[0], expected, 1e-12);
        EXPECT_NEAR(quality_of(mesh, across).alignment[0], -expected, 1e-12);
        if (!triangles) {
            EXPECT_NEAR(quality_of(mesh, both).alignment[0], 0, 1e-12);
        }
        EXPECT_EQ(quality_of(mesh, std::vector<double>(mesh.node_count(), 7)).alignment[0], 0);
    }
    const Mesh box = mapped(two_cubes(), [](Vec3 p) { return Vec3{p.x, 2 * p.y, 4 * p.z}; });
    // q = 1, p = (4 + 16) / 2
    EXPECT_NEAR(quality_of(box, at_nodes(box, [](Vec3 p) { return 2 + p.x; })).alignment[0], 9.0 / 11, 1e-12);
}

TEST(CellQuality, IsTheSameInEveryPlaneOfSpace) {
    const auto sheared = [](Vec3 p) { return Vec3{2 * p.x + .5 * p.y, p.y + .2 * p.x * p.y, 0}; };
    const Mesh flat = mapped(unit_square_mesh(3), sheared);
    Mesh turned = mapped(flat, [](Vec3 p) { return Vec3{.6 * p.x, p.y, .8 * p.x}; });
    turned.space_dimension = 3;
    std::vector<double> m = at_nodes(flat, [](Vec3 p) { return 1 + p.x * p.y; });
    const CellQuality one = quality_of(flat, m), other = quality_of(turned, m);
    for (const QualityMeasureInfo& measure : quality_measures())
        for (std::size_t i = 0; i < flat.cell_count(); ++i)
            EXPECT_NEAR((one.*measure.values)[i], (other.*measure.values)[i], 1e-9) << measure.name;
}

TEST(CellQuality, OfFlatCellsIsFinite) {
    const Mesh mesh = unit_square_mesh(2);
    const CellQualityMeter meter(std::make_shared<const Mesh>(mesh));
    const Mesh flat = mapped(mesh, [](Vec3 p) { return Vec3{p.x, 0, 0}; });
    const CellQuality q = meter.measure(flat.nodes, at_nodes(mesh, [](Vec3 p) { return 1 + p.y; }));
    EXPECT_EQ(q.aspect_ratio[0], aspect_limit);
    EXPECT_EQ(q.skewness[0], 1);
    for (const QualityMeasureInfo& measure : quality_measures())
        for (const double value : q.*measure.values) EXPECT_TRUE(std::isfinite(value)) << measure.name;
}

TEST(CellQuality, SeriesAreWorstAndMean) {
    CellQuality q{{1, 4}, {0, .5}, {10, 20}, {-.5, 1}};
    const auto values = values_of(q);
    const std::vector<double> expected{4, 2.5, .5, .25, 20, 15, -.5, .25};
    EXPECT_EQ(std::vector<double>(values.begin(), values.end()), expected);
    ASSERT_EQ(cell_quality_series().size(), expected.size());
    EXPECT_EQ(cell_quality_series()[0].name, "max_aspect_ratio");
    EXPECT_EQ(cell_quality_series()[6].name, "min_alignment");
    EXPECT_FALSE(has_quality(three_lines().kind));
}

} // namespace
} // namespace gaspard
