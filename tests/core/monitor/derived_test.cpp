#include "core/base/error.hpp"
#include "core/monitor/derived.hpp"
#include "core/monitor/stages.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/monitor_values.hpp"
#include "support/sanitizers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace gaspard {
namespace {

constexpr double wave = 2 * std::numbers::pi;

/// A function with exact gradients.
class Exact final : public ScalarFunction {
  public:
    Exact(std::function<double(Vec3)> value, std::function<Vec3(Vec3)> slope)
        : value_(std::move(value)), slope_(std::move(slope)) {}
    void values(const Points& x, std::span<double> values) const override {
        for (std::size_t i = 0; i < x.size(); ++i) values[i] = value_(x[i]);
    }
    void gradients(const Points& x, Points& gradients) const override {
        gradients.resize(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) gradients.set(i, slope_(x[i]));
    }

  private:
    std::function<double(Vec3)> value_;
    std::function<Vec3(Vec3)> slope_;
};

std::shared_ptr<const ScalarFunction> waves() {
    return std::make_shared<Exact>([](Vec3 p) { return std::sin(wave * p.x) * std::cos(wave * p.y); },
                                   [](Vec3 p) {
                                       return Vec3{wave * std::cos(wave * p.x) * std::cos(wave * p.y),
                                                   -wave * std::sin(wave * p.x) * std::sin(wave * p.y), 0};
                                   });
}

std::shared_ptr<const ScalarFunction> height() {
    return std::make_shared<Exact>([](Vec3 p) { return p.z; },
                                   [](Vec3 p) {
                                       return Vec3{0, 0, 1} - (p.z / dot(p, p)) * p;
                                   });
}

/// A layer of this width through a unit square.
std::shared_ptr<const ScalarFunction> layer(double width) {
    const auto place = [width](Vec3 p) { return (p.x + 0.3 * p.y - 0.65) / width; };
    return std::make_shared<Exact>([=](Vec3 p) { return std::tanh(place(p)); },
                                   [=](Vec3 p) {
                                       const double s = 1 / std::cosh(place(p));
                                       return s * s / width * Vec3{1, 0.3, 0};
                                   });
}

Points square_points() {
    Points x(1000);
    for (std::size_t i = 0; i < x.size(); ++i)
        x.set(i, {std::fmod(0.7548776662 * static_cast<double>(i), 1.0),
                  std::fmod(0.5698402909 * static_cast<double>(i), 1.0), 0});
    return x;
}

Points sphere_points(double radius) {
    Points x(1000);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double z = (2 * static_cast<double>(i) + 1) / 1000 - 1,
                     angle = 2.39996 * static_cast<double>(i);
        const double r = std::sqrt(1 - z * z);
        x.set(i, radius * Vec3{r * std::cos(angle), r * std::sin(angle), z});
    }
    return x;
}

/// m is the indicator alone.
DerivedOptions bare(Indicator indicator) {
    DerivedOptions options;
    options.indicator = indicator;
    options.average = options.limit = options.smooth = false;
    return options;
}

MonitorContext on(SpaceKind kind) {
    MonitorContext context;
    context.space.kind = kind;
    return context;
}

void expect_values(const Monitor& monitor, const Points& x, const std::function<double(Vec3)>& expected,
                   double tolerance) {
    const auto m = values_of(monitor, x);
    for (std::size_t i = 0; i < x.size(); ++i)
        ASSERT_NEAR(m[i] / expected(x[i]), 1, tolerance) << x.x[i] << " " << x.y[i] << " " << x.z[i];
}

