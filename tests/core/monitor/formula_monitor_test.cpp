// Monitors from typed formulas: beside the built-in monitors of the same equation, their periods, their rows.
#include "core/monitor/formula_monitor.hpp"
#include "core/monitor/placement.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/built_in.hpp"
#include "support/largest_distance.hpp"
#include "support/messages.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace gaspard {
namespace {

const Space square{SpaceKind::euclidean}, periodic_square{SpaceKind::periodic_square},
    unit_sphere{SpaceKind::sphere};

Points random_points(const Space& space, std::size_t count, double radius = 1) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(0, 1);
    Points points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 p{normal(random), normal(random), normal(random)};
        points.set(i, space.kind == SpaceKind::sphere ? (radius / norm(p)) * p
                                                      : Vec3{unit(random), unit(random), 0});
    }
    return points;
}

double largest(const std::vector<double>& values) {
    double size = 0;
    for (const double one : values) size = std::max(size, std::abs(one));
    return size;
}

double largest_norm(const Points& points) {
    double size = 0;
    for (std::size_t i = 0; i < points.size(); ++i) size = std::max(size, norm(points[i]));
    return size;
}

/// Values and gradients of a built-in monitor and of its formula, relative to the largest.
/// `creases`: the part of the points at which gradients may differ, since m has a crease near them.
void expect_same(const std::string& type, const Space& space, double radius = 1, double creases = 0) {
    const auto built_in = make_monitor(type, space);
    Values values("monitor", monitor_type(type).rows(space));
    std::map<std::string, double> parameters;
    const std::string text = monitor_type(type).formula(space);
    for (const auto& name : check_formula(text, space)) parameters[name] = values.real(name);
    const auto typed = formula_monitor(text, {.space = space, .parameters = parameters});
    EXPECT_NO_THROW(typed->check());
    const Points x = random_points(space, 3000, radius);
    std::vector<double> m(x.size()), f(x.size());
    built_in->values(x, m);
    typed->values(x, f);
    Points slope, difference;
    built_in->gradients(x, slope);
    typed->gradients(x, difference);
    for (std::size_t i = 0; i < x.size(); ++i) f[i] -= m[i];
    EXPECT_LT(largest(f), 1e-13 * largest(m)) << type;
    const Points error = slope - difference;
    const double allowed = 1e-8 * largest_norm(slope) + 1e-15;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (!(norm(error[i]) <= allowed)) ++wrong;
    EXPECT_LE(static_cast<double>(wrong), creases * static_cast<double>(x.size())) << type;
}

TEST(FormulaMonitor, AgreesWithTheBuiltInMonitors) {
    for (const char* type : {"ring", "bell", "ring-and-bell"}) {
        expect_same(type, periodic_square);
        expect_same(type, square);
        expect_same(type, unit_sphere);
        expect_same(type, unit_sphere, 6371);
    }
    for (const char* type : {"x-n", "cross"}) expect_same(type, unit_sphere);
    for (const char* type : {"spiral", "cosine-waves"}) expect_same(type, square);
    for (const char* type : {"circle", "three-circles", "two-circles", "sine-waves"})
        expect_same(type, square, 1, 1e-3);
    for (const Space& space : {periodic_square, square, unit_sphere}) expect_same("constant", space);
}

TEST(FormulaMonitor, HasGradientsOfSharpFeaturesAndOfLargeDomains) {
    Points box(2);
    box.set(1, {5e5, 3e5, 0});
    const auto far = formula_monitor("1 + 10*exp(-(dist(2e5, 1e5)/a)^2)",
                                     {.space = square, .parameters = {{"a", 4e4}}, .sample = box});
    Points x(1), gradient;
    x.set(0, {2.3e5, 1.1e5, 0});
    far->gradients(x, gradient);
    const double slope = -2 * 3e4 / 1.6e9 * 10 * std::exp(-(9e8 + 1e8) / 1.6e9);
    EXPECT_NEAR(gradient.x[0], slope, 1e-8 * std::abs(slope));
    EXPECT_NEAR(gradient.y[0], slope / 3, 1e-8 * std::abs(slope));
    const auto sharp = formula_monitor("1 + 50*sech(2000*dist(0.3, 0.6)^2)^2");
    x.set(0, {0.31, 0.61, 0});
    sharp->gradients(x, gradient);
    const double t = 2000 * 2e-4, value = -2 * 50 * std::tanh(t) / std::pow(std::cosh(t), 2) * 4000 * 0.01;
    EXPECT_NEAR(gradient.x[0], value, 1e-8 * std::abs(value));
}

