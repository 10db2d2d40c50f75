// Picking against cells that are known, whatever the mesh, the camera and the blend.
#include "core/base/error.hpp"
#include "fixtures/fixture_meshes.hpp"
#include "gui/scene/arrows.hpp"
#include "gui/scene/picking.hpp"
#include "gui/scenes.hpp"
#include "support/messages.hpp"
#include "support/small_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace gaspard {
namespace {

constexpr Size size{800, 600};

Snapshot snapshot_of(Mesh mesh) {
    Snapshot snapshot;
    snapshot.x = mesh.nodes;
    snapshot.fields.push_back({{.name = "monitor"}, std::vector<double>(mesh.node_count(), 1.0)});
    snapshot.mesh = std::make_shared<const Mesh>(std::move(mesh));
    return snapshot;
}

MeshScene scene_of(const Snapshot& snapshot, double blend = 1) {
    return SceneBuilder().make(snapshot, view("none", blend));
}

Vec3 middle_of_cell(const Snapshot& snapshot, std::size_t cell, double blend = 1) {
    const auto corners = static_cast<std::size_t>(corners_per_cell(snapshot.mesh->kind));
    Vec3 sum;
    for (std::size_t k = 0; k < corners; ++k) {
        const auto node = static_cast<std::size_t>(snapshot.mesh->cell(cell)[k]);
        sum = sum + (1 - blend) * snapshot.mesh->nodes[node] + blend * snapshot.x[node];
    }
    return (1.0 / static_cast<double>(corners)) * sum;
}

std::string picked(const MeshScene& scene, const Camera& camera, Pixel at) {
    const auto hit = pick_at(scene, camera, size, at, 8);
    return hit ? format_pick(hit->pick) : "";
}

TEST(Picking, EveryCellIsFoundAtItsMiddleUnderAnyBlend) {
    const Snapshot snapshot = ring_snapshot(12);
    for (const double blend : {0.0, 0.4, 1.0}) {
        const MeshScene scene = scene_of(snapshot, blend);
        Camera camera = home(scene.box, size);
        pan(camera, {31, -12});
        for (std::size_t cell = 0; cell < snapshot.mesh->cell_count(); ++cell) {
            const Vec3 middle = middle_of_cell(snapshot, cell, blend);
            EXPECT_EQ(picked(scene, camera, to_pixel(camera, size, middle)), "cell " + std::to_string(cell));
        }
    }
}

TEST(Picking, EveryNodeIsFoundNearItsPlaceAndNotFarFromIt) {
    const Snapshot snapshot = ring_snapshot(12);
    const MeshScene scene = scene_of(snapshot);
    const Camera camera = home(scene.box, size);
    for (std::size_t node = 0; node < snapshot.x.size(); ++node) {
        Pixel at = to_pixel(camera, size, snapshot.x[node]);
        at.x += 2, at.y -= 1;
        EXPECT_EQ(picked(scene, camera, at), "node " + std::to_string(node));
    }
    EXPECT_EQ(picked(scene, camera, {3, 3}), "") << "beside the mesh";
}

TEST(Picking, CellsRemainPickableHoweverSmall) {
    const Snapshot snapshot = ring_snapshot(240);
    const MeshScene scene = scene_of(snapshot);
    const Camera camera = home(scene.box, size); // cells of about two pixels
    for (const std::size_t cell : {0U, 240U * 77 + 31, 57599U})
        EXPECT_EQ(picked(scene, camera, to_pixel(camera, size, middle_of_cell(snapshot, cell))),
                  "cell " + std::to_string(cell));
}

TEST(Picking, TellsWhereThePointerMeetsTheMesh) {
    const Snapshot snapshot = sphere_snapshot(4);
    const MeshScene scene = scene_of(snapshot);
    for (const char* direction : {"home", "left", "top"}) {
        const Camera camera = home(scene.box, size, {}, direction);
        const Pixel at{430, 280};
        const auto hit = pick_at(scene, camera, size, at, 0);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(norm(hit->where), 1, 5e-3) << "on the sphere";
        EXPECT_GT(dot(hit->where, towards_viewer(camera)), 0.9) << "in front";
        EXPECT_NEAR(to_pixel(camera, size, hit->where).x, at.x, 1e-6);
        EXPECT_NEAR(to_pixel(camera, size, hit->where).y, at.y, 1e-6);
    }
}

TEST(Picking, InSpaceTheFrontMostCellCounts) {
    const Snapshot snapshot = sphere_snapshot(3); // sides: +x, -x, +y, -y, +z, -z, nine cells each
    const MeshScene scene = scene_of(snapshot);
    const std::pair<const char*, int> middles[] = {{"right", 0}, {"left", 1}, {"back", 2},
                                                   {"front", 3}, {"top", 4},  {"bottom", 5}};
    for (const auto& [direction, side] : middles)
        EXPECT_EQ(picked(scene, home(scene.box, size, {}, direction), {430, 285}),
                  "cell " + std::to_string(9 * side + 4))
            << direction;
    const Snapshot cube = cube_snapshot(3);
    const Camera above = home(scene_of(cube).box, size, {}, "top");
    EXPECT_EQ(picked(scene_of(cube), above, to_pixel(above, size, middle_of_cell(cube, 22))), "cell 22");
}

TEST(Picking, OnCurvedCellsTheCurveCounts) {
    // An upper edge that bulges by a quarter: there is the cell, where a straight edge would have left
    // nothing.
    Mesh mesh = curved_square();
    Snapshot snapshot = snapshot_of(mesh);
    const MeshScene scene = scene_of(snapshot);
    const Camera camera = home(scene.box, size, {}, "top");
    const Box& box = scene.box;
    const Vec3 inside = box.centre() + 0.1 * (box.high - box.low); // where no node stands
    const auto hit = pick_at(scene, camera, size, to_pixel(camera, size, inside), 0);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->pick, (Pick{Pick::Kind::cell, 0}));
    const Snapshot ball = sphere_snapshot(1); // six cells; straight ones would make a cube
    const MeshScene round = scene_of(ball);
    const Camera front = home(round.box, size, {}, "front");
    EXPECT_NE(picked(round, front, to_pixel(front, size, {0.9, -0.1, 0.05})), "")
        << "outside of the cube's face";
    EXPECT_EQ(picked(round, front, to_pixel(front, size, {0.9, -0.1, 0.6})), "") << "outside of the sphere";
}

