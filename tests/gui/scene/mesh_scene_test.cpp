#include "gui/scene/mesh_scene.hpp"
#include "gui/scenes.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(MeshScene, SharesWhatHasNotChanged) {
    SceneBuilder maker;
    Snapshot snapshot = ring_snapshot(6);
    const MeshScene first = maker.make(snapshot, view("monitor", 1));
    const MeshScene again = maker.make(snapshot, view("monitor", 0.5));
    EXPECT_EQ(again.physical, first.physical);
    EXPECT_EQ(again.colouring, first.colouring);
    EXPECT_EQ(again.blend, 0.5);

    ++snapshot.version;
    const MeshScene next = maker.make(snapshot, view("monitor", 1));
    EXPECT_EQ(next.tessellation, first.tessellation);
    EXPECT_EQ(next.computational, first.computational);
    EXPECT_NE(next.physical, first.physical);

    Snapshot other = ring_snapshot(6);
    other.version = snapshot.version;
    EXPECT_NE(maker.make(other, view("monitor", 1)).tessellation, first.tessellation) << "another mesh";
}

TEST(MeshScene, FollowsTheChosenColour) {
    SceneBuilder maker;
    const Snapshot snapshot = ring_snapshot(6);
    const MeshScene coloured = maker.make(snapshot, view("monitor", 1));
    ASSERT_NE(coloured.colouring, nullptr);
    EXPECT_EQ(coloured.colouring->name, "monitor");
    EXPECT_EQ(*coloured.point_values, snapshot.fields[0].values);
    EXPECT_FALSE(coloured.flat());
    EXPECT_EQ(coloured.colouring->range, range_of(snapshot.fields[0].values));
    EXPECT_EQ(maker.make(snapshot, view("none")).colouring, nullptr);
    EXPECT_EQ(maker.make(snapshot, view("none")).point_values, nullptr);
    const MeshScene areas = maker.make(snapshot, view("area"));
    ASSERT_TRUE(areas.flat());
    EXPECT_EQ(areas.colouring->values.size(), snapshot.mesh->cell_count());
    EXPECT_EQ(*areas.point_values, point_means(*areas.tessellation, areas.colouring->values));
    Values lines = view("area");
    lines.set("lines", false);
    EXPECT_FALSE(maker.make(snapshot, lines).lines);
    EXPECT_EQ(maker.make(snapshot, lines).colouring, areas.colouring) << "not coloured anew";
    lines.set("log", true);
    EXPECT_TRUE(maker.make(snapshot, lines).colouring->range.logarithmic);
}

TEST(MeshScene, ListsTangledCells) {
    SceneBuilder maker;
    EXPECT_EQ(maker.make(ring_snapshot(6), view("none", 1)).tangled, nullptr);
    const MeshScene tangled = maker.make(tangled_snapshot(6), view("none", 1));
    ASSERT_NE(tangled.tangled, nullptr);
    EXPECT_EQ(tangled.tangled->size(), 1U);
}

TEST(MeshScene, BoxHoldsBothMeshes) {
    Snapshot snapshot = ring_snapshot(4);
    snapshot.x = snapshot.mesh->nodes;
    for (double& x : snapshot.x.x) x += 2;
    const Box box = SceneBuilder().make(snapshot, view("none", 1)).box;
    EXPECT_EQ(box.low.x, 0);
    EXPECT_EQ(box.high.x, 3);
    EXPECT_TRUE(SceneBuilder().make(snapshot, view("none", 1)).planar());
    EXPECT_FALSE(SceneBuilder().make(sphere_snapshot(2), view("none", 1)).planar());
}

} // namespace
} // namespace gaspard
