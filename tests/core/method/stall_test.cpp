// Monitors that the mesh hardly resolves: a method must not stall where the plain relaxation converges.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/sanitizers.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

const auto shipped_catalogue = std::make_shared<const Catalogue>(builtin_catalogue());

StepReport solved(const std::string& method, const std::vector<std::string>& settings) {
    Scenario scenario = find_scenario(*shipped_catalogue, "plane-ring");
    apply_settings(*shipped_catalogue, scenario, settings);
    apply_settings(*shipped_catalogue, scenario,
                   {"method.type=" + method, "method.max_iterations=1500", "method.diagnostics=none"});
    return Run(shipped_catalogue, scenario).solve();
}

std::vector<std::string> ring(int cells, double amplitude, double sharpness, double radius) {
    return {"domain.cells=" + std::to_string(cells), "monitor.amplitude=" + std::to_string(amplitude),
            "monitor.sharpness=" + std::to_string(sharpness), "monitor.radius=" + std::to_string(radius)};
}

TEST(Stall, AcceleratedConvergesOnRingsThatTheMeshHardlyResolves) {
    for (const auto& settings :
         {ring(20, 10, 200, std::sqrt(0.15)), ring(20, 16.18, 237.2, 0.4199), ring(20, 7.751, 380.6, 0.302),
          ring(30, 8.39, 291.3, 0.4018), ring(30, 10.7, 408.5, 0.3884)})
        EXPECT_EQ(solved("accelerated", settings).status, RunStatus::converged) << settings[2];
}

TEST(Stall, NoMethodStallsWhereTheRelaxationConverges) {
    std::mt19937 random(1); // its numbers are the same on every platform
    const auto uniform = [&](double a, double b) { return a + (b - a) * (random() / 4294967296.0); };
    constexpr int rings = sanitized ? 20 : 120;
    int relaxed = 0;
    for (int i = 0; i < rings; ++i) {
        std::vector<std::string> settings = ring(i % 2 == 0 ? 20 : 30, std::exp(uniform(0.7, 4)),
                                                 std::exp(uniform(4, 6.5)), uniform(0.1, 0.45));
        if (uniform(0, 1) < 0.3) settings.push_back("domain.boundary=walls");
        settings.push_back("monitor.center_x=" + std::to_string(uniform(0, 1)));
        if (solved("relaxation", settings).status != RunStatus::converged) continue;
        ++relaxed;
        for (const char* method : {"accelerated", "newton", "auto"}) {
            const StepReport report = solved(method, settings);
            EXPECT_EQ(report.status, RunStatus::converged)
                << method << " " << i << ", residual " << report.residual << " after " << report.iteration;
        }
    }
    EXPECT_GT(relaxed, rings / 2);
}

} // namespace
} // namespace gaspard
