// The parts of an iteration on the plane with the ring monitor, on one thread. "bytes" counts every array
// that a part must read or write once, "flops" the minimum arithmetic of its formula. Both are rates;
// machine.cpp measures their limits.
#include "core/diagnostics/quality.hpp"
#include "core/method/plane_equation.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <benchmark/benchmark.h>
#include <cmath>

namespace {

using namespace gaspard;

/// A partly adapted ring mesh with all arrays that the parts need.
struct Scene {
    explicit Scene(std::int64_t cells)
        : plane(std::make_shared<PlaneQ2>(LineGrid{static_cast<std::size_t>(cells), true})),
          workspace(plane->make_workspace()), phi(plane->unknowns(), 0.0), r(phi), u(phi),
          m(plane->mesh()->node_count()) {
        for (const auto& type : monitor_types())
            if (type.name == "ring")
                monitor = type.make(Values("monitor", type.rows({})), {Space{SpaceKind::periodic_square}});
        for (int i = 0; i < 6; ++i) {
            evaluate();
            plane->poisson(r, u, workspace);
            for (std::size_t k = 0; k < phi.size(); ++k) phi[k] += 0.1 * u[k];
        }
        evaluate();
    }
    void evaluate() {
        plane->positions(phi, x, workspace);
        monitor->values(x, m);
        plane->hessian(phi, sigma, workspace);
        plane->residual(m, sigma, r, workspace);
    }

    std::shared_ptr<const PlaneQ2> plane;
    PlaneQ2::Workspace workspace;
    std::vector<double> phi, r, u, m;
    Points x;
    WeakHessian sigma;
    std::shared_ptr<const Monitor> monitor;
};

/// Rates from the bytes and operations of one call, given per unknown (four per cell).
void count(benchmark::State& state, double bytes, double flops) {
    const auto unknowns = 4.0 * static_cast<double>(state.range(0) * state.range(0));
    const auto rate = [&](double one) {
        return benchmark::Counter(one * unknowns * static_cast<double>(state.iterations()),
                                  benchmark::Counter::kIsRate);
    };
    state.counters["bytes"] = rate(bytes);
    state.counters["flops"] = rate(flops);
    state.counters["cell"] = // time per cell
        benchmark::Counter(unknowns / 4 * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void poisson(benchmark::State& state) {
    Scene s(state.range(0));
    for (auto _ : state) s.plane->poisson(s.r, s.u, s.workspace);
    // Two transforms of lines of n complex numbers (5 n log2 n each), the modes, and the recurrences.
    count(state, 4 * 8, 5 * std::log2(static_cast<double>(state.range(0))) + 2 * 8 + 10);
}

void mass(benchmark::State& state) { // weak Hessian: four solves with mass matrices along lines
    Scene s(state.range(0));
    for (auto _ : state) s.plane->hessian(s.phi, s.sigma, s.workspace);
    count(state, 5 * 8, 4 * 13);
}

void positions(benchmark::State& state) {
    Scene s(state.range(0));
    for (auto _ : state) s.plane->positions(s.phi, s.x, s.workspace);
    count(state, 1.5 * 8, 2 * 13 * 0.75);
}

void monitor(benchmark::State& state) {
    Scene s(state.range(0));
    for (auto _ : state) s.monitor->values(s.x, s.m);
    count(state, 0.25 * 4 * 8, 0.25 * 55);
}

void residual(benchmark::State& state) {
    Scene s(state.range(0));
    for (auto _ : state) s.plane->residual(s.m, s.sigma, s.r, s.workspace);
    // Per cell: 3 fields x 2 rows x 4 points x 5, 16 points x (3 x 5 + 3 + 3 + 4 + 6), 3 x 3 x 7 for the
    // tests.
    count(state, 4.25 * 8, (120 + 16 * 31 + 63) / 4.0);
}

void diagnostics(benchmark::State& state) {
    Scene s(state.range(0));
    QualityMeter meter(s.plane->mesh());
    for (auto _ : state) benchmark::DoNotOptimize(meter.measure(s.x, *s.monitor).equidistribution);
    count(state, 2 * 8, 36 * 70 / 4.0);
}

void step(benchmark::State& state) {
    Scene s(state.range(0));
    const MethodType type = relaxation_method();
    const auto method = type.make(
        {.discretisation = s.plane, .problem = [&] { return std::make_unique<PlaneEquation>(s.plane); }},
        default_values(type));
    State phi = method->initial_state();
    method->evaluate(ProblemData{s.monitor}, phi, {});
    for (auto _ : state) method->step(ProblemData{s.monitor}, phi, {});
    count(state, 17 * 8, 0);
}

void snapshot(benchmark::State& state) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    scenario.domain.values.set("cells", state.range(0));
    Run run(catalogue, scenario);
    for (auto _ : state) benchmark::DoNotOptimize(run.snapshot());
    count(state, 3 * 8, 0);
}

void sizes(benchmark::internal::Benchmark* one) {
    one->ArgName("n")->Unit(benchmark::kMicrosecond);
    for (const int n : {60, 120, 240, 480}) one->Arg(n);
}
BENCHMARK(poisson)->Apply(sizes);
BENCHMARK(mass)->Apply(sizes);
BENCHMARK(positions)->Apply(sizes);
BENCHMARK(monitor)->Apply(sizes);
BENCHMARK(residual)->Apply(sizes);
BENCHMARK(diagnostics)->Apply(sizes);
BENCHMARK(step)->Apply(sizes);
BENCHMARK(snapshot)->Apply(sizes);

} // namespace
