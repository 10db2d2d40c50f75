#include "core/base/error.hpp"
#include "core/method/monge_ampere.hpp"
#include "core/method/relax_sphere.hpp"
#include "support/largest_distance.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

TEST(Sphere, StandsStillForAConstantMonitor) {
    for (const auto& grid : {small_cubed, small_icosahedral})
        for (const int order : {1, 2})
            for (const std::string method : {"relaxation", "accelerated"}) {
                // The computed facets are not quite the sphere: det A is 1 only to their order, and where it
                // differs nodes creep, by much less than that.
                OnSurface run(sphere_setup(grid, order), on_sphere("constant", {{"value", 3}}), 0.3, method);
                const double first = run.history.front().residual;
                EXPECT_LT(first, order == 2 ? 2e-3 : 0.1);
                for (int i = 0; i < 20; ++i) run.step();
                EXPECT_LT(largest_distance(run.x(), run.surface->mesh()->nodes), order == 2 ? 1e-4 : 1e-2);
            }
}

TEST(Sphere, StopsWhileCoarserMeshesAreMade) {
    const auto surface = std::make_shared<SurfaceQ2>(sphere_setup({SphereCells::cubed, 32}));
    const MethodType type = accelerated_method();
    std::stop_source stop;
    const auto progress = [&](double, std::string_view) { stop.request_stop(); };
    const MethodContext context{.discretisation = surface,
                                .problem = [&] { return std::make_unique<SurfaceEquation>(surface); },
                                .progress = progress,
                                .stop = stop.get_token()};
    EXPECT_THROW(type.make(context, default_values(type)), Interrupted);
}

TEST(Sphere, KeepsNodesOnItAndItsArea) {
    for (const double radius : {1.0, 6371e3})
        for (const auto& grid : {small_cubed, small_icosahedral}) {
            OnSurface run(sphere_setup(grid, 2, radius), on_sphere("x-n"), 2.0);
            run.solve();
            EXPECT_LT(run.history.back().residual, 1e-8);
            for (std::size_t i = 0; i < run.x().size(); ++i) EXPECT_NEAR(norm(run.x()[i]) / radius, 1, 1e-14);
            // The area of the moved cells, by the elements' own rule.
            SurfaceSetup moved = sphere_setup(grid);
            for (std::size_t i = 0; i < run.x().size(); ++i)
                moved.mesh.quadratic.nodes.set(i, (1 / radius) * run.x()[i]);
            EXPECT_NEAR(SurfaceQ2(std::move(moved)).area() / (4 * std::numbers::pi), 1, 2e-3);
            EXPECT_EQ(run.quality().tangled_cells, 0u);
        }
}

TEST(Sphere, DoesNotDependOnItsRadius) {
    OnSurface unit(sphere_setup(small_cubed), on_sphere("x-n"), 2.0);
    OnSurface earth(sphere_setup(small_cubed, 2, 6371e3), on_sphere("x-n"), 2.0);
    unit.solve();
    earth.solve();
    EXPECT_EQ(unit.iterations(), earth.iterations());
    EXPECT_NEAR(unit.quality().equidistribution, earth.quality().equidistribution, 1e-12);
    EXPECT_NEAR(earth.deviation().vertices / 6371e3, unit.deviation().vertices, 1e-12);
    for (std::size_t i = 0; i < unit.x().size(); ++i)
        EXPECT_NEAR(norm(unit.x()[i] - (1 / 6371e3) * earth.x()[i]), 0, 1e-12);
}

// So coarse and flat that the map of no displacement is not convex anywhere: there is nothing to find, but
// every step comes to an end, and goes downhill.
TEST(Sphere, TakesStepsThatComeToAnEndWhereNothingIsConvex) {
    EXPECT_GT(stable_step({.convexity = -1, .slowest = -3, .fastest = -1}), 0);
    EXPECT_LE(stable_step({.convexity = 0, .slowest = 0, .fastest = 1e-300}), longest_step);
    EXPECT_EQ(stable_step({.convexity = 1, .slowest = 1, .fastest = 3}), 0.98 * 2 / 4);
    for (const SphereGrid grid : {SphereGrid{SphereCells::cubed, 2}, SphereGrid{SphereCells::icosahedral, 0},
                                  SphereGrid{SphereCells::icosahedral, 1}})
        for (const char* name : {"relaxation", "accelerated"}) {
            OnSurface run(sphere_setup(grid, 1), on_sphere("constant"), std::nullopt, name);
            run.solve(1e-8, 20);
            for (std::size_t i = 1; i < run.history.size(); ++i)
                EXPECT_GT(run.history[i].step_size, 0) << name;
        }
}

TEST(Sphere, AdoptsMapsOfOtherSpheres) {
    OnSurface coarse(sphere_setup({SphereCells::cubed, 8}), on_sphere("x-n"), 2.0);
    coarse.solve();
    for (const SphereGrid& grid : {SphereGrid{SphereCells::cubed, 16},
                                   {SphereCells::cubed, 10, MidNodes::equiangular},
                                   {SphereCells::cubed, 5},
                                   {SphereCells::icosahedral, 3}}) {
        OnSurface other(sphere_setup(grid), coarse.monitor, std::nullopt);
        const auto adopted = other.method->adopt(coarse.state, nullptr);
        ASSERT_TRUE(adopted);
        EXPECT_EQ(adopted->layout, other.state.layout);
        EXPECT_EQ(adopted, other.method->adopt(coarse.state, coarse.surface.get())) << "operators at hand";
        EXPECT_EQ(adopted, other.method->adopt(coarse.state, other.surface.get())) << "of another mesh";
        EXPECT_LT(other.method->evaluate(problem_of(*other.monitor), *adopted, {}).residual, 0.05);
        EXPECT_LT(other.deviation().vertices, 8e-3);
        EXPECT_EQ(other.quality().tangled_cells, 0u);
    }
    // Operators of as many unknowns, but of another mesh, are not taken for those of the state.
    const SurfaceQ2 alike(sphere_setup({SphereCells::cubed, 8, MidNodes::equiangular}));
    OnSurface finer(sphere_setup({SphereCells::cubed, 16}), coarse.monitor, std::nullopt);
    EXPECT_EQ(finer.method->adopt(coarse.state, &alike), finer.method->adopt(coarse.state, nullptr));
    OnSurface same(sphere_setup({SphereCells::cubed, 8}), coarse.monitor, 2.0);
    EXPECT_EQ(same.method->adopt(coarse.state, nullptr), coarse.state);
    EXPECT_FALSE(
        same.method->adopt({"plane periodic Q2 n=60", {{"phi", std::vector<double>(14400)}}}, nullptr));
    EXPECT_FALSE(same.method->adopt({coarse.state.layout, {{"phi", {1, 2}}}}, nullptr));
}

} // namespace
} // namespace gaspard
