// A spot moves on a circle, and the mesh follows it. Every time step starts from the map of the previous one.
#include <cmath>
#include <cstdio>
#include <gaspard/gaspard.hpp>
#include <numbers>

using namespace gaspard;

int main() {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = default_scenario(*catalogue); // the periodic unit square
    apply_settings(*catalogue, scenario,
                   {"domain.cells=60", "method.type=accelerated", "method.tolerance=1e-2"});
    Run run(catalogue, scenario);
    for (int step = 0; step <= 160; ++step) {
        const double angle = 2 * std::numbers::pi * step / 160;
        const Vec3 spot{0.5 + 0.25 * std::cos(angle), 0.5 + 0.25 * std::sin(angle), 0};
        run.follow(function_monitor([spot](Vec3 x) { // a simulation would evaluate its own fields
            const Vec3 d = displacement({SpaceKind::periodic_square}, spot, x);
            return 1 + 10 * std::exp(-100 * dot(d, d));
        }));
        const StepReport& report = run.solve(); // run.snapshot()->x: node positions
        std::printf("step %d: %s after %d iterations, equidistribution %.4f\n", step,
                    status_name(report.status).data(), report.iteration, *report.value("equidistribution"));
    }
}
