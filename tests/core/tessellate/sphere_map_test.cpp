#include "core/tessellate/sphere_map.hpp"
#include "fixtures/fixture_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace gaspard {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 unit(Vec3 p) { return (1 / norm(p)) * p; }

Vec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return unit({normal(random), normal(random), normal(random)});
}

/// Twice a triangle's area, positive if it turns to the left.
double turn(const Points& p, const Tessellation& t, std::size_t i) {
    const Vec3 a = p[t.triangles[3 * i]], b = p[t.triangles[3 * i + 1]], c = p[t.triangles[3 * i + 2]];
    return cross(b - a, c - a).z;
}

TEST(SphereMap, InvertsToTheSamePoint) {
    std::mt19937 random(7);
    for (const MapProjection& map :
         {MapProjection{1, 0}, MapProjection{6371e3, 2.5}, MapProjection{1e-3, -3}})
        for (int i = 0; i < 1000; ++i) {
            const Vec3 p = map.radius * random_direction(random);
            const auto back = from_map(map, to_map(map, p));
            ASSERT_TRUE(back);
            EXPECT_NEAR(norm(*back - p), 0, 1e-7 * map.radius);
        }
}

TEST(SphereMap, IsTheHammerProjection) {
    const MapProjection map{2, pi / 6};
    const auto at = [](double longitude, double latitude) {
        return Vec3{std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                    std::sin(latitude)};
    };
    EXPECT_NEAR(norm(to_map(map, at(pi / 6, 0))), 0, 1e-15) << "its middle";
    const Vec3 north = to_map(map, {0, 0, 5});
    EXPECT_NEAR(north.x, 0, 1e-15);
    EXPECT_NEAR(north.y, 2 * std::numbers::sqrt2, 1e-15);
    const double l = 1.1, p = -0.7, w = std::sqrt(1 + std::cos(p) * std::cos(l / 2));
    const Vec3 place = to_map(map, at(pi / 6 + l, p));
    EXPECT_NEAR(place.x, 2 * 2 * std::numbers::sqrt2 * std::cos(p) * std::sin(l / 2) / w, 1e-14);
    EXPECT_NEAR(place.y, 2 * std::numbers::sqrt2 * std::sin(p) / w, 1e-14);
    EXPECT_FALSE(from_map(map, {5.7, 0.1, 0})) << "beside the map";
    for (const Vec3 edge : map_outline(map)) EXPECT_NEAR(edge.x * edge.x / 8 + edge.y * edge.y / 2, 4, 1e-12);
}

class MapOf : public testing::TestWithParam<double> {
  protected:
    const MapProjection projection_{1, GetParam() * pi / 180};
};

TEST_P(MapOf, CoversItsEllipseExactlyOnce) {
    for (const int order : {1, 2}) {
        const Mesh curved = cubed_sphere_mesh(10);
        const Mesh mesh = order == 2 ? curved : without_middles(curved);
        const auto globe = std::make_shared<const Tessellation>(tessellate(mesh, 4));
        const Points points = shown_points(*globe, mesh.nodes);
        const SphereMap map = map_sphere(globe, points, projection_);
        const Tessellation& shape = *map.tessellation;
        ASSERT_EQ(shape.triangles.size(), 3 * shape.triangle_cells.size());
        ASSERT_EQ(shape.point_count, map.points.size());
        double area = 0, back = 0;
        for (std::size_t i = 0; i < shape.triangle_cells.size(); ++i) {
            const double twice = turn(map.points, shape, i);
            (twice > 0 ? area : back) += std::abs(twice) / 2;
        }
        // A triangle across the whole map would be reversed, or overlap others.
        EXPECT_LT(back, 1e-3) << "order " << order;
        EXPECT_NEAR(area, 4 * pi, order == 2 ? 0.01 : 0.1) << "order " << order;
        double longest = 0;
        for (std::size_t i = 0; i < shape.segments.size(); i += 2)
            longest =
                std::max(longest, norm(map.points[shape.segments[i + 1]] - map.points[shape.segments[i]]));
        EXPECT_LT(longest, order == 2 ? 0.25 : 0.8);
        for (std::size_t i = 0; i < map.points.size(); ++i)
            ASSERT_LE(map.points.x[i] * map.points.x[i] / 8 + map.points.y[i] * map.points.y[i] / 2,
                      1 + 1e-12);
    }
}

