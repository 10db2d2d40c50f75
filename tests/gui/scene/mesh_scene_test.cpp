#include "core/scenario/view_rows.hpp"
#include "gui/scene/mesh_scene.hpp"
#include "gui/scenes.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

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

TEST(MeshScene, HasContoursOnBothMeshesAtTheSameValues) {
    SceneBuilder maker;
    const Snapshot snapshot = corner_layer_snapshot(12, 0.05);
    Values values("view", view_rows(std::vector<FieldInfo>{{.name = "solution"}}, "solution"));
    EXPECT_EQ(maker.make(snapshot, values).contours, nullptr);
    values.set("contours", std::int64_t{10});
    const MeshScene scene = maker.make(snapshot, values);
    ASSERT_NE(scene.contours, nullptr);
    const MeshContours& contours = *scene.contours;
    ASSERT_EQ(contours.computational.size(), contours.values.size());
    ASSERT_EQ(contours.physical.size(), contours.values.size());
    const std::set<double> levels(contours.values.begin(), contours.values.end());
    EXPECT_EQ(std::vector<double>(levels.begin(), levels.end()), scene.colouring->contours.values);
    EXPECT_EQ(scene.colouring->contours.text, "every 0.1");
    for (std::size_t i = 0; i < contours.values.size(); ++i) { // at the same place of the same edge
        const Vec3 xi = contours.computational[i], x = contours.physical[i];
        const double start = 1 - 6 * 0.05;
        const auto moved = [start](double t) {
            return t < 0.5 ? 2 * t * start : start + (2 * t - 1) * (1 - start);
        };
        EXPECT_NEAR(x.x, moved(xi.x), 1e-12);
        EXPECT_NEAR(x.y, moved(xi.y), 1e-12);
    }
    EXPECT_EQ(maker.make(snapshot, values).contours, scene.contours) << "not made again";
    values.set("color", std::string("area"));
    EXPECT_EQ(maker.make(snapshot, values).contours, nullptr) << "cells have one value each";
}

TEST(MeshScene, APlaneMeshWithHeightsIsASurface) {
    SceneBuilder maker;
    const Snapshot snapshot = corner_layer_snapshot(12, 0.05);
    Values values("view", view_rows(std::vector<FieldInfo>{{.name = "solution"}}, "solution"));
    const MeshScene flat = maker.make(snapshot, values);
    values.set("elevation", 1.5);
    values.set("contours", std::int64_t{5});
    const MeshScene high = maker.make(snapshot, values);
    EXPECT_FALSE(high.planar());
    EXPECT_EQ(high.elevation, 1.5);
    const auto& solution = snapshot.fields[1].values;
    const double most = *std::max_element(solution.begin(), solution.end());
    for (std::size_t i = 0; i < solution.size(); ++i) {
        EXPECT_NEAR(high.physical->z[i], 0.75 * solution[i] / most, 1e-12);
        EXPECT_EQ(high.computational->z[i], high.physical->z[i]);
        EXPECT_EQ(high.physical->x[i], snapshot.x.x[i]);
    }
    EXPECT_NEAR(high.box.high.z, 0.75, 1e-12);
    for (std::size_t i = 0; i < high.contours->values.size(); ++i)
        EXPECT_NEAR(high.contours->physical.z[i], 0.75 * high.contours->values[i] / most, 1e-12);
    values.set("range", std::string("fixed"));
    values.set("high", 0.2);
    EXPECT_NEAR(maker.make(snapshot, values).box.high.z, 0.75, 1e-12) << "cut off where the colours end";
    values.set("color", std::string("area"));
    EXPECT_TRUE(maker.make(snapshot, values).planar()) << "cells have no heights at the nodes";
    values.set("color", std::string("solution"));
    values.set("elevation", 0.0);
    EXPECT_EQ(maker.make(snapshot, values).physical, flat.physical) << "the flat arrays are kept";
    EXPECT_TRUE(maker.make(snapshot, values).planar());
    Values of_sphere = view("monitor");
    of_sphere.set("elevation", 1.0);
    EXPECT_EQ(SceneBuilder().make(sphere_snapshot(2), of_sphere).elevation, 0);
}

} // namespace
} // namespace gaspard
