#include "core/tessellate/tessellation_cache.hpp"
#include "support/small_meshes.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <thread>

namespace gaspard {
namespace {

TEST(TessellationCacheThreads, ShareResults) {
    for (int i = 0; i < 20; ++i) {
        TessellationCache cache;
        Snapshot snapshot;
        snapshot.mesh = std::make_shared<const Mesh>(unit_square_mesh(20));
        snapshot.x = snapshot.mesh->nodes;
        snapshot.version = 1;
        std::shared_ptr<const Tessellation> there;
        {
            const std::jthread thread([&] { there = cache.get(snapshot); });
            cache.get(snapshot);
        }
        EXPECT_EQ(there, cache.get(snapshot));
    }
}

} // namespace
} // namespace gaspard
