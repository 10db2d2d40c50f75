#include "gui/mesh_picture.hpp"
#include "scenes.hpp"
#include "support/small_meshes.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

TEST(MeshPicture, SharesWhatHasNotChanged) {
    PictureMaker maker;
    Snapshot snapshot = ring_snapshot(6);
    const MeshPicture first = maker.make(snapshot, "monitor", 1);
    const MeshPicture again = maker.make(snapshot, "monitor", 0.5);
    EXPECT_EQ(again.physical, first.physical);
    EXPECT_EQ(again.scalar, first.scalar);
    EXPECT_EQ(again.blend, 0.5);

    ++snapshot.version;
    const MeshPicture next = maker.make(snapshot, "monitor", 1);
    EXPECT_EQ(next.tessellation, first.tessellation);
    EXPECT_EQ(next.computational, first.computational);
    EXPECT_NE(next.physical, first.physical);

    Snapshot other = ring_snapshot(6);
    other.version = snapshot.version;
    EXPECT_NE(maker.make(other, "monitor", 1).tessellation, first.tessellation) << "another mesh";
}

TEST(MeshPicture, FollowsTheChosenColour) {
    PictureMaker maker;
    const Snapshot snapshot = ring_snapshot(6);
    const MeshPicture coloured = maker.make(snapshot, "monitor", 1);
    ASSERT_NE(coloured.scalar, nullptr);
    EXPECT_EQ(coloured.scalar_name, "monitor");
    EXPECT_EQ(*coloured.scalar, snapshot.fields[0].values);
    EXPECT_EQ(coloured.range, range_of(snapshot.fields[0].values));
    EXPECT_EQ(maker.make(snapshot, "none", 1).scalar, nullptr);
    EXPECT_NE(maker.make(snapshot, "monitor", 1).scalar, nullptr);
}

TEST(MeshPicture, ListsTangledCells) {
    PictureMaker maker;
    EXPECT_EQ(maker.make(ring_snapshot(6), "none", 1).tangled, nullptr);
    const MeshPicture tangled = maker.make(tangled_snapshot(6), "none", 1);
    ASSERT_NE(tangled.tangled, nullptr);
    EXPECT_EQ(tangled.tangled->size(), 1U);
}

TEST(MeshPicture, BoxHoldsBothMeshes) {
    Snapshot snapshot = ring_snapshot(4);
    snapshot.x = snapshot.mesh->nodes;
    for (double& x : snapshot.x.x) x += 2;
    const Box box = PictureMaker().make(snapshot, "none", 1).box;
    EXPECT_EQ(box.low.x, 0);
    EXPECT_EQ(box.high.x, 3);
    EXPECT_TRUE(PictureMaker().make(snapshot, "none", 1).planar());
    EXPECT_FALSE(PictureMaker().make(sphere_snapshot(2), "none", 1).planar());
}

} // namespace
} // namespace gaspard
