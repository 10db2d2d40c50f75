// Maps between ellipses that are known, and the densities of their problems.
#include "core/base/error.hpp"
#include "core/method/transport_equation.hpp"
#include "core/monitor/function.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/transport/exact_transport.hpp"
#include "support/messages.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

std::shared_ptr<const Catalogue> exact_catalogue() {
    static const auto all = std::make_shared<const Catalogue>(builtin_catalogue());
    return all;
}

Scenario exact_scenario(const std::string& name, const std::vector<std::string>& settings) {
    Scenario scenario = find_scenario(*exact_catalogue(), name);
    apply_settings(*exact_catalogue(), scenario, settings);
    return scenario;
}

gaspard::Run exact_run(const std::string& name, const std::vector<std::string>& settings) {
    gaspard::Run run(exact_catalogue(), exact_scenario(name, settings));
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    return run;
}

double last(const gaspard::Run& run, const char* series) {
    const auto value = run.history().back().value(series);
    EXPECT_TRUE(value.has_value()) << series;
    return value.value_or(NAN);
}

TEST(TransportExact, TheMapToTheEllipseIsAffine) {
    auto run = exact_run("transport-ellipse", {"domain.cells=12", "domain.degree=3"});
    const auto snapshot = run.snapshot();
    ASSERT_TRUE(snapshot->exact);
    for (std::size_t i = 0; i < snapshot->x.size(); ++i) {
        const Vec3 xi = snapshot->mesh->nodes[i];
        EXPECT_LT(norm((*snapshot->exact)[i] - Vec3{2 * xi.x, 3 * xi.y, 0}), 1e-12);
    }
    EXPECT_LT(last(run, "exact_rms_nodes"), 1e-3);
}

TEST(TransportExact, RadialDensitiesHaveTheirMap) {
    for (const auto& [degree, coarse_cells, cells, order, worst] :
         {std::tuple{1, 12, 24, 1.5, 2e-2}, {2, 8, 16, 1.9, 3e-3}, {3, 8, 16, 2.7, 3e-4}}) {
        const auto rms = [&, of = degree](int rings) {
            auto run = exact_run("transport-radial", {"domain.degree=" + std::to_string(of),
                                                      "domain.cells=" + std::to_string(rings)});
            const auto snapshot = run.snapshot();
            for (std::size_t i = 0; i < snapshot->x.size(); ++i) {
                const Vec3 xi = snapshot->mesh->nodes[i];
                EXPECT_LT(norm((*snapshot->exact)[i] - (1 + 0.4 * (1 - dot(xi, xi))) * xi), 1e-9);
            }
            return last(run, "exact_rms_nodes");
        };
        const double coarse = rms(coarse_cells), fine = rms(cells);
        EXPECT_GT(std::log2(coarse / fine), order) << degree;
        EXPECT_LT(fine, worst) << degree;
    }
}

/// What exact_transport() knows of the unit disk with these densities.
std::optional<std::function<Vec3(Vec3)>> exact_of_disk(const std::function<double(Vec3)>& density) {
    const auto disk = ellipse({}, 1, 1, 0);
    return exact_transport(*disk, *disk,
                           {nullptr, function_monitor(density, {.kind = SpaceKind::euclidean})});
}

TEST(TransportExact, OnlyWhatIsConstantOrRadialIsTakenForThat) {
    const auto squared = [](double x) { return x * x; };
    EXPECT_FALSE(exact_of_disk([](Vec3 p) { return 1 + 0.5 * std::cos(16 * std::atan2(p.y, p.x)); }));
    EXPECT_FALSE(
        exact_of_disk([](Vec3 p) { return 1 + 0.5 * dot(p, p) * std::cos(16 * std::atan2(p.y, p.x)); }));
    EXPECT_FALSE(exact_of_disk([&](Vec3 p) { // a narrow bell
        return 1 + 50 / squared(std::cosh(500 * norm(p - Vec3{0.903, 0.321, 0})));
    }));
    EXPECT_TRUE(exact_of_disk([](Vec3) { return 2.0; }));
    // 1 + A sech^2(B (r^2 - 1/4)): the mass within r is (r^2 + A/B (tanh(B (r^2 - 1/4)) + tanh(B/4))) / 2.
    for (const double b : {10.0, 500.0, 2000.0}) {
        const auto mass = [&](double r) {
            return (r * r + 5 / b * (std::tanh(b * (r * r - 0.25)) + std::tanh(b / 4))) / 2;
        };
        const auto map =
            exact_of_disk([&](Vec3 p) { return 1 + 5 / squared(std::cosh(b * (dot(p, p) - 0.25))); });
        ASSERT_TRUE(map) << b;
        for (const double r : {0.05, 0.4, 0.49, 0.5, 0.52, 0.7, 0.98}) {
            const double image = norm((*map)({0.6 * r, 0.8 * r, 0}));
            EXPECT_NEAR(mass(image) / mass(1), r * r, 1e-9) << b << " at " << r;
        }
    }
}

TEST(TransportExact, TheAreaOfTheImageHasAnOrder) {
    for (const auto& [degree, coarse_cells, order] : {std::tuple{1, 16, 1.3}, {2, 8, 2.3}, {3, 8, 2.7}}) {
        const auto error = [&, of = degree](int rings) {
            const auto run = exact_run("transport-ellipse", {"domain.degree=" + std::to_string(of),
                                                             "domain.cells=" + std::to_string(rings)});
            EXPECT_NEAR(last(run, "image_area") / last(run, "target_area") - 1, last(run, "area_error"),
                        1e-12);
            return std::abs(last(run, "area_error"));
        };
        EXPECT_GT(std::log2(error(coarse_cells) / error(2 * coarse_cells)), order) << degree;
    }
}

