// The parts of an iteration on the icosahedral sphere (20 4^r triangles) with the crossing bands, on one
// thread. "cell" is the time per cell.
#include "core/diagnostics/quality.hpp"
#include "core/fem/surface_q2.hpp"
#include "core/method/surface_equation.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace gaspard;

/// A partly adapted cross mesh with all arrays that the parts need.
struct Scene {
    explicit Scene(std::int64_t refinements)
        : sphere(std::make_shared<SurfaceQ2>(
              sphere_setup({SphereCells::icosahedral, static_cast<int>(refinements)}))),
          workspace(sphere->make_workspace()), phi(sphere->unknowns(), 0.0), r(phi), u(phi),
          m(sphere->mesh()->node_count()) {
        for (const auto& type : monitor_types())
            if (type.name == "cross") {
                const Space space{SpaceKind::sphere};
                monitor = type.make(Values("monitor", type.rows(space)), {space});
            }
        for (int i = 0; i < 5; ++i) {
            evaluate();
            sphere->poisson(r, u, workspace);
            for (std::size_t k = 0; k < phi.size(); ++k) phi[k] += 0.1 * u[k];
        }
        evaluate();
    }
    void evaluate() {
        sphere->map(phi, workspace);
        sphere->positions(workspace, x, gradient);
        monitor->values(x, m);
        sphere->residual(m, r, workspace);
    }
    double cells() const { return static_cast<double>(sphere->mesh()->cell_count()); }

    std::shared_ptr<const SurfaceQ2> sphere;
    SurfaceQ2::Workspace workspace;
    std::vector<double> phi, r, u, m;
    Points x, gradient;
    std::shared_ptr<const Monitor> monitor;
};

void count(benchmark::State& state, double cells) {
    state.counters["cell"] = benchmark::Counter(cells * static_cast<double>(state.iterations()),
                                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Dissection and both factorisations; counts the factor entries per unknown.
void setup(benchmark::State& state) {
    const SurfaceSetup what = sphere_setup({SphereCells::icosahedral, static_cast<int>(state.range(0))});
    for (auto _ : state) {
        const SurfaceQ2 sphere(what);
        state.counters["entries"] =
            static_cast<double>(sphere.factor_entries()) / static_cast<double>(sphere.unknowns());
        state.counters["MB"] = 8e-6 * static_cast<double>(sphere.factor_entries());
    }
    count(state, static_cast<double>(what.mesh.quadratic.cell_count()));
}

/// One solve with one right-hand side.
void solve(benchmark::State& state) {
    Scene s(state.range(0));
    for (auto _ : state) s.sphere->poisson(s.r, s.u, s.workspace);
    count(state, s.cells());
}

/// Twelve loads and solves with the mass matrix: sigma and the gradient.
void map(benchmark::State& state) {
    Scene s(state.range(0));
    for (auto _ : state) s.sphere->map(s.phi, s.workspace);
    count(state, s.cells());
}

void positions(benchmark::State& state) {
    Scene s(state.range(0));
    for (auto _ : state) s.sphere->positions(s.workspace, s.x, s.gradient);
    count(state, s.cells());
}

void monitor(benchmark::State& state) {
    Scene s(state.range(0));
    for (auto _ : state) s.monitor->values(s.x, s.m);
    count(state, s.cells());
}

void residual(benchmark::State& state) {
    Scene s(state.range(0));
    for (auto _ : state) s.sphere->residual(s.m, s.r, s.workspace);
    count(state, s.cells());
}

void diagnostics(benchmark::State& state) {
    Scene s(state.range(0));
    QualityMeter meter(s.sphere->mesh(), 1, 6, {SpaceKind::sphere});
    for (auto _ : state) benchmark::DoNotOptimize(meter.measure(s.x, *s.monitor).equidistribution);
    count(state, s.cells());
}

/// One iteration of the relaxation with a fixed step.
void step(benchmark::State& state) {
    Scene s(state.range(0));
    const MethodType type = relaxation_method();
    Values values = default_values(type);
    values.set("step_size", 0.1);
    const auto method = type.make(
        {.discretisation = s.sphere, .problem = [&] { return std::make_unique<SurfaceEquation>(s.sphere); }},
        values);
    State phi = method->initial_state();
    method->evaluate(ProblemData{s.monitor}, phi, {});
    for (auto _ : state) method->step(ProblemData{s.monitor}, phi, {});
    count(state, s.cells());
}

void sizes(benchmark::internal::Benchmark* one) {
    one->ArgName("refinements")->Unit(benchmark::kMillisecond)->DenseRange(3, 6);
}
BENCHMARK(setup)->Apply(sizes);
BENCHMARK(solve)->Apply(sizes);
BENCHMARK(map)->Apply(sizes);
BENCHMARK(positions)->Apply(sizes);
BENCHMARK(monitor)->Apply(sizes);
BENCHMARK(residual)->Apply(sizes);
BENCHMARK(diagnostics)->Apply(sizes);
BENCHMARK(step)->Apply(sizes);

} // namespace