TEST(Derived, HasArcLengthAndCurvatureOnPlaneAndWalls) {
    const auto slope2 = [](Vec3 p) { // |grad v|^2, v = u / 2
        const double a = wave * std::cos(wave * p.x) * std::cos(wave * p.y);
        const double b = wave * std::sin(wave * p.x) * std::sin(wave * p.y);
        return (a * a + b * b) / 4;
    };
    const auto hessian2 = [](Vec3 p) {
        const double a = wave * wave * std::sin(wave * p.x) * std::cos(wave * p.y);
        const double b = wave * wave * std::cos(wave * p.x) * std::sin(wave * p.y);
        return (2 * a * a + 2 * b * b) / 4;
    };
    const Points x = square_points();
    for (const SpaceKind kind : {SpaceKind::periodic_square, SpaceKind::euclidean}) {
        const auto at = [&](Indicator indicator) {
            return derived_monitor(waves(), bare(indicator), on(kind));
        };
        expect_values(
            *at(Indicator::arc_length), x, [&](Vec3 p) { return std::sqrt(1 + slope2(p)); }, 2e-5);
        expect_values(
            *at(Indicator::curvature), x, [&](Vec3 p) { return std::cbrt(1 + hessian2(p)); }, 3e-4);
        DerivedOptions options = bare(Indicator::curvature);
        options.order = 1, options.alpha = 0.01, options.normalise = false;
        expect_values(
            *derived_monitor(waves(), options, on(kind)), x,
            [&](Vec3 p) { return std::sqrt(1 + 0.01 * 4 * hessian2(p)); }, 3e-5);
        options.indicator = Indicator::band, options.width = 0.5, options.level = 0.2, options.alpha = 3;
        expect_values(
            *derived_monitor(waves(), options, on(kind)), x,
            [&](Vec3 p) {
                const double u = std::sin(wave * p.x) * std::cos(wave * p.y);
                return 1 + 3 / std::cosh((u - 0.2) / 0.5);
            },
            1e-6);
    }
}

// The surface Hessian of z is -z / R^2 times the metric.
TEST(Derived, HasGradientAndHessianOfTheSphere) {
    const auto at = [](Indicator indicator) {
        return derived_monitor(height(), bare(indicator), on(SpaceKind::sphere));
    };
    const Points x = sphere_points(1);
    expect_values(
        *at(Indicator::arc_length), x, [](Vec3 p) { return std::sqrt(1 + (1 - p.z * p.z) / 4); }, 1e-8);
    expect_values(
        *at(Indicator::curvature), x, [](Vec3 p) { return std::cbrt(1 + p.z * p.z / 2); }, 1e-8);
}

TEST(Derived, HasTheGradientsOfItsValues) {
    for (const SpaceKind kind : {SpaceKind::periodic_square, SpaceKind::euclidean, SpaceKind::sphere}) {
        const bool sphere = kind == SpaceKind::sphere;
        const auto monitor = derived_monitor(sphere ? height() : waves(), {}, on(kind));
        Points x(100);
        const Points all = sphere ? sphere_points(1) : square_points();
        for (std::size_t i = 0; i < x.size(); ++i) x.set(i, all[7 * i + 3]);
        expect_gradients_of_values(*monitor, on(kind).space, x, 1e-6);
    }
}

TEST(Derived, KeepsTheAverageThroughItsStages) {
    for (const double width : {0.1, 0.01, 0.001})
        for (const double fraction : {0.25, 0.5, 0.8}) {
            DerivedOptions options;
            options.fraction = fraction;
            options.contrast = 1e6; // less would take cells from the thinnest layer
            const auto monitor = derived_monitor(layer(width), options, on(SpaceKind::euclidean));
            Points x(200 * 200);
            for (std::size_t i = 0; i < x.size(); ++i)
                x.set(i, {(static_cast<double>(i % 200) + 0.5) / 200,
                          (static_cast<double>(i / 200) + 0.5) / 200, 0});
            double mean = 0, least = std::numeric_limits<double>::infinity();
            for (const double m : values_of(*monitor, x)) {
                mean += m / static_cast<double>(x.size());
                least = std::min(least, m);
            }
            EXPECT_NEAR(1 / mean, 1 - fraction, 0.01) << width; // m = 1 away from the layer
            EXPECT_NEAR(least, 1, 0.01);
            EXPECT_EQ(monitor->report().notes.empty(), width == 0.1) << width;
        }
}

