#include "core/base/error.hpp"
#include "core/monitor/combine.hpp"
#include "core/monitor/function.hpp"
#include "core/monitor/placement.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/built_in.hpp"
#include "support/monitor_values.hpp"
#include "support/sanitizers.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace gaspard {
namespace {

const Space plain{SpaceKind::euclidean}, torus{SpaceKind::periodic_square}, sphere{SpaceKind::sphere};

/// A ring, a bell and a bell elsewhere, with powers and weights.
std::vector<CombinedPart> three_parts(const Space& space) {
    return {{.monitor = make_monitor("ring", space), .power = 0.5, .weight = 2},
            {.monitor = make_monitor("bell", space), .power = 1, .weight = 0.3},
            {.monitor = make_monitor("ring-and-bell", space), .power = -1.5, .weight = 10}};
}

/// The terms w m^p of every part at a point.
std::vector<std::vector<double>> terms_of(const std::vector<CombinedPart>& parts, const Points& x) {
    std::vector<std::vector<double>> terms;
    for (const CombinedPart& part : parts) {
        terms.push_back(values_of(*part.monitor, x));
        for (double& value : terms.back()) value = part.weight * std::pow(value, part.power);
    }
    return terms;
}

const CombineOptions operations[] = {{CombineOperation::sum, 8.0},
                                     {CombineOperation::product, 8.0},
                                     {CombineOperation::maximum, 8.0},
                                     {CombineOperation::minimum, 8.0},
                                     {CombineOperation::maximum, std::nullopt},
                                     {CombineOperation::minimum, std::nullopt}};

TEST(Combine, HasTheValuesOfItsEquation) {
    for (const Space& space : {plain, torus, sphere}) {
        const auto parts = three_parts(space);
        const Points x = points_of(space);
        const auto terms = terms_of(parts, x);
        const auto at = [&](const CombineOptions& options) {
            return values_of(*combined_monitor(parts, options), x);
        };
        const auto sum = at(operations[0]), product = at(operations[1]), large = at(operations[2]),
                   small = at(operations[3]), largest = at(operations[4]), smallest = at(operations[5]);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double a = terms[0][i], b = terms[1][i], c = terms[2][i];
            EXPECT_NEAR(sum[i], a + b + c, 1e-13 * (a + b + c));
            EXPECT_NEAR(product[i], a * b * c, 1e-13 * a * b * c);
            EXPECT_EQ(largest[i], std::max({a, b, c}));
            EXPECT_EQ(smallest[i], std::min({a, b, c}));
            const double high = std::pow(std::pow(a, 8) + std::pow(b, 8) + std::pow(c, 8), 1.0 / 8);
            const double low = std::pow(std::pow(a, -8) + std::pow(b, -8) + std::pow(c, -8), -1.0 / 8);
            EXPECT_NEAR(large[i], high, 1e-12 * high);
            EXPECT_NEAR(small[i], low, 1e-12 * low);
            EXPECT_LE(large[i], std::pow(3, 1.0 / 8) * largest[i] * (1 + 1e-12)); // as the header promises
            EXPECT_GE(small[i], std::pow(3, -1.0 / 8) * smallest[i] * (1 - 1e-12));
        }
    }
}

TEST(Combine, HasTheGradientsOfItsValues) {
    for (const Space& space : {plain, torus, sphere})
        for (const CombineOptions& options : operations) {
            const auto monitor = combined_monitor(three_parts(space), options);
            const Points x = points_of(space);
            expect_gradients_of_values(*monitor, space, x, 1e-6);
        }
}

TEST(Combine, DoesNotOverflowInPowers) {
    const auto constant = [](double value) {
        return function_monitor([value](Vec3) { return value; }, plain);
    };
    Points x(1);
    for (const double size : {1e-150, 1.0, 1e150}) {
        const auto monitor = combined_monitor({{.monitor = constant(size)}, {.monitor = constant(2 * size)}},
                                              {CombineOperation::maximum, 64.0});
        EXPECT_NEAR(values_of(*monitor, x)[0] / (2 * size), 1, 1e-14);
    }
}

TEST(Combine, LeavesGradientsToDifferencesIfAPartHasNone) {
    const auto own = function_monitor([](Vec3 p) { return 1 + p.x; }, plain);
    Points gradients;
    combined_monitor({{.monitor = own}, {.monitor = make_monitor("ring", plain)}})
        ->gradients(points_of(plain), gradients);
    EXPECT_EQ(gradients.size(), 0u);
    EXPECT_EQ(combined_monitor({{.monitor = own}})->made_for(), SpaceKind::euclidean);
}

