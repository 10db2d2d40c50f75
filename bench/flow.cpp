// Measures quasi-geostrophic flow for docs/flow.md: orders of convergence, the flow from noise to time 500
// that ships as the data of the scenario flow-vortices, and how much its end depends on noise, steps and n.
//
// Usage: bench_flow [FILE.nc], which also writes those data.
#include "core/flow/travelling.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/netcdf_file.hpp"
#include "core/published/mcrae_flow.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace {

using namespace gaspard;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// From one resolution to the next; 0 for the first.
double order(double before, double now) { return before > 0 ? std::log2(before / now) : 0; }

void print_orders() {
    const Travelling exact;
    const double norm = -exact.factor * exact.amplitude / 2;
    std::printf("| n | psi | order | q at time 1 | order |\n");
    double psi_before = 0, q_before = 0;
    for (const std::size_t n : {16, 32, 64, 128, 256}) {
        QuasiGeostrophicFlow flow = exact.flow(n);
        const auto wanted = nodal_values(n, [&](double x, double y) { return exact.psi(x, y, 0); });
        const double psi = largest_difference(flow.psi(), wanted) / exact.amplitude;
        flow.advance(1);
        const double q = l2_error(flow, [&](double x, double y) { return exact.q(x, y, 1); }) / norm;
        std::printf("| %zu | %.2e | %.2f | %.2e | %.2f |\n", n, psi, order(psi_before, psi), q,
                    order(q_before, q));
        psi_before = psi, q_before = q;
    }
    std::printf("| steps | change when halved | order |\n");
    std::vector<double> last;
    double before = 0;
    for (const int steps : {20, 40, 80, 160}) {
        QuasiGeostrophicFlow flow = Travelling{.amplitude = 0.01}.flow(32);
        for (int step = 0; step < steps; ++step) flow.step(0.1 / steps);
        const double change = last.empty() ? 0 : largest_difference(flow.q(), last);
        if (!last.empty()) std::printf("| %d | %.2e | %.2f |\n", steps / 2, change, order(before, change));
        last = flow.q(), before = change;
    }
}

/// Whether noise, carried along in 24 directions, stays bounded in steps of several Courant numbers.
void print_stability() {
    std::printf("| Courant number | enstrophy after 3000 steps / at the start, at most |\n");
    for (const double courant : {0.50, 0.52, 0.54, 0.56}) {
        double largest = 0;
        for (int k = 0; k < 24; ++k) {
            const double angle = 0.01 + 2 * std::numbers::pi * k / 24;
            QuasiGeostrophicFlow flow(
                {.cells = 16, .froude = 1e9, .background = {std::cos(angle), std::sin(angle)}});
            flow.set_state(continuous_state(16, noise_values(16, 3)));
            const double start = flow.diagnostics().enstrophy;
            const double dt = courant / flow.options().courant * flow.stable_step();
            for (int step = 0; step < 3000; ++step) flow.step(dt);
            const double ratio = flow.diagnostics().enstrophy / start;
            largest = ratio < 1e9 ? std::max(largest, ratio) : HUGE_VAL; // also if it is not a number
        }
        std::printf("| %.2f | %.3g |\n", courant, largest);
    }
}

void print_history(std::vector<double>& nodal) {
    const VortexFlow which;
    QuasiGeostrophicFlow flow = vortex_flow(which);
    const FlowDiagnostics start = flow.diagnostics();
    std::printf("mean %.17g, enstrophy %.6g, energy %.6g\n", start.mean, start.enstrophy, start.energy);
    std::printf("| time | least q | largest q | mean | enstrophy | energy | CPU s |\n");
    double seconds = 0, courant = 0;
    for (int step = 0;; ++step) {
        if (step % (which.steps / 10) == 0) {
            const FlowDiagnostics now = flow.diagnostics();
            std::printf("| %.0f | %.4f | %.4f | %+.1e | %.4f | %+.2e | %.2f |\n", flow.time(), now.low,
                        now.high, now.mean - start.mean, now.enstrophy / start.enstrophy,
                        now.energy / start.energy - 1, seconds);
        }
        if (step == which.steps) break;
        courant = std::max(courant, which.step / flow.stable_step() * flow.options().courant);
        const double before = cpu_seconds();
        flow.step(which.step);
        seconds += cpu_seconds() - before;
    }
    std::printf("%d steps, %.3f ms each, Courant number at most %.2f\n", which.steps,
                1e3 * seconds / which.steps, courant);
    flow.project(nodal);
    const auto [low, high] = std::minmax_element(nodal.begin(), nodal.end());
    std::printf("projected: %.4f to %.4f\n", *low, *high);
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const auto count = static_cast<double>(a.size());
    double mean_a = 0, mean_b = 0, aa = 0, ab = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) mean_a += a[i] / count, mean_b += b[i] / count;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double x = a[i] - mean_a, y = b[i] - mean_b;
        aa += x * x, ab += x * y, bb += y * y;
    }
    return ab / std::sqrt(aa * bb);
}

/// Flows to time 500 with other noise, and the same with other steps or a disturbance, compared with the first.
void print_others(const std::vector<double>& first) {
    std::printf("| flow | steps | least q | largest q | correlation |\n");
    const auto print = [&](const char* name, const VortexFlow& which, double disturbance) {
        QuasiGeostrophicFlow flow = vortex_flow(which);
        std::vector<double> q = flow.q();
        q[5] += disturbance;
        flow.set_state(q);
        std::size_t steps = 0;
        if (which.steps == 0)
            steps = flow.advance(500);
        else
            for (; steps < static_cast<std::size_t>(which.steps); ++steps) flow.step(which.step);
        const FlowDiagnostics end = flow.diagnostics();
        std::vector<double> nodal(first.size());
        if (which.cells * which.cells == first.size()) flow.project(nodal);
        double change = largest_difference(nodal, first);
        std::printf("| %s | %zu | %.4f | %.4f | %.4f (%.1e) |\n", name, steps, end.low, end.high,
                    correlation(nodal, first), change);
    };
    print("one value + 1e-15", {}, 1e-15);
    print("step 0.05", {.step = 0.05, .steps = 10000}, 0);
    print("step 0.025", {.step = 0.025, .steps = 20000}, 0);
    print("steps by Courant number", {.steps = 0}, 0);
    print("seed 2", {.seed = 2}, 0);
    print("seed 3", {.seed = 3}, 0);
    print("seed 4", {.seed = 4}, 0);
    print("seed 5", {.seed = 5}, 0);
}

std::string as_netcdf(const std::vector<double>& nodal) {
    const std::size_t n = VortexFlow{}.cells;
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

} // namespace

int main(int argc, char** argv) {
    print_orders();
    print_stability();
    std::vector<double> nodal(VortexFlow{}.cells * VortexFlow{}.cells);
    print_history(nodal);
    if (argc > 1) write_atomically(argv[1], as_netcdf(nodal));
    print_others(nodal);
}
