// Whole solves on spheres, and what holds all along them.
#include "core/method/relax_sphere.hpp"
#include "support/largest_distance.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

TEST(SphereSolves, StandsStillToTheEndForAConstantMonitor) {
    // Also at the step of the shipped scenarios, which for a constant is the limit of stability: there the
    // residual does not get to 1e-8, and the nodes stay where they are all the same.
    for (const std::optional<double> step : {std::optional<double>(), std::optional<double>(2.0)}) {
        OnSurface run(sphere_setup({SphereCells::cubed, 16}), on_sphere("constant"), step);
        for (int i = 0; i < 300 && run.history.back().residual >= 1e-8; ++i) {
            run.step();
            EXPECT_LT(largest_distance(run.x(), run.surface->mesh()->nodes), 1e-5);
        }
        if (!step) {
            EXPECT_LT(run.history.back().residual, 1e-8);
        }
        EXPECT_EQ(run.quality().tangled_cells, 0u);
    }
}

/// Turned around an axis that has nothing to do with the mesh.
Vec3 turned(Vec3 p) {
    const double angle = 0.7;
    const Vec3 axis = (1 / norm(Vec3{1, 2, -0.5})) * Vec3{1, 2, -0.5};
    return std::cos(angle) * p + std::sin(angle) * cross(axis, p) +
           ((1 - std::cos(angle)) * dot(axis, p)) * axis;
}

TEST(SphereSolves, TurnsWithMeshAndMonitor) {
    for (const auto& grid : {small_cubed, small_icosahedral}) {
        const auto monitor = on_sphere("x-n", {{"ratio", 4}});
        const Vec3 centre = turned(*monitor->symmetry_axis());
        const auto other =
            on_sphere("x-n", {{"ratio", 4},
                              {"center_latitude", std::asin(centre.z) * 180 / std::numbers::pi},
                              {"center_longitude", std::atan2(centre.y, centre.x) * 180 / std::numbers::pi}});
        SurfaceSetup setup = sphere_setup(grid);
        Points& nodes = setup.mesh.quadratic.nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set(i, turned(nodes[i]));
        setup.grid.reset();
        OnSurface here(sphere_setup(grid), monitor, 2.0), there(std::move(setup), other, 2.0);
        here.solve();
        there.solve();
        EXPECT_EQ(here.iterations(), there.iterations());
        for (std::size_t i = 0; i < here.x().size(); ++i)
            EXPECT_NEAR(norm(turned(here.x()[i]) - there.x()[i]), 0, 1e-11);
    }
}

TEST(SphereSolves, IsUnharmedByMonitorsAtPolesOfTheMesh) {
    const std::vector<std::pair<std::string, Settings>> monitors = {
        {"x-n", {}},
        {"bell", {{"amplitude", 5}, {"sharpness", 3}}},
        {"ring", {{"amplitude", 3}, {"sharpness", 3}}}};
    for (const double latitude : {90.0, -90.0, 0.0})
        for (auto [type, settings] : monitors) {
            SCOPED_TRACE(type + format_number(latitude));
            settings.emplace_back("center_latitude", latitude);
            settings.emplace_back("center_longitude", 0);
            OnSurface run(sphere_setup(small_cubed), on_sphere(type, settings), std::nullopt);
            run.solve(1e-6, 500);
            EXPECT_LT(run.history.back().residual, 1e-6);
            EXPECT_EQ(run.quality().tangled_cells, 0u);
        }
}

TEST(SphereSolves, TakesStepsThatAreStableByItself) {
    for (const double ratio : {2.0, 16.0}) {
        const auto surface = std::make_shared<const SurfaceQ2>(sphere_setup({SphereCells::cubed, 8}));
        OnSurface automatic(surface, on_sphere("x-n", {{"ratio", ratio}}), std::nullopt);
        OnSurface fixed(surface, automatic.monitor, 2.0);
        automatic.solve(1e-5);
        fixed.solve(1e-5);
        EXPECT_LT(automatic.history.back().residual, 1e-5) << ratio;
        EXPECT_LE(automatic.iterations(), fixed.iterations());
        EXPECT_EQ(automatic.quality().tangled_cells, 0u);
    }
    OnSurface beyond(sphere_setup({SphereCells::cubed, 8}), on_sphere("x-n", {{"ratio", 32}}), std::nullopt);
    beyond.solve(1e-4);
    EXPECT_LT(beyond.history.back().residual, 1e-4);
    OnSurface cross(sphere_setup({SphereCells::icosahedral, 3}), on_sphere("cross"), std::nullopt);
    cross.solve(1e-5);
    EXPECT_LT(cross.history.back().residual, 1e-5);
}

TEST(SphereSolves, AcceleratesToTheSameMeshOverCoarserOnes) {
    struct Case {
        SphereGrid grid;
        std::string monitor;
        double step_size;
    };
    for (const auto& [grid, type, step] :
         {Case{{SphereCells::cubed, 16}, "x-n", 2.0}, {{SphereCells::icosahedral, 3}, "cross", 0.1}}) {
        OnSurface plain(sphere_setup(grid), on_sphere(type), step);
        OnSurface quick(plain.surface, plain.monitor, std::nullopt, "accelerated");
        plain.solve();
        std::vector<std::string> layouts;
        while (quick.history.back().residual >= 1e-8 && quick.iterations() < 300) {
            quick.step();
            if (layouts.empty() || layouts.back() != quick.state.layout)
                layouts.push_back(quick.state.layout);
            ASSERT_EQ(quick.x().size(), plain.x().size());
        }
        EXPECT_LT(1.5 * quick.iterations(), plain.iterations());
        EXPECT_LT(largest_distance(quick.x(), plain.x()), 1e-7);
        EXPECT_EQ(layouts.size(), 2u); // one coarser, then this one
        EXPECT_EQ(layouts.back(), plain.state.layout);
    }
}

TEST(SphereSolves, ConvergesUnderRefinement) {
    // Squares towards second order, the deviation from the exact map too.
    double last_spread = 0, last_deviation = 0;
    for (const int k : {6, 12, 24}) {
        OnSurface run(sphere_setup({SphereCells::cubed, k}), on_sphere("x-n"), std::nullopt, "accelerated");
        run.solve(1e-7);
        const double spread = run.quality().equidistribution, deviation = run.deviation().vertices;
        if (k > 6) {
            EXPECT_GT(last_spread / spread, 2.3) << k;
            EXPECT_GT(last_deviation / deviation, 3) << k;
        }
        last_spread = spread, last_deviation = deviation;
    }
}

} // namespace
} // namespace gaspard
