// Monitors of the caller's own: their unit, what they are asked, what they may not be, and what they cost.
#include "core/base/error.hpp"
#include "core/base/stopwatch.hpp"
#include "core/monitor/monitor.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/spline/patch_file.hpp"
#include "support/largest_distance.hpp"
#include "support/sanitizers.hpp"

#include <atomic>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

namespace gaspard {
namespace {

/// Only values(), as a simulation would write it; counts the points.
class Own final : public Monitor {
  public:
    explicit Own(std::function<double(Vec3)> function) : function_(std::move(function)) {}
    void values(const Points& x, std::span<double> values) const override {
        points += x.size();
        for (std::size_t i = 0; i < x.size(); ++i) values[i] = function_(x[i]);
    }
    mutable std::atomic<std::size_t> points = 0;

  private:
    std::function<double(Vec3)> function_;
};

double smooth(Vec3 p) { return 2 + std::sin(6.283185307179586 * p.x) * std::cos(6.283185307179586 * p.y); }
double bump(Vec3 p) {
    const Vec3 d = displacement({SpaceKind::periodic_square}, {0.4, 0.6, 0}, p);
    return 1 + 5 * std::exp(-40 * dot(d, d));
}

class OwnMonitorTest : public testing::Test {
  protected:
    Scenario scenario(const std::string& name, const std::vector<std::string>& settings) const {
        Scenario of = find_scenario(*catalogue, name);
        apply_settings(*catalogue, of, settings);
        return of;
    }
    gaspard::Run make(const std::vector<std::string>& settings = {}) const {
        Scenario of =
            scenario("plane-ring", {"domain.cells=24", "method.type=accelerated", "method.tolerance=1e-6"});
        apply_settings(*catalogue, of, settings);
        return gaspard::Run(catalogue, of);
    }
    static std::string refused(const std::function<void()>& call) {
        try {
            call();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

// The iterations are those for m, whatever the unit of m.
TEST_F(OwnMonitorTest, TheUnitIsArbitrary) {
    struct Case {
        const char* scenario;
        std::vector<std::string> settings;
        std::vector<std::string> methods;
    };
    const std::vector<std::string> all = {"relaxation", "accelerated", "quasi-newton", "newton", "auto"};
    const std::vector<Case> cases = {{"plane-ring", {"domain.cells=48"}, all},
                                     {"walls-ring", {"domain.cells=24"}, all},
                                     {"sphere-x2", {"domain.cells=8", "domain.radius=2"}, all},
                                     {"spline-circle",
                                      {"domain.type=spline-disk", "domain.cells=32"},
                                      {"picard", "picard-mixed", "newton", "accelerated", "auto"}}};
    const std::vector<double> units = sanitized
                                          ? std::vector{1.0, 1e-300}
                                          : std::vector{1.0, 1e-6, 1e-12, 1e6, 1e100, 1e-100, 1e-300, 1e300};
    for (const auto& [name, settings, methods] : cases)
        for (const auto& method : methods) {
            Scenario of = scenario(name, settings);
            apply_settings(*catalogue, of, {"method.type=" + method, "method.tolerance=1e-7"});
            std::shared_ptr<const Snapshot> first;
            std::vector<double> first_steps;
            for (const double c : units) {
                SCOPED_TRACE(std::string(name) + ", " + method + ", " + std::to_string(std::log10(c)));
                gaspard::Run run(catalogue, of,
                                 {.monitor = std::make_shared<Own>([c](Vec3 p) {
                                      return c * (1.5 + 0.5 * std::sin(3 * p.x) * std::cos(2 * p.y + p.z));
                                  })});
                EXPECT_EQ(run.solve().status, RunStatus::converged);
                const auto snapshot = run.snapshot();
                if (!first) first = snapshot;
                EXPECT_EQ(snapshot->report.iteration, first->report.iteration);
                EXPECT_LT(largest_distance(snapshot->x, first->x), 1e-9);
                // Results keep the unit of m.
                EXPECT_NEAR(*snapshot->report.value("theta") / c, *first->report.value("theta"), 1e-9);
                for (const char* field : {"monitor", "mass"})
                    EXPECT_NEAR(snapshot->field(field)->values[7] / c, first->field(field)->values[7], 1e-8);
                EXPECT_NEAR(*snapshot->report.value("equidistribution"),
                            *first->report.value("equidistribution"), 1e-8);
                if (of.domain.type != "spline-disk") continue;
                std::vector<double> steps; // of the increments of Picard and Newton, which have no unit
                for (const StepReport& row : run.history()) steps.push_back(row.step_size);
                if (first_steps.empty()) first_steps = steps;
                ASSERT_EQ(steps.size(), first_steps.size());
                for (std::size_t i = 0; i < steps.size(); ++i)
                    EXPECT_NEAR(steps[i], first_steps[i], 1e-6) << i;
            }
        }
}

TEST_F(OwnMonitorTest, BadValuesAreRefusedWithThePoint) {
    for (const char* method : {"relaxation", "accelerated", "auto"}) {
        gaspard::Run run = make({std::string("method.type=") + method});
        run.follow(std::make_shared<Own>(bump));
        run.solve();
        const State good = run.state();
        const double equidistribution = *run.history().back().value("equidistribution");
        for (const double bad : {-1.0, 0.0, std::numeric_limits<double>::infinity(), std::nan("")})
            for (const double from : {0.0, 0.5}) { // everywhere, and in a half
                const std::string message = refused([&] {
                    run.follow(std::make_shared<Own>([=](Vec3 p) { return p.x >= from ? bad : 1; }));
                });
                EXPECT_TRUE(message.starts_with("the monitor must be positive and finite, but is "))
                    << message;
                EXPECT_NE(message.find(" at ("), std::string::npos);
                EXPECT_EQ(run.state(), good);
                EXPECT_EQ(run.status(), RunStatus::converged);
                EXPECT_EQ(*run.snapshot()->report.value("equidistribution"), equidistribution);
            }
        run.follow(std::make_shared<Own>(bump));
        EXPECT_EQ(run.history().front().status, RunStatus::converged) << "the good map was kept";
        run.follow(std::make_shared<Own>(smooth));
        EXPECT_EQ(run.solve().status, RunStatus::converged);
    }
}

// A monitor that is bad only where the nodes will go.
TEST_F(OwnMonitorTest, BadValuesOnTheWayLeaveTheLastIterate) {
    for (const char* method : {"relaxation", "newton", "auto"}) {
        gaspard::Run run = make({std::string("method.type=") + method});
        auto good = std::make_shared<bool>(true);
        run.follow(std::make_shared<Own>([good](Vec3 p) { return *good ? bump(p) : -1; }));
        run.step();
        const State state = run.state();
        const auto before = run.snapshot();
        *good = false;
        for (int twice = 0; twice < 2; ++twice) {
            EXPECT_NE(refused([&] { run.step(); }), "");
            EXPECT_EQ(run.state(), state);
            EXPECT_EQ(run.history().size(), 2u);
        }
        *good = true;
        EXPECT_EQ(run.snapshot()->x, before->x);
        EXPECT_EQ(run.solve().status, RunStatus::converged) << "the same run goes on";
    }
}

TEST_F(OwnMonitorTest, AChangeIsAllOrNothing) {
    for (const char* change :
         {"domain.cells=36", "method.type=newton", "method.tolerance=1e-7", "domain.boundary=periodic"}) {
        gaspard::Run run = make();
        auto fails = std::make_shared<bool>(false);
        auto later = std::make_shared<int>(-1); // calls until it fails
        run.follow(std::make_shared<Own>([fails, later](Vec3 p) {
            if (*fails && (*later)-- <= 0) throw std::runtime_error("the simulation has gone");
            return bump(p);
        }));
        run.step();
        const auto before = run.snapshot();
        const Scenario old = run.scenario();
        Scenario next = old;
        apply_settings(*catalogue, next, {change});
        if (next.method == old.method && next.domain == old.domain) continue;
        for (const int calls :
             {0, 100, 3000, 20000}) { // at the first values, in the evaluation, in measuring
            *fails = true, *later = calls;
            EXPECT_THROW(run.change(next), std::runtime_error) << change << ", " << calls;
            *fails = false;
            EXPECT_EQ(run.scenario().domain, old.domain);
            EXPECT_EQ(run.scenario().method, old.method);
            EXPECT_EQ(run.history().size(), 2u);
            const auto after = run.snapshot();
            EXPECT_EQ(after->mesh, before->mesh);
            EXPECT_EQ(after->x, before->x);
            EXPECT_EQ(after->field("mass")->values, before->field("mass")->values);
            EXPECT_EQ(after->report.residual, before->report.residual);
        }
        run.change(next);
        EXPECT_EQ(run.solve().status, RunStatus::converged);
    }
}

TEST_F(OwnMonitorTest, FollowingIsAllOrNothing) {
    gaspard::Run run = make();
    run.follow(std::make_shared<Own>(bump));
    run.solve();
    const auto before = run.snapshot();
    auto calls = std::make_shared<int>(0);
    EXPECT_THROW(run.follow(std::make_shared<Own>([calls](Vec3 p) {
        if (++*calls > 3000) throw std::runtime_error("while the mesh is measured");
        return smooth(p);
    })),
                 std::runtime_error);
    EXPECT_GT(*calls, 3000);
    EXPECT_EQ(run.status(), RunStatus::converged);
    const auto after = run.snapshot();
    EXPECT_EQ(after->field("mass")->values, before->field("mass")->values);
    EXPECT_EQ(after->field("monitor")->values, before->field("monitor")->values);
    EXPECT_EQ(run.history().size(), static_cast<std::size_t>(before->report.iteration) + 1);
}

TEST_F(OwnMonitorTest, FollowingCanBeStopped) {
    gaspard::Run run = make();
    run.follow(std::make_shared<Own>(bump));
    run.solve();
    const State state = run.state();
    std::stop_source stop;
    const auto monitor = std::make_shared<Own>([stop](Vec3 p) mutable {
        if (p.x > 0.9) stop.request_stop();
        return smooth(p);
    });
    EXPECT_THROW(run.follow(monitor, stop.get_token()), Interrupted);
    EXPECT_EQ(run.state(), state);
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_LE(monitor->points, 2u * 25 * 25 + 100) << "the mesh is not measured";
    run.follow(monitor); // without a token
    EXPECT_EQ(run.solve().status, RunStatus::converged);
}

TEST_F(OwnMonitorTest, DiagnosticsAreAChoice) {
    for (const char* name : {"plane-ring", "sphere-x2", "spline-circle"})
        for (const char* level : {"full", "geometry", "none"}) {
            SCOPED_TRACE(std::string(name) + ", " + level);
            const bool splines = name == std::string("spline-circle");
            const Scenario of =
                scenario(name, {"domain.cells=16", "method.type=accelerated", "method.tolerance=1e-6",
                                std::string("method.diagnostics=") + level});
            const auto monitor = std::make_shared<Own>(
                [](Vec3 p) { return 1.5 + 0.5 * std::sin(3 * p.x) * std::cos(2 * p.y + p.z); });
            gaspard::Run run(catalogue, of, {.monitor = monitor});
            run.solve();
            monitor->points = 0;
            run.follow(monitor);
            const StepReport& last = run.solve();
            EXPECT_EQ(last.status, RunStatus::converged);
            const bool full = level == std::string("full"), none = level == std::string("none");
            const std::size_t quadrature = 36 * run.discretisation().mesh()->cell_count();
            if (!splines) { // whose iteration has quadrature points of its own
                EXPECT_EQ(monitor->points >= quadrature, full) << monitor->points;
            }
            EXPECT_EQ(last.tangled_cells, std::optional<std::size_t>(0)) << "is always looked for";
            EXPECT_EQ(last.value("equidistribution").has_value(), full);
            EXPECT_EQ(last.value("min_jacobian").has_value(), !none || (splines && full));
            const auto snapshot = run.snapshot();
            EXPECT_EQ(snapshot->field("mass") != nullptr, full);
            EXPECT_TRUE(snapshot->field("jacobian") != nullptr && snapshot->field("monitor") != nullptr);
        }
}

TEST_F(OwnMonitorTest, TangledCellsAreFoundWithoutDiagnostics) {
    for (const char* level : {"full", "geometry", "none"}) {
        gaspard::Run run = make({"domain.cells=8", "method.type=relaxation", "method.step_size=0.01",
                                 "monitor.radius=0.15", "monitor.amplitude=600", "method.max_iterations=300",
                                 std::string("method.diagnostics=") + level});
        EXPECT_EQ(run.solve().status, RunStatus::diverged) << level;
        EXPECT_GT(*run.history().back().tangled_cells, 0u);
    }
}

TEST_F(OwnMonitorTest, TimesIncludeFollowing) {
    gaspard::Run run = make({"method.diagnostics=none"});
    const auto slow = std::make_shared<Own>([](Vec3 p) {
        double sum = 0;
        for (int i = 0; i < 2000; ++i) sum += std::sin(p.x + i);
        return 2 + 1e-9 * sum;
    });
    const Stopwatch watch;
    run.follow(slow);
    const double cpu = watch.cpu_seconds();
    EXPECT_GT(run.history().front().cpu_seconds, 0.5 * cpu);
    EXPECT_LE(run.history().front().cpu_seconds, cpu);
    EXPECT_GT(run.history().front().seconds, 0);
}

TEST_F(OwnMonitorTest, AskedOnlyWithinTheDomain) {
    struct Case {
        const char* scenario;
        std::function<bool(Vec3)> inside;
    };
    const std::vector<Case> cases = {
        {"plane-ring", [](Vec3 p) { return p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1 && p.z == 0; }},
        {"walls-ring", [](Vec3 p) { return p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1 && p.z == 0; }},
        {"sphere-x2", [](Vec3 p) { return std::abs(norm(p) - 2) < 1e-14; }},
        {"spline-circle", [](Vec3 p) { return p.z == 0; }}};
    for (const auto& [name, inside] : cases)
        for (const char* method : {"accelerated", "newton"}) {
            Scenario of = scenario(name, {"domain.cells=12", std::string("method.type=") + method});
            if (name == std::string("sphere-x2")) apply_settings(*catalogue, of, {"domain.radius=2"});
            std::size_t outside = 0;
            gaspard::Run run(catalogue, of, {.monitor = std::make_shared<Own>([&](Vec3 p) {
                                                 outside += inside(p) ? 0 : 1;
                                                 return 1.5 +
                                                        0.5 * std::sin(3 * p.x) * std::cos(2 * p.y + p.z);
                                             })});
            EXPECT_EQ(run.solve().status, RunStatus::converged) << name << ", " << method;
            run.snapshot();
            EXPECT_EQ(outside, 0u) << name << ", " << method;
        }
}

// Newton's method converges quadratically with the differences that replace missing gradients.
TEST_F(OwnMonitorTest, GradientsHaveADefault) {
    gaspard::Run run = make({"method.type=newton", "method.tolerance=1e-10"});
    run.follow(std::make_shared<Own>(bump));
    EXPECT_EQ(run.solve().status, RunStatus::converged);
    EXPECT_LE(run.history().back().iteration, 12);
}

TEST_F(OwnMonitorTest, ARunBeginsWithThem) {
    const auto monitor = std::make_shared<Own>([](Vec3 p) { return 2 + p.x; });
    SplinePatch quarter = nurbs_disk();
    for (std::size_t i = 0; i < quarter.control.size(); ++i)
        quarter.control.set(i, {100 + 3 * quarter.control.x[i], 2 * quarter.control.y[i], 0});
    Scenario of = scenario("spline-patch", {"domain.cells=16", "monitor.type=constant"});
    gaspard::Run run(catalogue, of,
                     {.monitor = monitor, .patch = std::make_shared<SplinePatch>(std::move(quarter))});
    EXPECT_EQ(run.scenario().monitor.type, own_monitor);
    EXPECT_EQ(run.discretisation().mesh()->cell_count(), 256u);
    EXPECT_EQ(run.history().size(), 1u);
    EXPECT_EQ(run.epoch(), 0);
    EXPECT_EQ(run.solve().status, RunStatus::converged);
    const auto snapshot = run.snapshot();
    for (const double x : snapshot->x.x) EXPECT_TRUE(x > 96.9 && x < 103.1) << x;
    EXPECT_NE(refused([&] {
                  gaspard::Run(catalogue, of, {.monitor = std::make_shared<Own>([](Vec3) { return -1.0; })});
              }),
              "");
}

// What chose the scenario's own patch does not refer to the caller's.
TEST_F(OwnMonitorTest, ARunsPatchReplacesTheChoiceOfAnother) {
    const Scenario of =
        scenario("spline-patch", {"domain.file=none.xml", "domain.patch=3", "domain.cells=8",
                                  "domain.degree=2", "domain.control_points=1 2", "monitor.type=constant"});
    const gaspard::Run run(catalogue, of, {.patch = std::make_shared<SplinePatch>(nurbs_disk())});
    EXPECT_EQ(run.discretisation().mesh()->cell_count(), 64u);
    EXPECT_EQ(run.scenario().domain.values.integer("degree"), 2);
    for (const char* key : {"patch", "control_points"})
        EXPECT_EQ(run.scenario().domain.values.text(key), "") << key;
}

} // namespace
} // namespace gaspard
