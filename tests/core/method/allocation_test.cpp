// That steps of the relaxation and of a flow ask for no memory.
#include "core/flow/quasi_geostrophic.hpp"
#include "core/linear/gmres.hpp"
#include "core/method/plane_equation.hpp"
#include "core/method/relax.hpp"
#include "core/method/relax_sphere.hpp"
#include "core/method/surface_equation.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

namespace {

thread_local std::size_t allocations = 0;

void* counted(std::size_t size) {
    ++allocations;
    void* memory = std::malloc(size > 0 ? size : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}

} // namespace

// The whole program's, which count for the thread that calls.
void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace gaspard {
namespace {

TEST(Allocation, IsSeen) {
    const std::size_t before = allocations;
    const std::vector<double> some(3);
    EXPECT_EQ(allocations, before + 1);
}

TEST(Allocation, DoesNotHappenInAStepOfTheRelaxation) {
    for (const bool periodic : {true, false})
        for (const int cells : {20, 49}) {
            Relaxing run(cells, periodic, make_monitor("ring", {}), 0.1);
            run.step(); // the first may still allocate
            std::size_t before = allocations;
            for (int i = 0; i < 5; ++i) run.method->step(problem_of(*run.monitor), run.state, {});
            EXPECT_EQ(allocations, before);
            run.method->configure(Values("method", relaxation_method().rows)); // auto
            before = allocations;
            for (int i = 0; i < 5; ++i) run.method->step(problem_of(*run.monitor), run.state, {});
            EXPECT_EQ(allocations, before);
        }
}

TEST(Allocation, DoesNotHappenInAStepOnTheSphere) {
    for (const int order : {1, 2})
        for (const auto step_size : {std::optional(2.0), std::optional<double>()}) {
            OnSurface run(sphere_setup({SphereCells::cubed, 4}, order), on_sphere("x-n"), step_size);
            run.step();
            const std::size_t before = allocations;
            for (int i = 0; i < 5; ++i) run.method->step(problem_of(*run.monitor), run.state, {});
            EXPECT_EQ(allocations, before);
        }
}

TEST(Allocation, DoesNotHappenInAStepOfAFlow) {
    QuasiGeostrophicFlow flow({.cells = 20, .background = {0.1, 0}});
    flow.set_state(continuous_state(20, noise_values(20, 1)));
    std::vector<double> nodal(400);
    const std::size_t before = allocations;
    flow.advance(2);
    flow.diagnostics();
    flow.project(nodal);
    EXPECT_EQ(allocations, before);
}

TEST(Allocation, DoesNotHappenInALinearSolve) {
    for (const bool sphere : {true, false}) {
        std::unique_ptr<NonlinearProblem> equation;
        if (sphere)
            equation = std::make_unique<SurfaceEquation>(
                std::make_shared<SurfaceQ2>(sphere_setup({.cells = SphereCells::cubed, .resolution = 4})));
        else
            equation = std::make_unique<PlaneEquation>(std::make_shared<PlaneQ2>(LineGrid{20, true}));
        const auto monitor = make_monitor("bell", {sphere ? SpaceKind::sphere : SpaceKind::periodic_square});
        std::vector<double> phi(equation->size(), 0.0), u(phi);
        const ProblemData data{monitor};
        equation->evaluate(data, phi);
        equation->linearise(data, NonlinearProblem::Linearised::fully);
        Gmres gmres(phi.size(), 10);
        std::size_t before = 0;
        for (int solves = 0; solves < 2; ++solves) { // the first may still allocate
            before = allocations;
            const auto result = gmres.solve([&](auto v, auto out) { equation->derivative(v, out); },
                                            [&](auto v, auto out) { equation->precondition(v, out); },
                                            equation->residual(), u, {1e-8, 100});
            EXPECT_TRUE(result.converged);
        }
        EXPECT_EQ(allocations, before);
    }
}

} // namespace
} // namespace gaspard
