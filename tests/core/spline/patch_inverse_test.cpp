// The parameters of points of a patch: there and back on patches of every kind.
#include "core/base/box.hpp"
#include "core/spline/nearest_point.hpp"
#include "core/spline/patch_file.hpp"
#include "core/spline/patch_inverse.hpp"
#include "core/spline/spline_domain.hpp"
#include "support/largest_distance.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace gaspard {
namespace {

std::shared_ptr<const PatchMap> from_text(const std::string& json) {
    return patch_map(parse_patch({json, "test", {}}).patch);
}

/// A circle of nine control points times points (radius, height), linear between them: annulus, tube, dome.
std::shared_ptr<const PatchMap> turned(const std::vector<std::pair<double, double>>& profile,
                                       bool mirrored = false) {
    const double corner = std::sqrt(0.5);
    const double x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    SplinePatch patch;
    KnotVector around{2, {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1}}, across{1, {0}};
    for (std::size_t k = 0; k < profile.size(); ++k)
        across.knots.push_back(static_cast<double>(k) / static_cast<double>(profile.size() - 1));
    across.knots.push_back(1);
    patch.space.directions = {around, across};
    for (const auto& [radius, height] : profile)
        for (std::size_t i = 0; i < 9; ++i) {
            patch.control.resize(patch.control.size() + 1);
            patch.control.set(patch.control.size() - 1,
                              {radius * x[i], (mirrored ? -1 : 1) * radius * y[i], height});
            patch.weights.push_back(i % 2 == 1 ? corner : 1);
        }
    return patch_map(std::move(patch));
}

Points random_parameters(std::size_t count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    Points uv(count);
    for (std::size_t i = 0; i < count; ++i) uv.set(i, {unit(random), unit(random), 0});
    for (std::size_t i = 0; i < count / 10; ++i) uv.x[i] = i % 2 == 0 ? 0 : 1; // on edges, too
    for (std::size_t i = count / 10; i < count / 5; ++i) uv.y[i] = i % 2 == 0 ? 0 : 1;
    return uv;
}

struct Shape {
    std::string name;
    std::shared_ptr<const PatchMap> map;
    double parameters; ///< how well u and v are found, away from edges at which F is singular
};
void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

const std::string cone =
    R"({"degrees":[1,1],"knots":[[0,0,1,1],[0,0,1,1]],
        "control_points":[[0,0,0],[1,0,0],[0,1,0.5],[0,1,0.5]]})";
const std::string egg =
    R"({"degrees":[2,3],"knots":[[0,0,0,1,1,1],[0,0,0,0,1,1,1,1]],
        "control_points":[[0.1,0.1,-1],[0.1,0.1,-1],[0.1,0.1,-1],  [-1,0,-0.8],[0,-1.4,-0.8],[1,0,-0.8],
                          [-1,0,0.9],[0,-1.4,0.9],[1,0,0.9],  [0.1,0.1,1.3],[0.1,0.1,1.3],[0.1,0.1,1.3]]})";
const std::string mirrored =
    R"({"degrees":[2,1],"knots":[[0,0,0,1,1,1],[0,0,1,1]],
        "control_points":[[2,0],[1,0.3],[0,0],[2,1],[1,1.4],[0,1.2]]})";

class Inverses : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(
    All, Inverses,
    testing::Values(Shape{"square", square_map(), 1e-12}, Shape{"disk", disk_map(), 1e-6},
                    Shape{"quarter_annulus", quarter_annulus_map(), 1e-12},
                    Shape{"part_of_a_torus", torus_part_map(), 1e-12}, Shape{"moebius", moebius_map(), 1e-12},
                    Shape{"cone", from_text(cone), 1e-9}, Shape{"egg", from_text(egg), 1e-9},
                    Shape{"mirrored", from_text(mirrored), 1e-12},
                    Shape{"full_annulus", turned({{0.5, 0}, {1, 0}}), 1e-12},
                    Shape{"mirrored_annulus", turned({{0.5, 0}, {1, 0}}, true), 1e-12},
                    Shape{"tube", turned({{1, 0}, {0.6, 1}, {0.8, 2}}), 1e-12},
                    Shape{"dome", turned({{1, 0}, {0, 1}}), 1e-9}),
    [](const auto& shape) { return shape.param.name; });

/// The difference of parameters, which are the same on both sides of a seam.
double apart(Vec3 a, Vec3 b, const std::array<PatchClosure, 2>& closure) {
    double least = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
    for (const int side : {-1, 1})
        for (const bool first : {true, false}) {
            const PatchClosure closed = closure[first ? 0 : 1];
            if (closed == PatchClosure::open) continue;
            Vec3 c = b;
            (first ? c.x : c.y) += side;
            double& other = first ? c.y : c.x;
            if (closed == PatchClosure::flipped) other = 1 - other;
            least = std::min(least, std::max(std::abs(a.x - c.x), std::abs(a.y - c.y)));
        }
    return least;
}

