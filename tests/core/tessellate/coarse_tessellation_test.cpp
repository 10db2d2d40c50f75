#include "core/tessellate/coarse_tessellation.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "support/small_meshes.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// The coarse tessellation is that of fewer cuts: the same triangles and segments in the same places.
void expect_same(const Mesh& mesh, const Tessellation& coarse, const Tessellation& fine, int cuts) {
    const Tessellation wanted = tessellate(mesh, cuts);
    const Points points = shown_points(fine, mesh.nodes), places = shown_points(wanted, mesh.nodes);
    EXPECT_EQ(coarse.cuts, cuts);
    EXPECT_EQ(coarse.triangle_cells, wanted.triangle_cells);
    const auto compare = [&](const std::vector<std::uint32_t>& these,
                             const std::vector<std::uint32_t>& those) {
        ASSERT_EQ(these.size(), those.size());
        for (std::size_t i = 0; i < these.size(); ++i)
            EXPECT_LT(norm(points[these[i]] - places[those[i]]), 1e-14) << i;
    };
    compare(coarse.triangles, wanted.triangles);
    compare(coarse.segments, wanted.segments);
    compare(coarse.segment_sides, wanted.segment_sides);
}

TEST(CoarseTessellation, OfQuadrilateralsIsTheOneWithFewerCuts) {
    const Mesh mesh = cubed_sphere_mesh(3);
    const Tessellation fine = tessellate(mesh, 6);
    const std::size_t cells = mesh.cell_count();
    const auto coarse = coarsened(fine, 4, 2 * cells * 9);
    ASSERT_TRUE(coarse);
    expect_same(mesh, *coarse, fine, 3);
    const auto coarsest = coarsened(fine, 4, 1);
    ASSERT_TRUE(coarsest);
    expect_same(mesh, *coarsest, fine, 1);
}

TEST(CoarseTessellation, OfTrianglesIsTheOneWithFewerCuts) {
    Mesh mesh = mesh_of({CellShape::triangle, 2}, 2,
                        {{0, 0, 0},
                         {1, 0, 0},
                         {1, 1, 0},
                         {0, 1, 0},
                         {.5, -.1, 0},
                         {1.1, .5, 0},
                         {.4, .6, 0},
                         {.5, 1.1, 0},
                         {-.1, .5, 0}},
                        {0, 1, 2, 4, 6, 5, 0, 2, 3, 6, 8, 7});
    const Tessellation fine = tessellate(mesh, 8);
    for (const int cuts : {4, 2, 1}) {
        const auto coarse = coarsened(fine, 3, static_cast<std::size_t>(2 * cuts * cuts));
        ASSERT_TRUE(coarse);
        expect_same(mesh, *coarse, fine, cuts);
    }
}

TEST(CoarseTessellation, IsNotMadeOfWhatIsCoarseEnough) {
    const Tessellation fine = tessellate(cubed_sphere_mesh(2), 4);
    EXPECT_FALSE(coarsened(fine, 4, fine.triangle_cells.size()));
    EXPECT_FALSE(coarsened(tessellate(two_triangles()), 3, 1));
}

TEST(CoarseTessellation, IsNotMadeOfAnythingButFullGrids) {
    Tessellation fine = tessellate(cubed_sphere_mesh(2), 4);
    Tessellation other = fine;
    other.triangles.resize(other.triangles.size() - 3), other.triangle_cells.pop_back(); // as a cut leaves it
    EXPECT_FALSE(coarsened(other, 4, 1));
    other = fine;
    std::swap(other.triangles[3], other.triangles[7]);
    EXPECT_FALSE(coarsened(other, 4, 1));
    other = fine;
    other.segments[1] = other.segments.back();
    EXPECT_FALSE(coarsened(other, 4, 1));
}

} // namespace
} // namespace gaspard
