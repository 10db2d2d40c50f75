// Converged meshes of Hill, Madden (2021) on 64 x 64 quadrilaterals, with densities at corners.
#include "core/layer/square_mesh_pde.hpp"
#include "core/published/hill_problems.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <gtest/gtest.h>

namespace gaspard {
namespace {

/// Algorithm 3, then newton(); the steps it takes.
int converge(const HillSquare& problem, double eps) {
    constexpr int cells = 64;
    const SquareMeshPdeOptions& o = problem.options;
    SquareMeshPde pde(o.form, DensitySamples::corners, o.corners, coarsest_cells(cells, o.start_cells));
    while (pde.cells() < cells) {
        for (int i = 0; i < o.inner; ++i) pde.solve(problem.densities);
        pde.refine();
    }
    for (int i = 0; i < o.final; ++i) pde.solve(problem.densities);
    const SquareConvergence result = converge_square(pde, problem.densities);
    EXPECT_TRUE(result.converged) << eps;
    EXPECT_EQ(inverted_triangles(pde.nodes(), cells), 0U) << eps;
    EXPECT_LT(pde.solve(problem.densities).update, 1e-8) << eps;
    return result.steps;
}

TEST(HillConverged, InColumnsOfTheIrregularDomain) {
    for (const double eps : {1e-2, 1e-4, 1e-6, 1e-8})
        EXPECT_LT(converge(hill_irregular(eps), eps), 250) << eps;
}

// From the converged mesh of half as many cells; from five solves it takes more than a minute for 1e-6.
TEST(HillConverged, InColumnsOnFineMeshes) {
    for (const double eps : {1e-6, 1e-8}) {
        const HillSquare problem = hill_irregular(eps);
        SquareMeshPde pde(problem.options.form, DensitySamples::corners, problem.options.corners, 4);
        for (int i = 0; i < problem.options.inner; ++i) pde.solve(problem.densities);
        for (; pde.cells() < 128; pde.refine())
            ASSERT_TRUE(converge_square(pde, problem.densities).converged);
        const SquareConvergence result = converge_square(pde, problem.densities);
        EXPECT_TRUE(result.converged) << eps;
        EXPECT_LT(result.steps, 200) << eps;
        EXPECT_LT(pde.solve(problem.densities).update, 1e-8) << eps;
    }
}

TEST(HillConverged, InColumnsOfARunOnAFineMesh) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "layer-quadrilateral");
    apply_settings(*catalogue, scenario,
                   {"domain.cells=128", "pde.eps=1e-6", "method.samples=corners", "method.finish=converged"});
    gaspard::Run run(catalogue, scenario);
    EXPECT_EQ(run.solve().status, RunStatus::converged);
    EXPECT_LT(run.history().back().iteration, 200);
    EXPECT_LT(run.history().back().residual, 1e-8);
}

TEST(HillConverged, InBothDirectionsForVaryingDiffusion) {
    for (const double eps : {1e-2, 1e-4, 1e-6, 1e-8})
        EXPECT_LT(converge(hill_varying(eps, Diffusion::squared), eps), 60) << eps;
}

} // namespace
} // namespace gaspard
