// What a typed formula costs: CPU time per iteration with the ring as a formula and with the built-in ring,
// over whole solves (medians of several), and the time to find the parameters of a point on patches.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace gaspard;

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Measure>
double median(const Measure& measure) {
    std::vector<double> times;
    for (int k = 0; k < 5; ++k) times.push_back(measure());
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

double seconds_per_iteration(const std::shared_ptr<const Catalogue>& catalogue, const Scenario& scenario) {
    return median([&] {
        Run run(catalogue, scenario);
        const double start = cpu_seconds();
        const StepReport& last = run.solve();
        return (cpu_seconds() - start) / last.iteration;
    });
}

void compare(const std::shared_ptr<const Catalogue>& catalogue, const std::string& name,
             const std::string& method) {
    Scenario scenario = find_scenario(*catalogue, name);
    apply_settings(*catalogue, scenario, {"method.type=" + method, "method.diagnostics_every=1000"});
    if (scenario.domain.type == "plane") apply_settings(*catalogue, scenario, {"domain.cells=120"});
    const double own = seconds_per_iteration(catalogue, scenario);
    const double typed = seconds_per_iteration(catalogue, *with_formula(*catalogue, scenario));
    std::printf("%-12s %-13s built-in %8.3f ms, formula %8.3f ms, ratio %.2f\n", name.c_str(), method.c_str(),
                1e3 * own, 1e3 * typed, typed / own);
}

void find_parameters(const std::shared_ptr<const Catalogue>& catalogue, const std::string& domain) {
    Scenario scenario = default_scenario(*catalogue);
    apply_settings(*catalogue, scenario,
                   {"domain.type=" + domain, "method.type=picard", "monitor.type=constant"});
    const Run run(catalogue, scenario);
    const auto parameters = run.discretisation().parameters();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    Points uv(100'000), x, found;
    for (std::size_t i = 0; i < uv.size(); ++i) uv.set(i, {unit(random), unit(random), 0});
    parameters->points(uv, x);
    parameters->find(x, found); // makes the samples
    const double time = median([&] {
        const double start = cpu_seconds();
        parameters->find(x, found);
        return cpu_seconds() - start;
    });
    std::printf("%-15s u and v of a point: %5.0f ns\n", domain.c_str(), 1e9 * time / 1e5);
}

} // namespace

int main() {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    for (const char* method : {"relaxation", "accelerated", "newton", "auto"})
        compare(catalogue, "plane-ring", method);
    for (const char* method : {"relaxation", "newton"}) compare(catalogue, "sphere-x4", method);
    for (const char* domain :
         {"spline-annulus", "spline-torus", "spline-moebius", "spline-disk", "spline-patch"})
        find_parameters(catalogue, domain);
}
