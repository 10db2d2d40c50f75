#include "core/diagnostics/exact_map.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/mesh/sphere_mesh.hpp"
#include "support/built_in.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

constexpr double pi = std::numbers::pi;
const Space sphere{SpaceKind::sphere};

/// M at a given angle from the monitor's axis.
double profile(const Monitor& monitor, double s) {
    const Vec3 axis = *monitor.symmetry_axis(), a = cross(axis, {0.3, -0.5, 0.7});
    Points x(1);
    x.set(0, std::cos(s) * axis + (std::sin(s) / norm(a)) * a);
    double value = 0;
    monitor.values(x, {&value, 1});
    return value;
}

/// Simpson's rule with many points.
double integral(const Monitor& monitor, double from, double to) {
    constexpr int n = 4000;
    double sum = 0;
    for (int i = 0; i <= n; ++i) {
        const double s = from + (to - from) * i / n;
        sum += (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * profile(monitor, s) * std::sin(s);
    }
    return sum * (to - from) / (3 * n);
}

TEST(ExactMap, PreservesTheIntegrals) {
    for (const auto& [type, settings] :
         std::vector<std::pair<std::string, Settings>>{{"x-n", {}},
                                                       {"x-n", {{"ratio", 16}}},
                                                       {"ring", {}},
                                                       {"bell", {}},
                                                       {"constant", {{"value", 3}}}}) {
        SCOPED_TRACE(type);
        const auto monitor = make_monitor(type, sphere, settings);
        const auto map = ExactMap::of(*monitor);
        ASSERT_TRUE(map);
        EXPECT_NEAR(map->theta(), integral(*monitor, 0, pi) / 2, 1e-9 * map->theta());
        for (const double t : {1e-6, 1e-3, 0.1, 0.5, 1.0, 1.5, pi / 2, 1.6, 2.0, 3.0, pi - 1e-3}) {
            const double s = map->angle(t);
            EXPECT_NEAR(integral(*monitor, 0, s), map->theta() * (1 - std::cos(t)), 1e-9 * map->theta()) << t;
        }
        EXPECT_NEAR(map->angle(0), 0, 1e-12);
        EXPECT_NEAR(map->angle(pi), pi, 1e-7);
    }
}

TEST(ExactMap, IsTheIdentityForAConstant) {
    const auto map = ExactMap::of(*make_monitor("constant", sphere));
    for (int i = 0; i <= 1000; ++i) EXPECT_NEAR(map->angle(pi * i / 1000), pi * i / 1000, 1e-10);
}

TEST(ExactMap, HasThePapersThetaWithGammaInsideTheRoot) {
    EXPECT_NEAR(ExactMap::of(*make_monitor("x-n", sphere))->theta(), 0.313702927, 1e-9);
    EXPECT_NEAR(ExactMap::of(*make_monitor("x-n", sphere, {{"ratio", 16}}))->theta(), 0.106615517, 1e-9);
}

TEST(ExactMap, MovesPointsTowardsTheAxisAlongGreatCircles) {
    const auto monitor = make_monitor("x-n", sphere, {{"ratio", 4}});
    const Vec3 axis = *monitor->symmetry_axis();
    const Mesh mesh = sphere_mesh({SphereCells::cubed, 6}).quadratic;
    Points xi = mesh.nodes;
    xi.set(0, axis);
    xi.set(1, -1.0 * axis);
    const Points x = ExactMap::of(*monitor)->apply(xi);
    EXPECT_NEAR(norm(x[0] - xi[0]), 0, 1e-15);
    EXPECT_NEAR(norm(x[1] - xi[1]), 0, 1e-15);
    for (std::size_t i = 2; i < xi.size(); ++i) {
        EXPECT_NEAR(norm(x[i]), 1, 1e-14);
        EXPECT_NEAR(dot(cross(axis, xi[i]), x[i]), 0, 1e-14);
        if (norm(cross(axis, xi[i])) < 1e-9) continue; // a node of the mesh on the axis
        EXPECT_LT(angle_between(x[i], axis), angle_between(xi[i], axis));
    }
    EXPECT_FALSE(ExactMap::of(*make_monitor("cross", sphere)));
}

TEST(ExactMap, EquidistributesTheMeasuredMass) {
    const auto monitor = make_monitor("x-n", sphere);
    const auto mesh = std::make_shared<const Mesh>(sphere_mesh({SphereCells::cubed, 16}).quadratic);
    QualityMeter meter(mesh, 1, 6, sphere);
    const MeshQuality quality = meter.measure(ExactMap::of(*monitor)->apply(mesh->nodes), *monitor);
    EXPECT_LT(quality.equidistribution, 1e-3);
    EXPECT_EQ(quality.tangled_cells, 0u);
}

TEST(ExactDeviation, MeasuresAlongTheSphere) {
    const auto surface = sphere_mesh({SphereCells::cubed, 2});
    const double radius = 10;
    Points exact = surface.quadratic.nodes, x = exact;
    for (std::size_t i = 0; i < x.size(); ++i) {
        exact.set(i, radius * exact[i]);
        const bool vertex = i < surface.vertex_count;
        const Vec3 p = surface.quadratic.nodes[i], across = cross(p, Vec3{0.3, 0.4, 0.5});
        const double turn = vertex ? 0.2 : 0.1;
        x.set(i, radius * (std::cos(turn) * p + (std::sin(turn) / norm(across)) * across));
    }
    const auto [vertices, nodes] = exact_deviation(surface.quadratic, x, exact);
    EXPECT_NEAR(vertices, 2, 1e-12);
    const double part = static_cast<double>(surface.vertex_count) / static_cast<double>(x.size());
    EXPECT_NEAR(nodes, std::sqrt(4 * part + (1 - part)), 1e-12);
}

} // namespace
} // namespace gaspard
