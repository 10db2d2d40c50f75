#include "core/tessellate/tessellation_cache.hpp"

#include <gtest/gtest.h>
#include <thread>

namespace gaspard {
namespace {

TEST(TessellationCache, MakesOneOfEachMeshAndForgetsThoseThatAreGone) {
    TessellationCache cache;
    auto mesh = std::make_shared<const Mesh>(unit_square_mesh(3));
    const auto other = std::make_shared<const Mesh>(unit_square_mesh(4));
    const auto first = cache.get(mesh);
    EXPECT_EQ(cache.get(mesh), first);
    EXPECT_EQ(first->point_count, 16U);
    EXPECT_EQ(cache.get(other)->point_count, 25U);
    std::weak_ptr<const Tessellation> gone = cache.get(mesh);
    mesh.reset();
    EXPECT_EQ(gone.use_count(), 2) << "held by the cache and by this test";
    cache.get(other);
    EXPECT_EQ(gone.use_count(), 1);
}

TEST(TessellationCache, GivesThreadsTheSame) {
    for (int i = 0; i < 20; ++i) {
        TessellationCache cache;
        const auto mesh = std::make_shared<const Mesh>(unit_square_mesh(20));
        std::shared_ptr<const Tessellation> there;
        {
            const std::jthread thread([&] { there = cache.get(mesh); });
            cache.get(mesh);
        }
        EXPECT_EQ(there, cache.get(mesh));
    }
}

} // namespace
} // namespace gaspard
