#include "core/base/error.hpp"
#include "core/mesh/control_points.hpp"
#include "core/spline/patch_file.hpp"
#include "support/messages.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

Points random_points(std::size_t n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(0, 1);
    Points points(n);
    for (std::size_t i = 0; i < n; ++i) points.set(i, {number(random), number(random), 0});
    return points;
}

struct Named {
    const char* name;
    std::shared_ptr<const PatchMap> map;
};
void PrintTo(const Named& named, std::ostream* out) { *out << named.name; }

class PatchMaps : public testing::TestWithParam<Named> {};
INSTANTIATE_TEST_SUITE_P(All, PatchMaps,
                         testing::Values(Named{"square", square_map()}, Named{"disk", disk_map()},
                                         Named{"annulus", quarter_annulus_map()},
                                         Named{"torus", torus_part_map()}, Named{"moebius", moebius_map()},
                                         Named{"nurbs", patch_map(nurbs_disk())}),
                         [](const auto& map) { return std::string(map.param.name); });

TEST_P(PatchMaps, TangentsMatchFiniteDifferences) {
    const PatchMap& map = *GetParam().map;
    const Points xi = random_points(200, 3);
    std::array<Points, 2> tangents;
    map.tangents(xi, tangents);
    constexpr double h = 1e-5;
    for (std::size_t i = 0; i < xi.size(); ++i) {
        Points around(4), x;
        around.set(0, xi[i] + Vec3{h, 0, 0}), around.set(1, xi[i] - Vec3{h, 0, 0});
        around.set(2, xi[i] + Vec3{0, h, 0}), around.set(3, xi[i] - Vec3{0, h, 0});
        map.points(around, x);
        EXPECT_LT(norm((1 / (2 * h)) * (x[0] - x[1]) - tangents[0][i]), 2e-8);
        EXPECT_LT(norm((1 / (2 * h)) * (x[2] - x[3]) - tangents[1][i]), 2e-8);
        EXPECT_TRUE(map.space_dimension() == 3 || x.z[0] == 0);
    }
}

TEST_P(PatchMaps, AreaElementsAreThoseOfTheTangents) {
    const PatchMap& map = *GetParam().map;
    const Points xi = random_points(200, 5);
    Points x, expected;
    std::array<Points, 2> tangents;
    std::vector<double> area(xi.size());
    map.places(xi, x, area);
    map.points(xi, expected);
    map.tangents(xi, tangents);
    EXPECT_EQ(x.x, expected.x);
    EXPECT_EQ(x.y, expected.y);
    EXPECT_EQ(x.z, expected.z);
    for (std::size_t i = 0; i < xi.size(); ++i)
        EXPECT_NEAR(area[i], norm(cross(tangents[0][i], tangents[1][i])), 1e-13 * (1 + area[i]));
}

TEST_P(PatchMaps, AreaElementsHaveTheGradientsOfTheirDifferences) {
    const PatchMap& map = *GetParam().map;
    const Points xi = random_points(200, 6);
    Points gradient, x;
    std::vector<double> area(xi.size()), again(xi.size());
    map.element_gradients(xi, area, gradient);
    map.places(xi, x, again);
    constexpr double h = 1e-5;
    for (std::size_t i = 0; i < xi.size(); ++i) {
        EXPECT_EQ(area[i], again[i]);
        Points around(4);
        around.set(0, xi[i] + Vec3{h, 0, 0}), around.set(1, xi[i] - Vec3{h, 0, 0});
        around.set(2, xi[i] + Vec3{0, h, 0}), around.set(3, xi[i] - Vec3{0, h, 0});
        std::vector<double> there(4);
        map.places(around, x, there);
        EXPECT_NEAR(gradient.x[i], (there[0] - there[1]) / (2 * h), 1e-6);
        EXPECT_NEAR(gradient.y[i], (there[2] - there[3]) / (2 * h), 1e-6);
    }
}

TEST(PatchMaps, HaveNoAreaAtTheCornersOfTheDisk) {
    Points corner(1), x, gradient;
    corner.set(0, {1, 1, 0});
    for (const auto& map : {disk_map(), patch_map(nurbs_disk())}) {
        double area = 1;
        map->places(corner, x, std::span(&area, 1));
        EXPECT_NEAR(area, 0, 1e-14);
        map->element_gradients(corner, std::span(&area, 1), gradient);
        EXPECT_TRUE(std::isfinite(gradient.x[0]) && std::isfinite(gradient.y[0]));
    }
}