TEST(Picking, LinesAreHitNearby) {
    const Snapshot snapshot = interval_snapshot(10);
    const MeshScene scene = scene_of(snapshot);
    const Camera camera = home(scene.box, size);
    Pixel at = to_pixel(camera, size, middle_of_cell(snapshot, 8));
    at.y += 5;
    EXPECT_EQ(picked(scene, camera, at), "cell 8");
    at.y += 20;
    EXPECT_EQ(picked(scene, camera, at), "");
    EXPECT_EQ(picked(scene, camera, to_pixel(camera, size, snapshot.x[9])), "node 9");
}

TEST(Picking, OutlinesSurroundTheCell) {
    const Snapshot snapshot = ring_snapshot(6);
    const MeshScene scene = scene_of(snapshot);
    const Camera camera = home(scene.box, size);
    EXPECT_EQ(outline_of(scene, camera, size, 14).size(), 4U) << "without the line between its triangles";
    const auto middle = middle_of({Pick::Kind::cell, 14}, scene, camera, size);
    ASSERT_TRUE(middle);
    EXPECT_EQ(picked(scene, camera, *middle), "cell 14");
    const Snapshot ball = sphere_snapshot(2);
    EXPECT_EQ(outline_of(scene_of(ball), camera, size, 3).size(),
              4U * static_cast<std::size_t>(scene_of(ball).tessellation->cuts));
    const auto node = middle_of({Pick::Kind::node, 16}, scene, camera, size);
    ASSERT_TRUE(node);
    EXPECT_NEAR(node->x, to_pixel(camera, size, snapshot.x[16]).x, 1e-9);
    EXPECT_FALSE(middle_of({Pick::Kind::cell, 13}, scene_of(cube_snapshot(3)), camera, size)) << "inside";
}

std::string fact(const PickFacts& facts, const std::string& name) {
    for (const auto& [key, value] : facts)
        if (key == name) return value;
    return "-";
}

