#include "core/tessellate/tessellation_cache.hpp"
#include "support/small_meshes.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

Snapshot shown(std::shared_ptr<const Mesh> mesh, std::uint64_t version = 1) {
    Snapshot snapshot;
    snapshot.x = mesh->nodes;
    snapshot.mesh = std::move(mesh);
    snapshot.version = version;
    return snapshot;
}

TEST(TessellationCache, KeepsOnePerMeshAndDropsUnusedOnes) {
    TessellationCache cache;
    auto mesh = std::make_shared<const Mesh>(unit_square_mesh(3));
    const auto other = std::make_shared<const Mesh>(unit_square_mesh(4));
    const auto first = cache.get(shown(mesh));
    EXPECT_EQ(cache.get(shown(mesh, 2)), first);
    EXPECT_EQ(first->point_count, 16U);
    EXPECT_EQ(cache.get(shown(other))->point_count, 25U);
    std::weak_ptr<const Tessellation> gone = cache.get(shown(mesh));
    mesh.reset();
    EXPECT_EQ(gone.use_count(), 2) << "held by the cache and by this test";
    cache.get(shown(other));
    EXPECT_EQ(gone.use_count(), 1);
}

TEST(TessellationCache, RefinesOnDemandAndNeverCoarsens) {
    TessellationCache cache;
    Mesh strip = curved_square(); // many copies, since meshes with few cells are always subdivided finely
    const std::vector<std::int32_t> cell = strip.cells;
    for (int i = 1; i < 8000; ++i) strip.cells.insert(strip.cells.end(), cell.begin(), cell.end());
    strip.nodes.z[1] = 0.001;
    const auto mesh = std::make_shared<const Mesh>(std::move(strip));
    Snapshot snapshot = shown(mesh);
    const auto flat = cache.get(snapshot);
    EXPECT_EQ(flat->cuts, 2);
    snapshot.x.z[1] = 0.03;
    EXPECT_EQ(cache.get(snapshot), flat) << "of the same version, which has been measured";
    ++snapshot.version;
    const auto bent = cache.get(snapshot);
    EXPECT_EQ(bent->cuts, 6);
    snapshot.x = mesh->nodes;
    ++snapshot.version;
    EXPECT_EQ(cache.get(snapshot), bent);
}

} // namespace
} // namespace gaspard
