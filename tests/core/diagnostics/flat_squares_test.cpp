// FlatSquares compared with the general measurement, which is used for a mesh that claims to be
// in space.
#include "core/diagnostics/quality.hpp"
#include "support/polynomials.hpp"
#include "support/built_in.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

// Computational cells that are not parallelograms, and physical cells some of which are reversed.
Mesh irregular(int n, double by, unsigned seed) {
    Mesh mesh = unit_square_mesh(n);
    const auto shift = slow::random_values(2 * mesh.node_count(), -by, by, seed);
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
        mesh.nodes.set(i, mesh.nodes[i] + Vec3{shift[2 * i], shift[2 * i + 1], 0});
    return mesh;
}

TEST(FlatSquares, AgreeWithTheGeneralMeasure) {
    for (const int n : {1, 3, 7, 20}) { // partial and full batches
        const auto flat = std::make_shared<Mesh>(irregular(n, 0.2 / n, 1));
        const auto general = std::make_shared<Mesh>(*flat);
        general->space_dimension = 3;
        ASSERT_TRUE(FlatSquares::fits(*flat));
        ASSERT_FALSE(FlatSquares::fits(*general));
        const Points x = irregular(n, 0.5 / n, 2).nodes;
        const auto monitor = make_monitor("ring", {}, {{"sharpness", 50}});
        const MeshQuality ours = QualityMeter(flat).measure(x, *monitor);
        const MeshQuality expected = QualityMeter(general).measure(x, *monitor);
        EXPECT_EQ(ours.tangled_cells, expected.tangled_cells);
        EXPECT_TRUE(n < 20 || ours.tangled_cells > 0);
        EXPECT_NEAR(ours.min_jacobian, expected.min_jacobian, 1e-12);
        EXPECT_NEAR(ours.max_jacobian, expected.max_jacobian, 1e-12);
        EXPECT_NEAR(ours.equidistribution, expected.equidistribution, 1e-12);
        for (std::size_t c = 0; c < flat->cell_count(); ++c) {
            EXPECT_NEAR(ours.cell_mass[c], expected.cell_mass[c], 1e-12);
            EXPECT_NEAR(ours.cell_jacobian[c], expected.cell_jacobian[c], 1e-12);
        }
    }
}

TEST(FlatSquares, ExcludeCurvedCellsTrianglesAndSurfacesInSpace) {
    Mesh mesh = unit_square_mesh(2);
    EXPECT_TRUE(FlatSquares::fits(mesh));
    mesh.kind.order = 2;
    EXPECT_FALSE(FlatSquares::fits(mesh));
    mesh.kind = {CellShape::triangle, 1};
    EXPECT_FALSE(FlatSquares::fits(mesh));
}

} // namespace
} // namespace gaspard
