// Orders in N of meshes that are made without eps, up to N = 128.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace gaspard {
namespace {

double energy_error(const std::string& name, int cells, const std::vector<std::string>& settings) {
    static const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, name);
    std::vector<std::string> all = {"domain.cells=" + std::to_string(cells), "method.reference=on",
                                    "method.diagnostics_every=1000"}; // the error of the last mesh alone
    all.insert(all.end(), settings.begin(), settings.end());
    apply_settings(*catalogue, scenario, all);
    Run run(catalogue, scenario);
    const double error = *run.solve().value("energy_error");
    EXPECT_EQ(*run.history().back().tangled_cells, 0U) << name << ' ' << cells;
    return error;
}

struct KnownError {
    const char *scenario, *eps;
    double error; ///< with densities that know eps, N = 128 (figures 11 and 14 of Hill, Madden)
};
constexpr KnownError known_errors[] = {{"layer-2d", "1e-2", 4.69e-3},
                                       {"layer-2d", "1e-4", 7.49e-4},
                                       {"layer-2d", "1e-6", 9.95e-5},
                                       {"layer-2d", "1e-8", 6.55e-5},
                                       {"layer-quadrilateral", "1e-2", 1.53e-3},
                                       {"layer-quadrilateral", "1e-4", 1.26e-4},
                                       {"layer-quadrilateral", "1e-6", 1.29e-5},
                                       {"layer-quadrilateral", "1e-8", 1.30e-6}};

std::vector<std::string> without_eps(const std::string& density, const std::string& eps) {
    return {"method.type=solution-adapted", "method.density=" + density, "pde.eps=" + eps};
}

/// From N = 32 to 128.
double order(const std::string& scenario, const std::vector<std::string>& settings, double& error) {
    error = energy_error(scenario, 128, settings);
    return std::log2(energy_error(scenario, 32, settings) / error) / 2;
}

TEST(SolutionAdaptedOrders, AreAtLeastThoseOfDensitiesThatKnowEps) {
    for (const KnownError& known : known_errors)
        for (const std::string density : {"arc-length", "curvature"}) {
            double error = 0;
            EXPECT_GT(order(known.scenario, without_eps(density, known.eps), error), 0.9)
                << known.scenario << ' ' << known.eps << ' ' << density;
            EXPECT_LT(error, 1.6 * known.error) << known.scenario << ' ' << known.eps << ' ' << density;
        }
}

// Along x, and across the grid, with layers at two sides.
TEST(SolutionAdaptedOrders, AreOneForLayersOfConvection) {
    for (const std::string eps : {"1e-2", "1e-4", "1e-6"})
        for (const std::string density : {"arc-length", "curvature"})
            for (const std::string across : {"0", "0.5"}) {
                std::vector<std::string> settings = without_eps(density, eps);
                settings.push_back("pde.convection_y=" + across);
                double error = 0;
                EXPECT_GT(order("layer-2d-convection", settings, error), 0.9) << eps << density << across;
                EXPECT_LT(error, 0.018) << eps << ' ' << density << ' ' << across;
            }
}

} // namespace
} // namespace gaspard
