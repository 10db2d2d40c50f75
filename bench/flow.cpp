// The flow of docs/flow.md from noise to time 500: prints how it develops and what it costs, and, given the
// name of a file, writes its last state, the data of the scenario flow-vortices.
//
// Usage: bench_flow [FILE.nc]
#include "core/io/atomic_file.hpp"
#include "core/io/netcdf_file.hpp"
#include "core/published/mcrae_flow.hpp"

#include <cstdio>
#include <ctime>

namespace {

using namespace gaspard;

std::string as_netcdf(std::size_t n, const std::vector<double>& nodal) {
    std::vector<double> axis(n);
    for (std::size_t i = 0; i < n; ++i) axis[i] = static_cast<double>(i) / static_cast<double>(n);
    NetcdfFile file{{{"y", n}, {"x", n}}};
    for (const char* name : {"x", "y"}) file.variables.push_back({name, {name}, axis});
    file.variables.push_back({"q",
                              {"y", "x"},
                              std::vector<float>(nodal.begin(), nodal.end()),
                              {{"long_name", std::string("potential vorticity")}}});
    file.attributes = {{"Conventions", std::string("CF-1.8")},
                       {"title", std::string("vortices of a quasi-geostrophic flow")}};
    return netcdf_bytes(file);
}

void print(const QuasiGeostrophicFlow& flow, const FlowDiagnostics& now, const FlowDiagnostics& start,
           double seconds) {
    std::printf("| %.0f | %.4f | %.4f | %+.1e | %.4g | %+.2e | %.2f |\n", flow.time(), now.low, now.high,
                now.mean - start.mean, now.enstrophy / start.enstrophy, now.energy / start.energy - 1,
                seconds);
}

} // namespace

int main(int argc, char** argv) {
    const VortexFlow which;
    QuasiGeostrophicFlow flow = vortex_flow(which);
    const FlowDiagnostics start = flow.diagnostics();
    std::printf("mean %.17g, enstrophy %.6g, energy %.6g\n", start.mean, start.enstrophy, start.energy);
    std::printf("| time | least q | largest q | mean | enstrophy | energy | CPU s |\n");
    double seconds = 0, largest_step = 0;
    for (int step = 0; step <= which.steps; ++step) {
        if (step % (which.steps / 10) == 0) print(flow, flow.diagnostics(), start, seconds);
        if (step == which.steps) break;
        largest_step = std::max(largest_step, which.step / flow.stable_step() * flow.options().courant);
        const std::clock_t before = std::clock();
        flow.step(which.step);
        seconds += static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    }
    std::printf("%d steps, %.3f ms each, Courant number at most %.3f\n", which.steps,
                1e3 * seconds / which.steps, largest_step);
    std::vector<double> nodal(which.cells * which.cells);
    flow.project(nodal);
    const auto [low, high] = std::minmax_element(nodal.begin(), nodal.end());
    std::printf("projected: %.4f to %.4f\n", *low, *high);
    if (argc > 1) write_atomically(argv[1], as_netcdf(which.cells, nodal));
}