TEST(Derived, SaysWhatTheLimitChanges) {
    DerivedOptions options;
    options.fraction = 0.8, options.contrast = 100;
    const auto notes = derived_monitor(layer(0.001), options, on(SpaceKind::euclidean))->report().notes;
    ASSERT_FALSE(notes.empty());
    EXPECT_TRUE(notes.front().starts_with(
        "The limit changes the fraction of cells that go to the feature from 0.8 to 0."))
        << notes.front();
}

TEST(Derived, SaysIfTheMostSmoothingIsNotEnough) {
    DerivedOptions options;
    options.fraction = 0.9999, options.contrast = 1e6, options.floor = 0;
    const auto context = on(SpaceKind::euclidean);
    const auto edge = std::make_shared<Exact>([](Vec3 p) { return std::tanh(p.x / 0.01); },
                                              [](Vec3 p) {
                                                  const double s = 1 / std::cosh(p.x / 0.01);
                                                  return Vec3{s * s / 0.01, 0, 0};
                                              });
    const auto last_note = [&] {
        const auto notes = derived_monitor(edge, options, context)->report().notes;
        return notes.empty() ? std::string("none") : notes.back();
    };
    EXPECT_EQ(
        last_note(),
        "The monitor is smoothed over 8 cells of the uniform mesh, and the mesh may not follow it even so: "
        "more cells, or a smaller contrast, would help.");
    options.smoothing = 1;
    EXPECT_EQ(last_note(),
              "The mesh may not follow the monitor, which is smoothed over 1 cell: more cells, or a smaller "
              "contrast, would help.");
}

TEST(Derived, KeepsToFloorAndContrast) {
    const DomainGrid domain = domain_grid(on(SpaceKind::euclidean), 1);
    std::vector<double> m(domain.x.size());
    for (std::size_t i = 0; i < m.size(); ++i) m[i] = std::pow(10.0, 4 * domain.x.x[i]) - 1;
    const double mean = domain.mean(m);
    limit_stage(domain, m, 0.1, 30);
    EXPECT_GE(domain.least(m), 0.099 * mean);
    EXPECT_LE(domain.largest(m), 30 * domain.least(m) * (1 + 1e-12));
    std::vector<double> flat(domain.x.size(), 2.5);
    limit_stage(domain, flat, 0.01, 1000);
    EXPECT_NEAR(flat[0], 2.5, 1e-7);
}

TEST(Derived, RefusesWhatGivesNoMonitor) {
    const auto of = [](double value) {
        return std::make_shared<Exact>([=](Vec3) { return value; }, [](Vec3) { return Vec3{}; });
    };
    const auto context = on(SpaceKind::euclidean);
    EXPECT_THROW(derived_monitor(nullptr, {}, context), InputError);
    EXPECT_THROW(derived_monitor(of(std::nan("")), {}, context), InputError);
    const auto half_flat =
        std::make_shared<Exact>([](Vec3 p) { return std::pow(std::max(p.x - 0.5, 0.0), 2); },
                                [](Vec3 p) {
                                    return Vec3{2 * std::max(p.x - 0.5, 0.0), 0, 0};
                                });
    EXPECT_THROW(derived_monitor(half_flat, bare(Indicator::gradient), context), InputError);
    DerivedOptions options;
    options.fraction = 1;
    EXPECT_THROW(derived_monitor(waves(), options, context), InputError);
    const auto uniform = derived_monitor(of(3), {}, context);
    EXPECT_EQ(uniform->report().notes, std::vector<std::string>{"u is constant on the domain."});
    for (const double m : values_of(*uniform, square_points())) EXPECT_NEAR(m, 1, 1e-8);
}

TEST(Derived, HasNoValueWhereThePointHasNone) { // an iteration that diverges
    const auto monitor = derived_monitor(waves(), {}, on(SpaceKind::periodic_square));
    Points x(2);
    x.set(0, {std::nan(""), 0.5, 0}), x.set(1, {0.5, std::numeric_limits<double>::infinity(), 0});
    for (const double m : values_of(*monitor, x)) EXPECT_TRUE(std::isnan(m));
}

