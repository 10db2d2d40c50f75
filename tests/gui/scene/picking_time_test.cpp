#include "core/base/stopwatch.hpp"
#include "gui/scene/picking.hpp"
#include "gui/scenes.hpp"

#include <cstdio>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(PickingTime, OfAClickIsShortAtAnyResolution) {
    constexpr Size size{800, 600};
    const MeshScene scene = SceneBuilder().make(ring_snapshot(480), view("none", 1));
    const Camera camera = home(scene.box, size);
    const Stopwatch watch;
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(pick_at(scene, camera, size, {300.0 + 10 * i, 250}, 8));
    std::printf("n = 480: %.1f ms of CPU a click\n", 100 * watch.cpu_seconds());
    EXPECT_LT(watch.cpu_seconds() / 10, 0.1);
}

} // namespace
} // namespace gaspard