TEST(FormulaMonitor, HasGradientsOfAThinFeatureFarFromTheOrigin) {
    Points sample(900);
    for (std::size_t i = 0; i < sample.size(); ++i)
        sample.set(i, {1e6 + static_cast<double>(i % 30) * 300, 1e6 + static_cast<double>(i / 30) * 300, 0});
    const auto thin = formula_monitor("2 + tanh((x - 1004500)/100)", {.space = square, .sample = sample});
    Points x(1), gradient;
    x.set(0, {1004500 + 78.125, 1e6, 0});
    thin->gradients(x, gradient);
    const double slope = 0.01 / std::pow(std::cosh(0.78125), 2);
    EXPECT_NEAR(gradient.x[0], slope, 1e-8 * 0.01);
    EXPECT_EQ(gradient.y[0], 0);
}

double formula_at(const Monitor& monitor, Vec3 p) {
    Points x(1);
    x.set(0, p);
    double value = 0;
    monitor.values(x, {&value, 1});
    return value;
}

TEST(FormulaMonitor, IsRepeatedOnThePeriodicSquare) {
    const auto plain = formula_monitor("1 + x + 10*y");
    EXPECT_DOUBLE_EQ(formula_at(*plain, {0.25, 0.5, 0}), 6.25);
    EXPECT_DOUBLE_EQ(formula_at(*plain, {1.25, -0.5, 0}), 6.25);
    EXPECT_DOUBLE_EQ(formula_at(*plain, {1, 0, 0}), 1) << "the right side is the left one";
    const auto moved = formula_monitor("10 + x + y", {.centre = {0, 1, 0}});
    EXPECT_DOUBLE_EQ(formula_at(*moved, {0.75, 0.25, 0}), 10 - 0.25 + 1.25);
    Points x(1), gradient;
    x.set(0, {1e-9, 0.5, 0});
    plain->gradients(x, gradient);
    EXPECT_NEAR(gradient.x[0], 1, 1e-8) << "differences do not see the jump";
}

TEST(FormulaMonitor, MeasuresTheJumpOfAFormulaThatIsNotPeriodic) {
    const auto jump = [](const std::string& text, Vec3 centre = {0.5, 0.5, 0}) {
        return formula_function(text, {.centre = centre})->jump();
    };
    EXPECT_NEAR(jump("1 + x").relative, 0.5, 1e-12);
    EXPECT_EQ(jump("1 + x").at.x, 0);
    EXPECT_LT(jump("2 + cos(2*pi*x)*sin(4*pi*y)").relative, 1e-12);
    EXPECT_LT(jump("1 + exp(-9*dist(0.9, 0.1)^2)").relative, 1e-12) << "dist takes the nearest image";
    EXPECT_GT(jump("1 + exp(-9*((x - 0.9)^2 + y^2))").relative, 0.4);
    EXPECT_LT(jump("1 + exp(-9*((x - 0.9)^2 + y^2))", {0.9, 0, 0}).relative, 1e-12);
}

TEST(FormulaMonitor, NamesTheFirstPointWhereItIsNotPositive) {
    const auto negative = formula_monitor("x - 0.5");
    Points x(2);
    x.set(0, {0.75, 0, 0});
    x.set(1, {0.25, 0.125, 0});
    std::vector<double> values(2);
    EXPECT_EQ(message_of<InputError>([&] { negative->values(x, values); }),
              "the formula must be positive and finite, but is −0.25 at (0.25, 0.125); max(..., 0.01) around "
              "it makes it positive");
    EXPECT_EQ(message_of<InputError>([&] {
                  formula_monitor("(x - 0.25)/abs(x - 0.25) + 2*sqrt(x - 0.25)")->values(x, values);
              }).substr(0, 53),
              "the formula must be positive and finite, but is NaN a");
    EXPECT_EQ(message_of<InputError>([] { formula_monitor("1 + a*x"); }),
              "the formula's parameter 'a' has no value");
    EXPECT_EQ(message_of<InputError>([] {
                  formula_monitor("1 + amp*x", {.parameters = {{"amp", 1}, {"amq", 2}}});
              }),
              "the formula has no parameter 'amq' (did you mean 'amp'?)");
}