TEST(Picking, TheCardSaysWhatTheNumbersAre) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(4));
    snapshot.fields[0].values[6] = 5; // node (1, 1)
    snapshot.x.x[6] = 0.3;
    snapshot.fields.push_back({{.name = "mass", .place = FieldPlace::cell}, std::vector<double>(16, 1.25)});
    snapshot.fields[1].values[5] = 1.5;
    ColouringMaker cells;
    const PickFacts cell = facts_of({Pick::Kind::cell, 5}, snapshot, cells);
    EXPECT_EQ(fact(cell, ""), "cell 5  (1, 1)");
    EXPECT_EQ(fact(cell, "ξ"), "0.375, 0.375");
    EXPECT_EQ(fact(cell, "x"), "0.3875, 0.375");
    EXPECT_EQ(fact(cell, "monitor"), "2");
    EXPECT_EQ(fact(cell, "area"), "0.05625");
    EXPECT_EQ(fact(cell, "Mᵢ"), "1.5");
    EXPECT_EQ(fact(cell, "Jacobian"), "0.8");
    const PickFacts node = facts_of({Pick::Kind::node, 6}, snapshot, cells);
    EXPECT_EQ(fact(node, ""), "node 6  (1, 1)");
    EXPECT_EQ(fact(node, "x"), "0.3, 0.25");
    EXPECT_EQ(fact(node, "monitor"), "5");
    EXPECT_EQ(fact(node, "Mᵢ"), "1.25 to 1.5") << "of the cells around";
    snapshot.fields.pop_back();
    ColouringMaker unmeasured;
    EXPECT_EQ(fact(facts_of({Pick::Kind::node, 6}, snapshot, unmeasured), "Mᵢ"), "-");
    EXPECT_EQ(fact(facts_of({Pick::Kind::cell, 2}, snapshot_of(cubed_sphere_mesh(2)), unmeasured), ""),
              "cell 2");
    EXPECT_NE(fact(facts_of({Pick::Kind::cell, 2}, snapshot_of(cube_mesh(2)), unmeasured), "volume"), "-");
}

TEST(Picking, TheCardBeginsWithWhatTheColoursShow) {
    Snapshot snapshot = snapshot_of(unit_square_mesh(4));
    snapshot.x.x[6] = 0.3;
    ColouringMaker cells;
    const Pick cell{Pick::Kind::cell, 5};
    const auto displacement = make_colouring(snapshot, {.colouring = "displacement"});
    PickFacts facts = facts_of(cell, snapshot, cells, &*displacement);
    ASSERT_GT(facts.size(), 2U);
    EXPECT_EQ(facts[1].first, "displacement |x − ξ|");
    EXPECT_EQ(facts[1].second, "0.0125") << "the mean over the corners";
    const auto area = make_colouring(snapshot, {.colouring = "area"});
    facts = facts_of(cell, snapshot, cells, &*area);
    EXPECT_EQ(facts[1].second, "0.05625");
    EXPECT_EQ(fact(facts, "area"), "-") << "said once";
}

TEST(Arrows, KeepTheirDistanceAndFillThePicture) {
    for (const int n : {7, 60, 240}) {
        const MeshScene scene = scene_of(ring_snapshot(n));
        const Camera camera = home(scene.box, size);
        const auto points = points_with_arrows(scene, camera, size, 26);
        const double cell = 1 / (n * camera.scale), side = std::max(1.0, std::round(26 / cell)) * cell;
        const double across = 1 / camera.scale / side;
        EXPECT_GE(points.size(), static_cast<std::size_t>(across * across)) << n;
        EXPECT_LE(points.size(), static_cast<std::size_t>((across + 2) * (across + 2))) << n;
        if (n != 240) continue;
        std::set<std::pair<int, int>> columns; // in rows: few different places across
        for (const auto p : points) columns.insert({static_cast<int>(p % 241), 0});
        EXPECT_LE(columns.size(), static_cast<std::size_t>(across + 2));
    }
}

TEST(Arrows, AreTheSameWhileOnePansOrTheMeshMoves) {
    const Snapshot snapshot = ring_snapshot(60);
    Snapshot unmoved = snapshot;
    unmoved.x = snapshot.mesh->nodes;
    const Camera camera = home(scene_of(snapshot).box, size);
    Camera panned = camera;
    pan(panned, {37.3, -11.9});
    const auto points = points_with_arrows(scene_of(snapshot), camera, size, 26);
    EXPECT_EQ(points_with_arrows(scene_of(snapshot), panned, size, 26), points);
    EXPECT_EQ(points_with_arrows(scene_of(unmoved), camera, size, 26), points);
    Camera closer = camera;
    closer.scale /= 4;
    EXPECT_NE(points_with_arrows(scene_of(snapshot), closer, size, 26), points);
}

TEST(Arrows, StandOnNodesOfTheSurfaceOnly) {
    const Snapshot cube = cube_snapshot(4);
    const MeshScene scene = scene_of(cube);
    const auto points = points_with_arrows(scene, home(scene.box, size), size, 1);
    EXPECT_EQ(points.size(), 125U - 27) << "all but those inside";
    const MeshScene ball = scene_of(sphere_snapshot(3));
    for (const auto p : points_with_arrows(ball, home(ball.box, size), size, 1))
        EXPECT_EQ(ball.tessellation->starts[p + 1] - ball.tessellation->starts[p], 1U)
            << "no point of a curve";
}

} // namespace
} // namespace gaspard
