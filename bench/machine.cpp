// Limits of this machine on one thread: bandwidth of memory and caches, and rate of multiply-adds. The rates
// of plane.cpp are compared with them.
#include <benchmark/benchmark.h>
#include <vector>

namespace {

// a = b + s c, counted as 24 bytes per number.
void triad(benchmark::State& state) {
    const auto n = static_cast<std::size_t>(state.range(0)) * 1024 / 24; // KiB of the three arrays together
    std::vector<double> a(n), b(n, 1.0), c(n, 2.0);
    for (auto _ : state) {
        double* __restrict to = a.data();
        for (std::size_t i = 0; i < n; ++i) to[i] = b[i] + 3.0 * c[i];
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(n) * 24);
}
BENCHMARK(triad)->ArgName("KiB")->Arg(16)->Arg(512)->Arg(8192)->Arg(262144);

// Independent chains of multiply-adds in registers, two operations each.
void multiply_add(benchmark::State& state) {
    constexpr std::size_t chains = 96;
    constexpr int rounds = 1000;
    alignas(64) double x[chains];
    for (double& value : x) value = 1.0;
    double factor = 0.999999, term = 1e-6;
    benchmark::DoNotOptimize(factor);
    benchmark::DoNotOptimize(term);
    for (auto _ : state) {
        for (int round = 0; round < rounds; ++round)
            for (double& value : x) value = value * factor + term;
        benchmark::DoNotOptimize(x);
    }
    state.counters["flops"] = benchmark::Counter(
        2.0 * chains * rounds * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(multiply_add);

} // namespace