TEST(Derived, DoesNotDependOnTheUnitOfU) {
    const auto times = [](double unit) {
        return std::make_shared<Exact>(
            [=](Vec3 p) { return unit * (std::sin(wave * p.x) * std::cos(wave * p.y)); },
            [=](Vec3 p) {
                return unit * Vec3{wave * std::cos(wave * p.x) * std::cos(wave * p.y),
                                   -wave * std::sin(wave * p.x) * std::sin(wave * p.y), 0};
            });
    };
    const Points x = square_points();
    for (const Indicator indicator : {Indicator::arc_length, Indicator::curvature, Indicator::gradient,
                                      Indicator::magnitude, Indicator::band}) {
        DerivedOptions options;
        options.indicator = indicator;
        const auto m = [&](double unit) {
            return values_of(*derived_monitor(times(unit), options, on(SpaceKind::periodic_square)), x);
        };
        const auto expected = m(1);
        EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 1.1);
        for (const double unit : {0x1p-990, 0x1p-660, 0x1p660, 0x1p1000}) {
            const auto found = m(unit);
            for (std::size_t i = 0; i < x.size(); ++i) ASSERT_NEAR(found[i] / expected[i], 1, 1e-12) << unit;
        }
    }
}

TEST(Derived, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    MonitorContext context = on(SpaceKind::euclidean);
    context.stop = stop.get_token();
    EXPECT_THROW(derived_monitor(waves(), {}, context), Interrupted);
}

class DerivedScenario : public testing::Test {
  protected:
    Scenario scenario(const std::string& name, const std::vector<std::string>& settings = {}) const {
        Scenario found = find_scenario(*catalogue, name);
        apply_settings(*catalogue, found, settings);
        return found;
    }
    /// Of the cells of a solved mesh, the part that goes to what is above the least value of m.
    static double fraction_of(const Snapshot& snapshot) {
        const std::size_t cells = snapshot.mesh->cell_count();
        double sum = 0;
        const Field& monitor = *snapshot.field("monitor");
        for (std::size_t cell = 0; cell < cells; ++cell) {
            double mean = 0;
            const auto nodes = snapshot.mesh->cell(cell);
            for (const auto node : nodes) mean += 1 / monitor.values[static_cast<std::size_t>(node)];
            sum += 1 - mean / static_cast<double>(nodes.size());
        }
        return sum / static_cast<double>(cells);
    }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<Catalogue>(builtin_catalogue());
};

TEST_F(DerivedScenario, ConvergesAndKeepsItsPromise) {
    for (const char* name : {"walls-front", "plane-curvature", "sphere-front", "spline-level"})
        for (const double fraction : {0.3, 0.6}) {
            if (sanitized && fraction < 0.5) continue;
            gaspard::Run run(catalogue, scenario(name, {"monitor.fraction=" + format_number(fraction)}));
            const StepReport& last = run.solve();
            EXPECT_EQ(last.status, RunStatus::converged) << name;
            EXPECT_EQ(last.tangled_cells, 0u) << name;
            EXPECT_NEAR(fraction_of(*run.snapshot()), fraction, 0.03) << name;
        }
}

/// The average of a function of the parameters over a surface, by the midpoint rule.
double average_on(const PatchParameters& patch, const std::function<double(Vec3)>& f) {
    constexpr int count = 100;
    Points uv(count * count), first, second;
    for (std::size_t i = 0; i < uv.size(); ++i)
        uv.set(i, {(static_cast<double>(i % count) + 0.5) / count,
                   (static_cast<double>(i / count) + 0.5) / count, 0});
    patch.tangents(uv, first, second);
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < uv.size(); ++i) {
        const double part = norm(cross(first[i], second[i]));
        sum += part * f(uv[i]), area += part;
    }
    return sum / area;
}