TEST(PatchMaps, LieOnTheirSurfaces) {
    Points xi = random_points(200, 4), x;
    moebius_map()->points(xi, x); // the centre line is the unit circle; the ends coincide, reversed
    Points ends(4), at;
    ends.set(0, {0, 0.2, 0}), ends.set(1, {1, 0.8, 0}), ends.set(2, {0.3, 0.5, 0}),
        ends.set(3, {0.7, 0.5, 0});
    moebius_map()->points(ends, at);
    EXPECT_LT(norm(at[0] - at[1]), 1e-14);
    EXPECT_NEAR(norm(at[2]), 1, 1e-14);
    EXPECT_NEAR(norm(at[3]), 1, 1e-14);
    torus_part_map()->points(xi, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double around = std::hypot(x.x[i], x.y[i]) - 3;
        EXPECT_NEAR(std::hypot(around, x.z[i]), 1, 1e-14);
    }
    quarter_annulus_map()->points(xi, x);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(norm(x[i]), 0.5 + 0.5 * xi.x[i], 1e-14);
}

TEST(NurbsDisk, HasAnExactCircularBoundary) {
    for (const auto& map : {patch_map(nurbs_disk()), disk_map()}) {
        Points xi(400), x;
        for (std::size_t i = 0; i < 100; ++i) {
            const double t = static_cast<double>(i) / 99;
            xi.set(4 * i, {t, 0, 0}), xi.set(4 * i + 1, {t, 1, 0});
            xi.set(4 * i + 2, {0, t, 0}), xi.set(4 * i + 3, {1, t, 0});
        }
        map->points(xi, x);
        for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(norm(x[i]), 1, 1e-14);
    }
}

TEST(SplinePatches, StayTheSameWhenKnotsAreInserted) {
    const SplinePatch disk = nurbs_disk();
    TensorSpace fine = disk.space;
    fine.directions[0].knots = {0, 0, 0, 0.3, 0.3, 0.7, 1, 1, 1};
    fine.directions[1].knots = {0, 0, 0, 0.5, 1, 1, 1};
    const SplinePatch finer = insert_knots(disk, fine);
    ASSERT_EQ(finer.control.size(), 24u);
    const Points xi = random_points(300, 5);
    Points before, after;
    patch_map(disk)->points(xi, before);
    patch_map(finer)->points(xi, after);
    for (std::size_t i = 0; i < xi.size(); ++i) EXPECT_LT(norm(before[i] - after[i]), 1e-14);
}

TEST(PatchThrough, InterpolatesAtTheGrevillePoints) {
    // Polynomials of the degree in each direction are reproduced for any knots.
    const std::vector<double> breaks = {0, 0.2, 0.5, 1};
    const TensorSpace space{{open_knots(3, breaks, 1), open_knots(2, breaks, 1)}};
    const auto f = [](double u, double v) { return Vec3{u * u * u - v, v * v * u, 1 + u * v}; };
    const auto us = greville(space.directions[0]), vs = greville(space.directions[1]);
    Points x(us.size() * vs.size());
    for (std::size_t j = 0; j < vs.size(); ++j)
        for (std::size_t i = 0; i < us.size(); ++i) x.set(j * us.size() + i, f(us[i], vs[j]));
    const auto map = patch_map(patch_through(space, x));
    const Points xi = random_points(100, 5);
    Points at;
    map->points(xi, at);
    for (std::size_t i = 0; i < xi.size(); ++i) EXPECT_LT(norm(at[i] - f(xi.x[i], xi.y[i])), 1e-13);
}

TEST(ControlPoints, ReadBackAndReportErrors) {
    Points control(3);
    control.set(1, {-0.1, 1e-17, 0}), control.set(2, {1.0 / 3, 1e9, 0});
    EXPECT_EQ(parse_control_points(format_control_points(control), 3), control);
    EXPECT_EQ(parse_control_points(" 0 0,-0.1   1e-17 , 0.3333333333333333 1e9", 3), control);
    for (const char* wrong : {"", "1", "1 2 3", "1 2,", "1 x", "nan 1", "1,2", "1-2"})
        EXPECT_NE(
            message_of<InputError>([&] { parse_control_points(wrong, 1); }).find("points of two numbers"),
            std::string::npos)
            << wrong;
    EXPECT_EQ(message_of<InputError>([] { parse_control_points("1 2, 3 4", 9); }),
              "domain.control_points lists 2 points, but the patch has 9");
}

} // namespace
} // namespace gaspard