TEST_P(MapOf, CellsOnTheCutAppearOnBothSidesWithTheirArea) {
    const Mesh mesh = cubed_sphere_mesh(6);
    const auto globe = std::make_shared<const Tessellation>(tessellate(mesh, 8));
    const SphereMap map = map_sphere(globe, shown_points(*globe, mesh.nodes), projection_);
    std::vector<double> west(mesh.cell_count(), 0), east = west;
    const Tessellation& shape = *map.tessellation;
    for (std::size_t i = 0; i < shape.triangle_cells.size(); ++i) {
        const double x = map.points[shape.triangles[3 * i]].x + map.points[shape.triangles[3 * i + 1]].x +
                         map.points[shape.triangles[3 * i + 2]].x;
        (x < 0 ? west : east)[shape.triangle_cells[i]] += turn(map.points, shape, i) / 2;
    }
    // The same on the globe, without cuts.
    const Points on_globe = shown_points(*globe, mesh.nodes);
    std::vector<double> whole(mesh.cell_count(), 0);
    for (std::size_t i = 0; i < globe->triangle_cells.size(); ++i) {
        const Vec3 a = on_globe[globe->triangles[3 * i]], b = on_globe[globe->triangles[3 * i + 1]],
                   c = on_globe[globe->triangles[3 * i + 2]];
        whole[globe->triangle_cells[i]] += norm(cross(b - a, c - a)) / 2;
    }
    const Vec3 cut{-std::cos(projection_.longitude), -std::sin(projection_.longitude), 0};
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        EXPECT_NEAR(west[c] + east[c], whole[c], 0.02 * whole[c]) << c;
        const Vec3 middle = mesh.nodes[static_cast<std::size_t>(mesh.cell(c)[8])];
        const bool far_from_cut = dot(middle, cut) > 0 && std::abs(cross(cut, middle).z) > 0.3;
        if (far_from_cut) {
            EXPECT_EQ(std::min(west[c], east[c]), 0) << c;
        }
    }
}

TEST_P(MapOf, ReusesTheTessellationOfAnUnchangedCut) {
    const Mesh mesh = cubed_sphere_mesh(5);
    const auto globe = std::make_shared<const Tessellation>(tessellate(mesh, 3));
    const Points points = shown_points(*globe, mesh.nodes);
    const SphereMap first = map_sphere(globe, points, projection_);
    EXPECT_EQ(map_sphere(globe, points, projection_, &first).tessellation, first.tessellation);
    for (const double turned : {1e-3, 0.3}) {
        const MapProjection other{1, projection_.longitude + turned};
        const SphereMap anew = map_sphere(globe, points, other),
                        after = map_sphere(globe, points, other, &first);
        EXPECT_EQ(after.tessellation->triangles, anew.tessellation->triangles);
        EXPECT_EQ(after.tessellation->triangle_cells, anew.tessellation->triangle_cells);
        EXPECT_EQ(after.tessellation->segments, anew.tessellation->segments);
        EXPECT_EQ(after.tessellation->segment_sides, anew.tessellation->segment_sides);
        EXPECT_EQ(after.points.x, anew.points.x);
    }
}

TEST_P(MapOf, PointsOnTheCutLieBetweenTheirParents) {
    const Mesh mesh = cubed_sphere_mesh(5);
    const auto globe = std::make_shared<const Tessellation>(tessellate(mesh, 3));
    const Points points = shown_points(*globe, mesh.nodes);
    const SphereMap map = map_sphere(globe, points, projection_);
    EXPECT_FALSE(map.cuts.empty());
    const std::vector<double> x = map_values(map, points.x), y = map_values(map, points.y),
                              z = map_values(map, points.z);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto there = from_map(projection_, map.points[i]);
        ASSERT_TRUE(there || norm(map.points[i]) > 1.4) << "rounding at the outline";
        if (!there) continue;
        EXPECT_NEAR(norm(unit({x[i], y[i], z[i]}) - *there), 0, 0.003) << i;
    }
    for (std::uint32_t p = 0; p < map.points.size(); ++p)
        EXPECT_EQ(map.tessellation->node_of(p), p < globe->point_count ? globe->node_of(p) : std::nullopt);
}

// Meridians through nodes and along edges of the mesh, and others.
INSTANTIATE_TEST_SUITE_P(Longitudes, MapOf, testing::Values(0.0, 45.0, 90.0, 180.0, -180.0, 17.3, -121.0));

TEST(SphereMap, HandlesRandomNodes) {
    std::mt19937 random(11);
    const Mesh mesh = cubed_sphere_mesh(4);
    const auto globe = std::make_shared<const Tessellation>(tessellate(mesh, 2));
    for (int i = 0; i < 50; ++i) {
        Points x = mesh.nodes; // strongly tangled
        for (std::size_t k = 0; k < x.size(); ++k) x.set(k, random_direction(random));
        x.set(3, {0, 0, 1}), x.set(4, {0, 0, -1}), x.set(5, {-1, 0, 0});
        if (i % 5 == 0) x.y[7] = std::nan("");
        const SphereMap map = map_sphere(globe, shown_points(*globe, x), {1, 0.1 * i});
        for (const std::uint32_t p : map.tessellation->triangles) ASSERT_LT(p, map.points.size());
        for (const std::uint32_t p : map.tessellation->segments) ASSERT_LT(p, map.points.size());
        ASSERT_EQ(map.tessellation->segments.size(), map.tessellation->segment_sides.size());
        EXPECT_EQ(map_values(map, std::vector<double>(globe->point_count, 1.0)).size(), map.points.size());
    }
}

} // namespace
} // namespace gaspard