TEST_F(DerivedScenario, HasTheAveragesOfPatches) {
    for (const char* name : {"spline-level", "spline-torus", "spline-sine-waves"}) {
        const gaspard::Run run(catalogue, scenario(name, {"domain.cells=32"}));
        const DataContext there{.space = run.space(), .discretisation = &run.discretisation()};
        const auto patch = run.discretisation().parameters();
        const auto of_u = [](Vec3 uv) { return uv.x * uv.x; };
        const auto square = std::make_shared<Exact>(
            [&](Vec3 p) {
                Points at(1), uv;
                at.set(0, p);
                patch->find(at, uv);
                return of_u({std::clamp(uv.x[0], 0.0, 1.0), 0, 0});
            },
            [](Vec3) { return Vec3{}; });
        DerivedOptions options = bare(Indicator::magnitude);
        options.average = true, options.fraction = 0.6;
        const auto monitor = derived_monitor(square, options, there);
        const double average = average_on(*patch, of_u);
        Points uv(3), x;
        uv.set(0, {0.3, 0.4, 0}), uv.set(1, {0.5, 0.7, 0}), uv.set(2, {0.8, 0.2, 0});
        patch->points(uv, x);
        const auto m = values_of(*monitor, x);
        for (std::size_t i = 0; i < x.size(); ++i)
            EXPECT_NEAR(m[i], 1 + 1.5 * of_u(uv[i]) / average, 4e-3 * m[i]) << name;
    }
}

TEST_F(DerivedScenario, FollowsThinLayers) {
    for (const char* name : {"walls-front", "plane-curvature"}) {
        gaspard::Run run(catalogue,
                         scenario(name, {std::string("monitor.u.w=") +
                                             (std::string(name) == "walls-front" ? "0.001" : "0.002"),
                                         "method.tolerance=1e-6"}));
        EXPECT_EQ(run.solve().status, RunStatus::converged) << name;
        const auto report = run.snapshot()->monitor_report;
        ASSERT_NE(report, nullptr);
        ASSERT_FALSE(report->notes.empty());
        EXPECT_NE(report->notes.back().find("cells of the uniform mesh, so that the mesh can follow it"),
                  std::string::npos);
    }
}

TEST_F(DerivedScenario, ShowsItsStages) {
    gaspard::Run run(catalogue, scenario("walls-front", {"domain.cells=12", "view.color=limited"}));
    const auto snapshot = run.snapshot();
    for (const FieldInfo& info : catalogue->monitor("derived").fields) {
        const Field* field = snapshot->field(info.name);
        ASSERT_NE(field, nullptr) << info.name;
        EXPECT_EQ(field->values.size(), snapshot->x.size());
    }
    EXPECT_LT(*std::min_element(snapshot->field("u")->values.begin(), snapshot->field("u")->values.end()),
              -1);
}

TEST_F(DerivedScenario, MeasuresTheInterpolationErrorOfU) {
    gaspard::Run run(catalogue, scenario("walls-front", {"domain.cells=12"}));
    const auto snapshot = run.snapshot();
    std::vector<double> u(snapshot->x.size());
    run.solution()->values(snapshot->x, u);
    const Field* field = snapshot->field("u");
    ASSERT_NE(field, nullptr);
    EXPECT_EQ(u, field->values);
}

TEST_F(DerivedScenario, HasTheRowsOfItsIndicatorAndOfU) {
    Scenario found = scenario("walls-front", {"monitor.kind=band", "monitor.level=0.25",
                                              "monitor.u.expression=a*x+y", "monitor.u.a=3"});
    EXPECT_EQ(found.monitor.values.real("u.a"), 3);
    EXPECT_FALSE(found.monitor.values.has("order"));
    EXPECT_FALSE(found.monitor.values.has("u.w"));
    EXPECT_EQ(parse_scenario(*catalogue, to_toml(found), "walls-front.toml").monitor, found.monitor);
    EXPECT_THROW(apply_settings(*catalogue, found, {"monitor.order=2"}), InputError);
}

} // namespace
} // namespace gaspard