TEST_P(Inverses, FindParametersThereAndBack) {
    const auto inverse = patch_parameters(GetParam().map);
    const Points uv = random_parameters(4000);
    Points x, found, again, first, second;
    inverse->points(uv, x);
    inverse->find(x, found);
    inverse->points(found, again);
    inverse->tangents(uv, first, second);
    const double size = bounding_box(x).size();
    EXPECT_LT(largest_distance(x, again), 1e-13 * size);
    double worst = 0;
    for (std::size_t i = 0; i < uv.size(); ++i) {
        EXPECT_GE(std::min(found.x[i], found.y[i]), -1e-7);
        EXPECT_LE(std::max(found.x[i], found.y[i]), 1 + 1e-7);
        const double area = norm(cross(first[i], second[i]));
        if (area > 0.02 * size * size) worst = std::max(worst, apart(uv[i], found[i], inverse->closure()));
    }
    EXPECT_LT(worst, GetParam().parameters);
}

TEST_P(Inverses, FindTheNearestPointBesideASurface) {
    const auto inverse = patch_parameters(GetParam().map);
    if (GetParam().map->space_dimension() == 2) return;
    Points uv(200), x, first, second, found;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> inner(0.2, 0.6);
    for (std::size_t i = 0; i < uv.size(); ++i) uv.set(i, {inner(random), inner(random), 0});
    inverse->points(uv, x);
    inverse->tangents(uv, first, second);
    const double size = bounding_box(x).size();
    for (std::size_t i = 0; i < uv.size(); ++i) {
        const Vec3 normal = cross(first[i], second[i]);
        x.set(i, x[i] + (1e-3 * size / norm(normal)) * normal);
    }
    inverse->find(x, found);
    EXPECT_LT(largest_distance(uv, found), 1e-6);
}

TEST(PatchInverse, ContinuesBeyondOpenEdgesAndNotAcrossSeams) {
    const auto open = patch_parameters(quarter_annulus_map());
    Points uv(1), x, found;
    uv.set(0, {1.03, -0.02, 0});
    open->points(uv, x);
    open->find(x, found);
    EXPECT_LT(largest_distance(uv, found), 1e-12);
    EXPECT_EQ(open->closure(), (std::array{PatchClosure::open, PatchClosure::open}));
    const auto annulus = patch_parameters(turned({{0.5, 0}, {1, 0}}));
    EXPECT_EQ(annulus->closure(), (std::array{PatchClosure::periodic, PatchClosure::open}));
    for (const double angle : {1e-3, -1e-3, 1e-9, -1e-9}) {
        x.set(0, {0.7 * std::cos(angle), 0.7 * std::sin(angle), 0});
        annulus->find(x, found);
        EXPECT_GE(found.x[0], 0);
        EXPECT_LE(found.x[0], 1);
        EXPECT_NEAR(found.x[0], angle > 0 ? 0 : 1, 1e-3);
        EXPECT_NEAR(found.y[0], 0.4, 1e-12);
    }
    EXPECT_EQ(patch_parameters(moebius_map())->closure()[0] == PatchClosure::flipped ||
                  patch_parameters(moebius_map())->closure()[1] == PatchClosure::flipped,
              true);
}

TEST(PatchInverse, FindsSomeParametersAtATip) {
    const auto inverse = patch_parameters(turned({{1, 0}, {0, 1}}));
    Points x(2), found, again;
    x.set(0, {0, 0, 1});
    x.set(1, {-1e-7, 2e-7, 1 - std::hypot(1e-7, 2e-7)});
    inverse->find(x, found);
    inverse->points(found, again);
    EXPECT_LT(largest_distance(x, again), 1e-12);
    EXPECT_NEAR(found.y[0], 1, 1e-9);
    const double turn = std::atan2(2e-7, -1e-7) / (2 * std::numbers::pi);
    EXPECT_NEAR(found.x[1], turn, 0.05) << "a NURBS circle is not run through evenly";
}

TEST(PatchInverse, BelongsToTheDomain) {
    const SplineDomain domain(3, 4, torus_part_map());
    ASSERT_NE(domain.parameters(), nullptr);
    Points uv;
    domain.parameters()->find(domain.mesh()->nodes, uv);
    const auto lines = domain.node_lines();
    for (std::size_t i = 0; i < uv.size(); ++i) {
        EXPECT_NEAR(uv.x[i], lines[i % lines.size()], 1e-12);
        EXPECT_NEAR(uv.y[i], lines[i / lines.size()], 1e-12);
    }
}

TEST(NearestPoint, AgreesWithComparingAllPoints) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    Points points(700);
    for (std::size_t i = 0; i < points.size(); ++i)
        points.set(i, {unit(random), i % 3 == 0 ? 0.5 : unit(random), 0.1 * unit(random)});
    const NearestPoint nearest(points);
    for (int k = 0; k < 500; ++k) {
        const Vec3 x{2 * unit(random) - 0.5, unit(random), unit(random)};
        double least = 1e9;
        for (std::size_t i = 0; i < points.size(); ++i) least = std::min(least, norm(points[i] - x));
        EXPECT_EQ(norm(points[nearest(x)] - x), least);
    }
}

} // namespace
} // namespace gaspard