TEST(Combine, RefusesWhatGivesNoMonitor) {
    const auto ring = make_monitor("ring", plain);
    EXPECT_THROW(combined_monitor({}), InputError);
    EXPECT_THROW(combined_monitor({{}}), InputError);
    EXPECT_THROW(combined_monitor({{.monitor = ring, .weight = 0}}), InputError);
    EXPECT_THROW(combined_monitor({{.monitor = ring, .power = std::nan("")}}), InputError);
    EXPECT_THROW(combined_monitor({{.monitor = ring}}, {CombineOperation::maximum, 0.0}), InputError);
}

class CombineScenario : public testing::Test {
  protected:
    Scenario scenario_of(const std::string& text) const {
        return parse_scenario(*catalogue, text, "test.toml");
    }
    Scenario with(Scenario scenario, const std::vector<std::string>& settings) const {
        apply_settings(*catalogue, scenario, settings);
        return scenario;
    }
    std::string complaint(const std::string& text) const {
        try {
            scenario_of(text);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<Catalogue>(builtin_catalogue());
};

const char* const ring_in_bell = R"(
[monitor]
type = "combine"
operation = "product"

[monitor.a]
type = "bell"
center_x = 0.25
power = 2

[monitor.b]
type = "ring"
radius = 0.3
amplitude = 4
)";

TEST_F(CombineScenario, ReadsItsPartsFromTables) {
    const Scenario scenario = scenario_of(ring_in_bell);
    const Values& values = scenario.monitor.values;
    EXPECT_EQ(values.text("a.type"), "bell");
    EXPECT_EQ(values.real("a.center_x"), 0.25);
    EXPECT_EQ(values.real("a.power"), 2);
    EXPECT_EQ(values.text("b.type"), "ring");
    EXPECT_EQ(values.real("b.radius"), 0.3);
    EXPECT_FALSE(values.has("a.radius"));
    EXPECT_FALSE(values.has("c.power"));
    EXPECT_EQ(scenario_of(to_toml(scenario)), scenario);
}

TEST_F(CombineScenario, TakesItsKeysInAnyOrder) {
    const Scenario scenario = with(default_scenario(*catalogue),
                                   {"monitor.c.sharpness=70", "monitor.b.radius=0.3", "monitor.c.type=bell",
                                    "monitor.b.type=ring", "monitor.a.type=bell", "monitor.type=combine",
                                    "monitor.operation=maximum", "monitor.b.amplitude=4"});
    EXPECT_EQ(scenario.monitor.values.real("c.sharpness"), 70);
    EXPECT_EQ(scenario.monitor.values.real("b.radius"), 0.3);
    EXPECT_EQ(scenario.monitor.values.text("a.type"), "bell");
}

TEST_F(CombineScenario, SaysWhichKeysItDoesNotHave) {
    const std::string start = "[monitor]\ntype = \"combine\"\n[monitor.a]\n";
    EXPECT_NE(complaint(start + "radios = 0.2\n").find("did you mean 'monitor.a.radius'"), std::string::npos);
    EXPECT_NE(complaint(start + "type = \"combine\"\n").find("monitor.a.type"), std::string::npos);
    EXPECT_NE(complaint(start + "type = \"x-n\"\n").find("monitor.a.type"), std::string::npos);
    EXPECT_NE(complaint(start + "[monitor.a.u]\nvalue = 3\n").find("unknown key monitor.a.u.value"),
              std::string::npos);
    EXPECT_NE(complaint("[monitor.e]\ntype = \"ring\"\n").find("unknown key monitor.e.type"),
              std::string::npos);
}

TEST_F(CombineScenario, RefusesParametersThatAreNamedAsItsKeys) {
    for (const std::string name : {"weight", "power"})
        EXPECT_NE(complaint("[monitor]\ntype = \"combine\"\n[monitor.a]\ntype = \"formula\"\n"
                            "expression = \"1 + " +
                            name + "*x\"\n")
                      .find("monitor.a." + name +
                            " is a key of its own; a parameter of a formula cannot have this name"),
                  std::string::npos)
            << name;
}

TEST_F(CombineScenario, OffersItsPartsAsColoursAndFields) {
    Scenario scenario = with(scenario_of(ring_in_bell), {"view.color=part-a", "domain.cells=8"});
    gaspard::Run run(catalogue, scenario);
    const auto snapshot = run.snapshot();
    const Field* part = snapshot->field("part-a");
    ASSERT_NE(part, nullptr);
    const auto bell = make_monitor("bell", torus, {{"center_x", 0.25}});
    EXPECT_EQ(part->values, values_of(*bell, snapshot->x));
    EXPECT_NE(snapshot->field("part-b"), nullptr);
    EXPECT_EQ(snapshot->field("part-c"), nullptr);
    EXPECT_EQ(with(scenario, {"monitor.type=ring"}).view.text("color"), "monitor");
}

TEST_F(CombineScenario, ConvergesOnEveryDomain) {
    for (const std::string domain : {"plane", "cubed-sphere", "spline-patch"})
        for (const char* operation : {"sum", "product", "maximum", "minimum"}) {
            Scenario scenario =
                with(default_scenario(*catalogue),
                     {"domain.type=" + domain, sanitized ? "domain.cells=8" : "domain.cells=16",
                      "monitor.type=combine", std::string("monitor.operation=") + operation,
                      "monitor.a.amplitude=4", "monitor.a.sharpness=20", "monitor.b.amplitude=4",
                      "monitor.b.sharpness=20", "method.type=auto"});
            gaspard::Run run(catalogue, scenario);
            EXPECT_EQ(run.solve().status, RunStatus::converged) << domain << " " << operation;
        }
}

TEST_F(CombineScenario, OfPlaneSphereAndPatchConverges) {
    for (const char* name : {"plane-combine", "sphere-combine", "spline-combine"}) {
        Scenario scenario = find_scenario(*catalogue, name);
        EXPECT_EQ(scenario.monitor.type, "combine") << name;
        if (sanitized) scenario = with(scenario, {"domain.cells=20"});
        gaspard::Run run(catalogue, scenario);
        const StepReport& last = run.solve();
        EXPECT_EQ(last.status, RunStatus::converged) << name;
        EXPECT_EQ(last.tangled_cells, 0u) << name;
        for (const char* part : {"part-a", "part-b"}) EXPECT_NE(run.snapshot()->field(part), nullptr) << name;
    }
}

// Parts that a mesh can follow each, but not together.
TEST_F(CombineScenario, IsSmoothedSoThatAMeshCanFollowIt) {
    const std::vector<std::string> rings = {"domain.cells=32", "method.type=auto", "monitor.type=combine",
                                            "monitor.a.type=ring", "monitor.b.type=ring"};
    for (const auto& [name, settings] :
         {std::pair<std::string, std::vector<std::string>>{
              "walls-ring",
              {"monitor.operation=product", "monitor.b.center_x=0.6", "monitor.a.amplitude=30",
               "monitor.b.amplitude=30", "monitor.a.sharpness=200", "monitor.b.sharpness=200"}},
          {"spline-circle",
           {"monitor.operation=maximum", "monitor.b.center_x=0.6", "monitor.a.amplitude=30"}},
          {"spline-sine-waves", {"monitor.operation=maximum", "monitor.a.type=sine-waves"}},
          {"spline-sine-waves", {"monitor.operation=product"}},
          {"spline-moebius", {"monitor.operation=maximum"}}}) {
        Scenario scenario = with(with(find_scenario(*catalogue, name), rings), settings);
        gaspard::Run run(catalogue, scenario);
        const StepReport& last = run.solve();
        EXPECT_EQ(last.status, RunStatus::converged) << name;
        EXPECT_EQ(last.tangled_cells, 0u) << name;
        ASSERT_FALSE(run.monitor_report()->notes.empty()) << name;
        EXPECT_TRUE(run.monitor_report()->notes.back().starts_with("The monitor is smoothed over ")) << name;
        const gaspard::Run exact(catalogue, with(scenario, {"monitor.smoothing=0"}));
        EXPECT_TRUE(exact.monitor_report()->notes.back().starts_with(
            "The mesh may not follow the monitor: it needs a smoothing over "))
            << exact.monitor_report()->notes.back();
    }
}

TEST_F(CombineScenario, IsExactWhereAMeshCanFollowIt) {
    const Scenario scenario =
        with(scenario_of(ring_in_bell), {"domain.cells=60", "monitor.a.sharpness=10", "monitor.a.power=1",
                                         "monitor.a.amplitude=2", "monitor.b.sharpness=10"});
    const gaspard::Run run(catalogue, scenario);
    const auto monitor = make_on(catalogue->monitor("combine"), scenario.monitor.values,
                                 {.space = run.space(), .discretisation = &run.discretisation()});
    EXPECT_TRUE(monitor->report().notes.empty());
    const Points x = points_of(torus);
    const auto bell =
        values_of(*make_monitor("bell", torus, {{"center_x", 0.25}, {"sharpness", 10}, {"amplitude", 2}}), x);
    const auto ring =
        values_of(*make_monitor("ring", torus, {{"radius", 0.3}, {"amplitude", 4}, {"sharpness", 10}}), x);
    const auto m = values_of(*monitor, x);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(m[i] / (bell[i] * ring[i]), 1, 1e-14);
}

} // namespace
} // namespace gaspard