class TypedFormula : public testing::Test {
  protected:
    Scenario with(const std::vector<std::string>& settings, const std::string& name = "plane-ring") {
        Scenario scenario = find_scenario(*catalogue, name);
        apply_settings(*catalogue, scenario, settings);
        return scenario;
    }
    const ParameterRow& row(const Scenario& scenario, const std::string& key) {
        for (const auto& one : scenario.monitor.values.rows())
            if (one.key == key) return one;
        throw InputError("no row " + key);
    }
    std::string complaint(const std::vector<std::string>& settings) {
        return message_of<InputError>([&] { with(settings); });
    }
    const std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(TypedFormula, HasARowForEveryParameter) {
    const Scenario scenario =
        with({"monitor.a=40", "monitor.type=formula", "monitor.expression=1 + a*exp(-b*dist(x0, y0)^2)",
              "monitor.ranges=b 1 400 log"});
    EXPECT_EQ(scenario.monitor.values.real("a"), 40);
    EXPECT_EQ(row(scenario, "a").slider, (SliderRange{0, 10})) << "guessed";
    EXPECT_EQ(row(scenario, "x0").slider, std::nullopt) << "the whole range";
    EXPECT_EQ(row(scenario, "b").maximum, 400);
    EXPECT_EQ(row(scenario, "b").scale, ParameterScale::logarithmic);
    EXPECT_EQ(row(scenario, "x0").role, ParameterRole::x);
    EXPECT_EQ(row(scenario, "y0").point, row(scenario, "x0").point);
    EXPECT_EQ(parse_scenario(*catalogue, to_toml(scenario), "plane-ring.toml"), [&] {
        Scenario same = scenario;
        same.folder.clear();
        return same;
    }());
    Scenario changed = scenario;
    set_value(*catalogue, changed, "monitor.expression", std::string("2 + a*x"));
    EXPECT_EQ(changed.monitor.values.real("a"), 40) << "kept";
    EXPECT_FALSE(changed.monitor.values.has("b")) << changed.monitor.values.text("ranges");
}

TEST_F(TypedFormula, RefusesWrongFormulasAndRanges) {
    const auto wrong = [&](const std::string& formula) {
        return complaint({"monitor.type=formula", "monitor.expression=" + formula});
    };
    EXPECT_EQ(wrong("1 + sine(x)"),
              "monitor.expression: unknown function 'sine' at character 5 (did you mean 'sin'?)");
    EXPECT_EQ(wrong("1 + type"),
              "monitor.expression: a parameter cannot be named 'type', which is a key of the "
              "monitor");
    const auto ranges = [&](const std::string& text) {
        return complaint(
            {"monitor.type=formula", "monitor.expression=1 + amp*x^2", "monitor.ranges=" + text});
    };
    EXPECT_NE(ranges("amp 0 1 lin").find("'amp 0 1 lin' is not a range; write"), std::string::npos);
    for (const char* bad : {"amp", "amp 1 0", "amp 0 1e999", "amp 0 nan", "amp 0 1,", "amp 0 1, amp 0 2"})
        EXPECT_NE(ranges(bad), "") << bad;
}

TEST_F(TypedFormula, GivesTheMeshesOfTheBuiltInMonitors) {
    const auto compare = [&](const std::string& name, const std::vector<std::string>& settings) {
        const Scenario scenario = with(settings, name);
        const auto typed = with_formula(*catalogue, scenario);
        ASSERT_TRUE(typed) << name;
        EXPECT_EQ(typed->monitor.type, "formula");
        for (const auto& one : scenario.monitor.values.rows())
            EXPECT_EQ(typed->monitor.values.real(one.key), scenario.monitor.values.real(one.key)) << one.key;
        gaspard::Run a(catalogue, scenario), b(catalogue, *typed);
        a.solve();
        b.solve();
        EXPECT_EQ(a.status(), RunStatus::converged) << name;
        EXPECT_EQ(b.status(), RunStatus::converged) << name;
        EXPECT_NEAR(a.history().back().iteration, b.history().back().iteration, 1) << name;
        const auto at_a = a.snapshot(), at_b = b.snapshot();
        EXPECT_LT(largest_distance(at_a->x, at_b->x), 1e-10) << name;
    };
    for (const char* method : {"method.type=auto", "method.type=newton", "method.type=accelerated"}) {
        compare("plane-ring", {"domain.cells=24", method});
        compare("plane-bell", {"domain.cells=24", method});
        compare("walls-ring", {"domain.cells=24", method});
    }
    compare("plane-ring", {"domain.cells=24", "method.type=auto", "monitor.center_x=0.9"});
    for (const char* name : {"sphere-x2", "sphere-x4", "sphere-x8", "sphere-x16", "sphere-cross"})
        compare(name, {"domain.type=cubed-sphere", "domain.cells=8", "method.type=auto"});
    compare("spline-spiral", {"domain.cells=32", "method.type=auto", "monitor.sharpness=5",
                              "monitor.amplitude=4", "monitor.winding=8"});
    compare("spline-patch", {"domain.cells=12", "method.type=auto", "monitor.type=ring",
                             "monitor.sharpness=20", "monitor.amplitude=3"});
}

TEST_F(TypedFormula, NotesAJumpAndWrapsIt) {
    const std::vector<std::string> bump = {"domain.cells=16", "method.type=auto", "monitor.type=formula",
                                           "monitor.expression=1 + 5*exp(-20*((x - 0.9)^2 + (y - 0.5)^2))"};
    const gaspard::Run run(catalogue, with(bump));
    ASSERT_EQ(run.monitor_report()->notes.size(), 1U);
    EXPECT_EQ(
        run.monitor_report()->notes[0],
        "The formula is not periodic: it jumps by up to 80 % of its largest value across the sides, at "
        "(0, 0.498046875). A mesh may not follow it. Set monitor.wrap = \"center\", "
        "monitor.wrap_x = 0.88 and monitor.wrap_y = 0.5 to measure distances from a point to its nearest "
        "image, or domain.boundary = \"walls\".");
    std::vector<std::string> wrapped = bump;
    wrapped.insert(wrapped.end(), {"monitor.wrap=center", "monitor.wrap_x=0.9"});
    gaspard::Run there(catalogue, with(wrapped));
    EXPECT_TRUE(there.monitor_report()->notes.empty());
    EXPECT_EQ(there.solve().status, RunStatus::converged);
}

// What most people type first.
TEST_F(TypedFormula, SaysInTheEndWhatToDoAboutAJump) {
    const std::vector<std::string> corner = {"monitor.expression=1 + 10*exp(-50*(x^2+y^2))",
                                             "method.max_iterations=300"};
    gaspard::Run run(catalogue, with(corner, "plane-formula"));
    const StepReport& last = run.solve();
    EXPECT_NE(last.status, RunStatus::converged);
    EXPECT_NE(last.note.find("the formula jumps across the sides: set monitor.wrap = \"center\", "
                             "monitor.wrap_x = 0 and monitor.wrap_y = 0 to measure"),
              std::string::npos)
        << last.note;
    std::vector<std::string> wrapped = corner;
    wrapped.insert(wrapped.end(), {"monitor.wrap=center", "monitor.wrap_x=0", "monitor.wrap_y=0"});
    gaspard::Run there(catalogue, with(wrapped, "plane-formula"));
    EXPECT_EQ(there.solve().status, RunStatus::converged);
}

TEST_F(TypedFormula, NotesRangesOfNamesThatItDoesNotHave) {
    const gaspard::Run run(
        catalogue, with({"domain.cells=8", "monitor.type=formula", "monitor.expression=1 + amp*cos(2*pi*x)^2",
                         "monitor.ranges=amp 0 1, amq 0 2"}));
    ASSERT_EQ(run.monitor_report()->notes.size(), 1U);
    EXPECT_EQ(run.monitor_report()->notes[0],
              "monitor.ranges has a range for 'amq', which is no parameter of "
              "the formula (did you mean 'amp'?).");
}

TEST_F(TypedFormula, IsRefusedWhereItIsNotPositiveUnlessItHasAFloor) {
    std::vector<std::string> settings = {"domain.cells=16", "method.type=auto", "monitor.type=formula",
                                         "monitor.expression=sin(2*pi*x)"};
    EXPECT_EQ(message_of<InputError>([&] { gaspard::Run(catalogue, with(settings)); }),
              "the formula must be positive and finite, but is 0 at (0, 0); set monitor.floor to a positive "
              "number");
    settings.push_back("monitor.floor=0.3");
    gaspard::Run run(catalogue, with(settings));
    EXPECT_EQ(run.solve().status, RunStatus::converged);
}

// The equation does not change with the unit of a monitor, but floating-point numbers end.
TEST_F(TypedFormula, IsScaledToAUnit) {
    const auto solved = [&](const std::string& formula) {
        gaspard::Run run(catalogue, with({"domain.cells=16", "method.type=auto", "monitor.type=formula",
                                          "monitor.expression=" + formula}));
        EXPECT_EQ(run.solve().status, RunStatus::converged) << formula;
        return run.snapshot()->x;
    };
    const Points expected = solved("1 + 5*cos(2*pi*x)^2");
    for (const char* unit : {"1e-160", "1e-300", "1e160", "1e300"}) {
        const Points found = solved(unit + std::string("*(1 + 5*cos(2*pi*x)^2)"));
        EXPECT_LT(largest_distance(expected, found), 1e-8) << unit;
    }
}

TEST_F(TypedFormula, ScenariosOfPlaneSphereAndSurfaceConverge) {
    for (const auto& [name, cells] :
         {std::pair("plane-formula", "domain.cells=24"), std::pair("sphere-formula", "domain.cells=12"),
          std::pair("spline-formula", "domain.cells=12")}) {
        gaspard::Run run(catalogue, with({cells}, name));
        const StepReport& last = run.solve();
        EXPECT_EQ(last.status, RunStatus::converged) << name;
        EXPECT_EQ(last.tangled_cells.value_or(0), 0U) << name;
    }
}

TEST_F(TypedFormula, HasGradientsInTheParametersOfASurface) {
    const gaspard::Run run(catalogue, with({"domain.cells=8"}, "spline-formula"));
    const auto patch = run.discretisation().parameters();
    ASSERT_NE(patch, nullptr);
    const auto monitor =
        formula_monitor("2 + sin(3*u)*cos(2*v) + 0.1*x*z",
                        {.space = run.space(), .patch = patch, .sample = run.discretisation().mesh()->nodes});
    const Points uv = random_points(square, 300);
    Points x, first, second, gradients;
    patch->points(uv, x);
    patch->tangents(uv, first, second);
    monitor->gradients(x, gradients);
    for (std::size_t i = 0; i < uv.size(); ++i) { // the chain rule, along both tangents
        const double u = uv.x[i], v = uv.y[i];
        const Vec3 in_space{0.1 * x.z[i], 0, 0.1 * x.x[i]};
        EXPECT_NEAR(dot(gradients[i], first[i]),
                    3 * std::cos(3 * u) * std::cos(2 * v) + dot(in_space, first[i]), 1e-8);
        EXPECT_NEAR(dot(gradients[i], second[i]),
                    -2 * std::sin(3 * u) * std::sin(2 * v) + dot(in_space, second[i]), 1e-8);
    }
    EXPECT_THROW(formula_monitor("1 + u", {.space = run.space()}), InputError) << "without the patch";
}

TEST_F(TypedFormula, PlacesTheConstantsOfAFigureOnAPatchOfAnySize) {
    const Space unit{SpaceKind::euclidean};
    Space placed = unit;
    placed.box = Box{{10, 20, 0}, {14, 24, 0}};
    placed.middle = placed.box->centre();
    for (const char* type : {"three-circles", "two-circles", "sine-waves", "circle", "spiral"}) {
        const MonitorType row = monitor_type(type);
        const Values values("monitor", rows_on(row, placed));
        const auto built_in = make_on(row, values, {.space = placed});
        const std::string text = row.formula(placed);
        FormulaOptions options{.space = placed};
        for (const auto& name : check_formula(text, placed)) options.parameters[name] = values.real(name);
        const auto typed = formula_monitor(text, options);
        for (const Vec3 p : {Vec3{10.5, 21, 0}, Vec3{12.3, 22.2, 0}, Vec3{13.9, 20.1, 0}})
            EXPECT_NEAR(formula_at(*typed, p), formula_at(*built_in, p), 1e-11 * formula_at(*built_in, p))
                << type;
    }
}

} // namespace
} // namespace gaspard