TEST(TransportExact, OtherProblemsHaveNoneKnown) {
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"domain.target.shape=polygon"},
          {"monitor.type=ring", "domain.target.a=2.5"},
          {"monitor.type=ring", "domain.target.a=1", "domain.target.b=1", "monitor.center_x=0.2"}}) {
        gaspard::Run run(exact_catalogue(), exact_scenario("transport-ellipse", settings));
        EXPECT_FALSE(run.snapshot()->exact);
    }
    gaspard::Run ring(
        exact_catalogue(),
        exact_scenario("transport-ellipse", {"monitor.type=ring", "domain.target.a=1", "domain.target.b=1"}));
    EXPECT_TRUE(ring.snapshot()->exact);
}

TEST(TransportExact, FarTargetsHaveTheSameMaps) {
    const auto map = [&](const std::vector<std::string>& settings) {
        std::vector<std::string> all = {"domain.cells=12", "domain.target.b=1.5"};
        all.insert(all.end(), settings.begin(), settings.end());
        return exact_run("transport-ellipse", all).snapshot()->x;
    };
    const Points near = map({}), far = map({"domain.target.x=1e6", "domain.target.y=-1e6", "domain.x=1e6"});
    for (std::size_t i = 0; i < near.size(); ++i)
        EXPECT_LT(norm(far[i] - Vec3{1e6, -1e6, 0} - near[i]), 1e-8);
}

TEST(TransportDensity, ZerosGetAFloorThatIsSaid) {
    const std::vector<std::string> settings = {"domain.target.a=1", "domain.target.b=1", "domain.cells=24",
                                               "monitor.type=formula", "monitor.expression=1 - x^2 - y^2"};
    const auto run = exact_run("transport-ellipse", settings);
    ASSERT_TRUE(run.monitor_report());
    ASSERT_EQ(run.monitor_report()->notes.size(), 1U);
    EXPECT_EQ(run.monitor_report()->notes[0],
              "Where the formula is 0 or nearly so, 1 % of its mean counts instead");
    std::vector<std::string> negative = settings;
    negative.back() = "monitor.expression=0.5 - x^2 - y^2";
    EXPECT_NE(message_of<InputError>([&] {
                  gaspard::Run bad(exact_catalogue(), exact_scenario("transport-ellipse", negative));
              }).find("must be positive"),
              std::string::npos);
}

TEST(TransportDensity, FormulasNeedNotBeValidOutside) {
    for (const char* expression : {"sqrt(1 - x^2 - y^2)", "0.2 + sqrt(1 - x^2 - y^2)"})
        for (const char* section : {"monitor", "monitor.source"})
            exact_run("transport-ellipse", {"domain.target.a=1", "domain.target.b=1", "domain.cells=24",
                                            std::string(section) + ".type=formula",
                                            std::string(section) + ".expression=" + expression});
}

TEST(TransportDensity, OwnMonitorsAreAskedForTheTargetAlone) {
    RunOptions options;
    options.monitor = function_monitor(
        [](Vec3 x) {
            EXPECT_LE(std::hypot((x.x - 10) / 2, x.y / 3), 1); // also where gradients are differences
            return 1 + 0.5 * std::sin(x.x + x.y);
        },
        {.kind = SpaceKind::euclidean});
    gaspard::Run run(exact_catalogue(),
                     exact_scenario("transport-ellipse", {"domain.cells=12", "domain.target.x=10"}), options);
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
}

TEST(TransportThin, DegreeTwoMapsToAThinEllipseAndDegreeOneSaysSo) {
    const std::vector<std::string> thin = {"domain.target.a=1", "domain.target.b=1e-3", "domain.cells=16"};
    gaspard::Run first(exact_catalogue(), exact_scenario("transport-ellipse", thin));
    ASSERT_TRUE(first.monitor_report());
    ASSERT_EQ(first.monitor_report()->notes.size(), 1U);
    EXPECT_EQ(first.monitor_report()->notes[0],
              "The target is 1000 times as long as wide, which is too thin for elements of degree 1; set "
              "domain.degree = 2");
    std::vector<std::string> second = thin;
    second.emplace_back("domain.degree=2");
    const auto run = exact_run("transport-ellipse", second);
    EXPECT_TRUE(!run.monitor_report() || run.monitor_report()->notes.empty());
    EXPECT_NEAR(last(run, "area_error"), 0, 1e-2);
    EXPECT_EQ(run.history().back().tangled_cells, 0U);
}

TEST(TransportStop, SettingUpEndsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    const auto domain =
        std::make_shared<const TransportDomain>(TransportDomain::Setup{.source = ellipse({}, 1, 1),
                                                                       .target = ellipse({}, 2, 1),
                                                                       .rings = 8,
                                                                       .degree = 3,
                                                                       .source_name = "disk"});
    EXPECT_THROW(TransportEquation(domain, Recovery::gradient, source.get_token()), Interrupted);
    EXPECT_THROW(TransportDomain(domain->setup(), source.get_token()), Interrupted);
}

} // namespace
} // namespace gaspard
