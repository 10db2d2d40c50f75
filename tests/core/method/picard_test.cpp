// Picard's and Newton's method on patches: what must hold whatever the mesh.
#include "core/base/error.hpp"
#include "core/io/history_file.hpp"
#include "core/method/manufactured.hpp"
#include "core/method/spline_equation.hpp"
#include "core/method/spline_map.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/spline/patch_file.hpp"
#include "core/spline/spline_domain.hpp"
#include "support/built_in.hpp"
#include "support/largest_distance.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <tuple>

namespace gaspard {
namespace {

std::shared_ptr<const Catalogue> catalogue() {
    static const auto all = std::make_shared<const Catalogue>(builtin_catalogue());
    return all;
}

Scenario scenario(const std::string& name, const std::vector<std::string>& settings) {
    Scenario chosen = find_scenario(*catalogue(), name);
    apply_settings(*catalogue(), chosen, settings);
    return chosen;
}

std::vector<std::string> spline_domain_names() {
    std::vector<std::string> names;
    for (const auto& domain : spline_domains()) names.push_back(domain.name);
    return names;
}

std::string safe(std::string name) {
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

class Patches : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, Patches, testing::ValuesIn(spline_domain_names()),
                         [](const auto& name) { return safe(name.param); });

TEST_P(Patches, AConstantMonitorMovesNothingToRounding) {
    for (const std::string method : {"picard", "picard-mixed", "newton"})
        for (const std::string degree : {"2", "3", "7"}) {
            gaspard::Run run(catalogue(),
                             scenario("plane-ring", {"domain.type=" + GetParam(), "domain.cells=8",
                                                     "domain.degree=" + degree, "monitor.type=constant",
                                                     "monitor.value=3", "method.type=" + method}));
            const auto before = run.snapshot();
            if (run.status() == RunStatus::running) run.step(); // which it may be spared
            EXPECT_LT(run.history().back().residual, 1e-12);
            EXPECT_LT(largest_distance(run.snapshot()->x, before->mesh->nodes), 1e-12) << method << degree;
            EXPECT_NEAR(*run.history().back().value("theta"), 3, 1e-13);
        }
}

TEST_P(Patches, TheMixedMethodKeepsTheBorderExactly) {
    gaspard::Run run(
        catalogue(),
        scenario("plane-ring", {"domain.type=" + GetParam(), "domain.cells=8", "monitor.type=two-circles",
                                "method.type=picard-mixed", "method.max_iterations=20"}));
    run.solve();
    // Where x = F(psi) is at the border, psi is on a side: F of the side's own line.
    Values values("domain", domain_section(*catalogue(), GetParam()).values.rows());
    values.set("cells", std::int64_t{8});
    const auto domain = make_spline_domain(GetParam(), values);
    const Points x = run.snapshot()->x;
    constexpr std::size_t side = 25; // cells of order 3
    for (const bool upper : {false, true}) {
        Points line(2001), on_side;
        for (std::size_t i = 0; i < line.size(); ++i) line.set(i, {upper ? 1.0 : 0.0, i / 2000.0, 0});
        domain->patch_map()->points(line, on_side);
        for (std::size_t j = 0; j < side; ++j) {
            const Vec3 p = x[j * side + (upper ? side - 1 : 0)];
            double nearest = 1;
            for (std::size_t i = 0; i + 1 < on_side.size(); ++i) { // to the chords of the side
                const Vec3 a = on_side[i], d = on_side[i + 1] - a;
                const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
                nearest = std::min(nearest, norm(p - a - t * d));
            }
            EXPECT_LT(nearest, 3e-6); // of a chord of the longest side
        }
    }
    EXPECT_LT(*run.history().back().value("border_error"), 1e-14);
}

TEST(PicardMixed, KeepsTheSquaresSidesToTheLastBit) {
    gaspard::Run run(catalogue(), scenario("spline-spiral", {"domain.cells=16", "method.max_iterations=15"}));
    run.solve();
    const Points x = run.snapshot()->x;
    constexpr std::size_t side = 49; // cells of order 3
    for (std::size_t k = 0; k < side; ++k) {
        EXPECT_EQ(x.x[k * side], 0);
        EXPECT_EQ(x.x[k * side + side - 1], 1);
        EXPECT_EQ(x.y[k], 0);
        EXPECT_EQ(x.y[(side - 1) * side + k], 1);
    }
}

TEST(PatchFiles, MayChangeUnderTheirMesh) {
    // A control point moves: the map of the square is the start for the new patch.
    SplinePatch patch = nurbs_disk();
    const auto with_patch = [&] {
        Scenario chosen = scenario("spline-two-circles", {"domain.type=spline-patch", "domain.cells=16"});
        chosen.domain.values.set("file", patch_json(patch));
        return chosen;
    };
    gaspard::Run run(catalogue(), with_patch());
    run.solve();
    const int first = run.history().back().iteration;
    patch.control.set(4, {0.05, -0.02, 0});
    EXPECT_EQ(run.change(with_patch()), "");
    EXPECT_LT(run.history().back().residual, 1e-2);
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_LT(run.history().back().iteration - first, first);
}

// ---- the equation, and Newton's method

class Equations : public testing::TestWithParam<int> {
  protected:
    std::shared_ptr<const SplineDomain> domain(std::size_t cells) const {
        return std::make_shared<SplineDomain>(GetParam(), cells, quarter_annulus_map());
    }
    const std::shared_ptr<const Monitor> monitor =
        make_monitor("bell", {}, {{"amplitude", 4}, {"sharpness", 8}, {"center_x", 0.5}, {"center_y", 0.6}});
};
INSTANTIATE_TEST_SUITE_P(Degrees, Equations, testing::Values(2, 3, 5));

TEST_P(Equations, HaveTheDerivativesOfTheirDifferences) {
    for (const Formulation formulation : {Formulation::standard, Formulation::mixed})
        for (const bool moving : {true, false}) {
            const PatchForm patch(domain(6), formulation, 6);
            Bfo bfo(patch.form());
            const std::size_t n = patch.form()->unknowns();
            std::mt19937 random(1);
            std::uniform_real_distribution<double> number(-1, 1);
            std::vector<double> phi(n, 0.0), w(n), whole(n), next(n), r(n), other(n), exact(n);
            for (std::size_t i = 0; i < n; ++i) phi[i] = 1e-4 * number(random), w[i] = number(random);
            const PatchSource source = patch.source(*monitor);
            const auto residual = [&](double t, std::vector<double>& out) {
                std::vector<double> moved(n);
                for (std::size_t i = 0; i < n; ++i) moved[i] = phi[i] + t * w[i];
                patch.add_identity(moved, whole);
                bfo.iterate(source, whole, next);
                bfo.residual(whole, next, out);
            };
            patch.add_identity(phi, whole);
            bfo.linearise(source, whole, moving);
            bfo.derivative(w, exact);
            constexpr double h = 1e-7;
            residual(h, r);
            residual(-h, other);
            double error = 0, size = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const double difference = -(r[i] - other[i]) / (2 * h);
                error += (difference - exact[i]) * (difference - exact[i]);
                size += exact[i] * exact[i];
            }
            if (moving)
                EXPECT_LT(std::sqrt(error / size), 1e-6);
            else
                EXPECT_GT(std::sqrt(error / size), 1e-6); // f moves, and that is left out
        }
}

TEST_P(Equations, NewtonFindsTheFixedPointOfPicard) {
    const auto solved = [&](const std::string& method) {
        gaspard::Run run(
            catalogue(),
            scenario("spline-sine-waves", {"domain.cells=16", "domain.degree=" + std::to_string(GetParam()),
                                           "monitor.type=bell", "monitor.amplitude=4", "monitor.sharpness=8",
                                           "method.type=" + method, "method.tolerance=1e-11"}));
        run.solve();
        EXPECT_EQ(run.status(), RunStatus::converged);
        return std::pair{run.history().back().iteration, run.snapshot()->x};
    };
    const auto [picard_iterations, picard] = solved("picard");
    const auto [newton_iterations, newton] = solved("newton");
    const auto [accelerated_iterations, accelerated] = solved("accelerated");
    constexpr double near = 1e-8; // gradients of what Picard's tolerance leaves
    EXPECT_LT(largest_distance(picard, newton), near);
    EXPECT_LT(largest_distance(picard, accelerated), near);
    EXPECT_LE(newton_iterations, 8);
    EXPECT_LT(2 * newton_iterations, picard_iterations);
}

TEST_P(Equations, TheMultilevelStartLeadsToTheSameMap) {
    const auto solved = [&](const std::string& method, const std::string& start) {
        gaspard::Run run(
            catalogue(),
            scenario("spline-cosine-waves",
                     {"domain.cells=32", "domain.degree=" + std::to_string(GetParam()),
                      "method.type=" + method, "method.start=" + start, "method.tolerance=1e-11"}));
        run.solve();
        EXPECT_EQ(run.status(), RunStatus::converged);
        return run.snapshot()->x;
    };
    for (const std::string method : {"picard", "picard-mixed"})
        EXPECT_LT(largest_distance(solved(method, "multilevel"), solved(method, "identity")), 1e-8) << method;
}

TEST(Picard, GoesOnFromACoarserMeshWithoutEndingThere) {
    gaspard::Run run(catalogue(), scenario("spline-circle", {"domain.cells=64"}));
    for (int i = 0; i < 5; ++i) run.step();
    EXPECT_EQ(run.state().layout, "spline standard p=3 n=16");
    Scenario loose = run.scenario();
    loose.method.values.set("tolerance", 1e-3);
    EXPECT_EQ(run.change(loose), ""); // says how good the map is on the mesh that was asked for
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    const Scenario tight = scenario("spline-circle", {"domain.cells=64", "method.tolerance=1e-11"});
    gaspard::Run again(catalogue(), tight, {.start = run.state()}), whole(catalogue(), tight);
    again.solve();
    whole.solve();
    EXPECT_LT(largest_distance(again.snapshot()->x, whole.snapshot()->x), 1e-7);
}

TEST(Picard, EndsOnTheMeshThatWasAskedFor) {
    for (const std::string method : {"picard", "picard-mixed"})
        for (const std::string tolerance : {"1e-3", "1e-5", "3e-5"}) {
            gaspard::Run run(catalogue(),
                             scenario("spline-circle", {"domain.cells=64", "method.type=" + method,
                                                        "method.tolerance=" + tolerance}));
            EXPECT_EQ(run.solve().status, RunStatus::converged);
            EXPECT_NE(run.state().layout.find("n=64"), std::string::npos) << run.state().layout;
        }
    // A monitor that 24 cells cannot resolve: the way goes up all the same.
    gaspard::Run spiral(catalogue(), scenario("spline-spiral", {"monitor.winding=100", "domain.cells=48",
                                                                "method.tolerance=1e-4"}));
    for (int i = 0; i < 150 && spiral.status() == RunStatus::running; ++i) spiral.step();
    EXPECT_NE(spiral.state().layout.find("n=48"), std::string::npos) << spiral.state().layout;
}

TEST(Newton, OnAPatchReportsItsMeasures) {
    const auto measures = [](const std::string& method) {
        gaspard::Run run(catalogue(), scenario("spline-circle", {"domain.cells=32", "method.type=" + method,
                                                                 "method.tolerance=1e-11"}));
        return run.solve();
    };
    const auto picard = measures("picard");
    for (const std::string method : {"newton", "accelerated"}) {
        const auto other = measures(method);
        const auto& all = other.series->all();
        ASSERT_EQ(all.size() - other.series->first_of_method(), 11U) << "theta, nine measures, the level";
        for (std::size_t i = other.series->first_of_method(); i < all.size(); ++i) {
            ASSERT_TRUE(picard.value(all[i].name)) << all[i].name;
            EXPECT_NEAR(other.value(i).value(), *picard.value(all[i].name), 1e-5) << all[i].name;
        }
    }
}

// ---- the residual is the same measure for all methods, the increment a series of its own

TEST(Picard, ReportsTheResidualOfTheEquationThatNewtonSolves) {
    gaspard::Run run(catalogue(), scenario("spline-two-circles", {"domain.cells=16", "method.type=picard"}));
    const auto of_newton = [&] {
        return gaspard::Run(catalogue(),
                            scenario("spline-two-circles", {"domain.cells=16", "method.type=newton"}),
                            {.start = run.state()})
            .history()
            .front()
            .residual;
    };
    for (int i = 0; i < 12; ++i) {
        const double expected = of_newton();
        EXPECT_NEAR(run.history().back().residual, expected, 1e-9 * expected) << i;
        run.step();
    }
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_NEAR(run.history().back().residual, of_newton(), 1e-13);
}

TEST(PicardMixed, ReportsTheResidualOfItsEquation) {
    const std::vector<std::string> settings = {"domain.cells=8", "method.type=picard-mixed"};
    gaspard::Run run(catalogue(), scenario("spline-circle", settings));
    // At the identity map div Psi = 2 and det = 1: r_w = <2 - s G, w> with G^2 = 4 + 2 (f - 1).
    const auto domain = std::make_shared<SplineDomain>(3, 8, square_map());
    const PatchForm patch(domain, Formulation::mixed, 8);
    const SplineForm& form = *patch.form();
    const auto& [at, weights] = std::tie(form.line().points, form.line().weights);
    const Section& section = run.scenario().monitor;
    const auto monitor = monitor_type(section.type).make(section.values, {Space{}});
    const std::size_t n = at.size();
    Points points(n * n);
    std::vector<double> rho(n * n), g(n * n);
    for (std::size_t i = 0; i < n * n; ++i) points.set(i, {at[i % n], at[i / n], 0});
    monitor->values(points, rho);
    double sigma = 0, integral = 0;
    for (std::size_t i = 0; i < n * n; ++i) sigma += weights[i % n] * weights[i / n] * rho[i];
    for (std::size_t i = 0; i < n * n; ++i) {
        g[i] = std::sqrt(4 + 2 * (sigma / rho[i] - 1));
        integral += weights[i % n] * weights[i / n] * g[i];
    }
    for (double& value : g) value = 2 - 2 / integral * value; // the flux of the identity is 2
    const auto load = [&](const std::vector<double>& values) {
        auto workspace = form.make_workspace();
        std::vector<double> b(form.unknowns());
        form.begin_load(workspace);
        for (std::size_t y = 0; y < n; ++y) form.load_row(y, &values[y * n], workspace);
        form.end_load(b, workspace);
        double squares = 0;
        for (const double one : b) squares += one * one;
        return std::sqrt(squares);
    };
    const double expected = load(g) / load(std::vector<double>(n * n, 2.0));
    EXPECT_NEAR(run.history().front().residual, expected, 1e-9 * expected);
    for (int i = 0; i < 6; ++i) run.step(); // the residual of a step is that of its result as a start
    const gaspard::Run again(catalogue(), scenario("spline-circle", settings), {.start = run.state()});
    const double residual = again.history().front().residual;
    EXPECT_NEAR(run.history().back().residual, residual, 1e-9 * residual);
}

std::string help_of_tolerance(const std::string& method) {
    const Values values = method_section(*catalogue(), method).values;
    for (const ParameterRow& row : values.rows())
        if (row.key == "tolerance") return row.help;
    return {};
}

TEST(Picard, EndsByTheIncrementWhichIsASeriesOfItsName) {
    for (const std::string method : {"picard", "picard-mixed"}) {
        gaspard::Run run(catalogue(),
                         scenario("spline-circle", {"domain.cells=32", "method.type=" + method}));
        run.solve();
        const auto& history = run.history();
        const StepReport &last = history.back(), &before = history[history.size() - 2];
        EXPECT_EQ(last.series->all()[last.series->criterion()].name, "increment");
        EXPECT_LT(last.value("increment").value(), 1e-8);
        EXPECT_GE(before.value("increment").value(), 1e-8);
        const std::string csv = history_csv(history), head = csv.substr(0, csv.find('\n'));
        EXPECT_NE(head.find(",increment"), std::string::npos) << head;
        EXPECT_NE(head.find(",level"), std::string::npos) << head;
        EXPECT_EQ(help_of_tolerance(method), "the run converges when the increment is below this value");
    }
    EXPECT_EQ(help_of_tolerance("newton"),
              "the run converges when the normalised residual is below this value");
}

TEST_P(Equations, TakeStatesOfOtherMeshesAndForms) {
    const auto map_of = [&](Formulation formulation, std::size_t cells, const std::vector<double>& phi) {
        PatchForm patch(domain(12), formulation, cells);
        std::vector<double> whole(phi.size());
        patch.add_identity(phi, whole);
        Points x;
        patch.positions(whole, x);
        return x;
    };
    const PatchForm coarse(domain(12), Formulation::standard, 6), fine(domain(12), Formulation::standard, 12);
    std::vector<double> phi(coarse.form()->unknowns());
    const std::size_t n = coarse.form()->size();
    for (std::size_t i = 0; i < phi.size(); ++i)
        phi[i] = 1e-3 * std::sin(0.4 * (i % n)) * std::cos(0.3 * (i / n));
    const Points expected = map_of(Formulation::standard, 6, phi);
    const auto refined = fine.adopt(coarse.layout(), phi); // knot insertion: the same map
    EXPECT_LT(largest_distance(map_of(Formulation::standard, 12, refined), expected), 1e-13);
    EXPECT_TRUE(fine.adopt("plane periodic Q2 n=60", phi).empty());
    EXPECT_TRUE(fine.adopt(coarse.layout() + " ", phi).empty());
    EXPECT_TRUE(fine.adopt("spline standard p=3 n=7", std::vector<double>(3)).empty());
}

TEST_P(Equations, TellTheirMapsAsSplines) {
    for (const std::string method : {"picard", "picard-mixed", "newton"}) {
        gaspard::Run run(
            catalogue(),
            scenario("spline-circle", {"domain.cells=16", "domain.degree=" + std::to_string(GetParam()),
                                       "method.type=" + method}));
        run.solve();
        const auto map = spline_map(run.state());
        ASSERT_TRUE(map.has_value());
        const Points x = run.snapshot()->x;
        for (std::size_t i = 0; i < x.size(); i += 5) { // on the square the mesh is Psi itself
            const Vec3 xi = run.discretisation().mesh()->nodes[i];
            EXPECT_NEAR(evaluate((*map)[0].space, (*map)[0].coefficients, xi), x.x[i], 1e-13);
            EXPECT_NEAR(evaluate((*map)[1].space, (*map)[1].coefficients, xi), x.y[i], 1e-13);
        }
    }
    EXPECT_FALSE(spline_map({"plane periodic Q2 n=60", {{"phi", {}}}}).has_value());
    EXPECT_FALSE(spline_map({"spline mixed p=3 n=4", {{"phi", {1, 2}}}}).has_value());
}

// ---- orders

class Orders : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Degrees, Orders, testing::Values(2, 3, 4, 5));

TEST_P(Orders, AreThoseOfTheDegreeInH1) {
    const int p = GetParam();
    for (const Formulation formulation : {Formulation::standard, Formulation::mixed}) {
        constexpr std::size_t cells = 8;
        const double coarse = solve_manufactured({formulation, p, cells, false, 0}).error;
        const double fine = solve_manufactured({formulation, p, 2 * cells, false, 0}).error;
        const double order = std::log2(coarse / fine);
        EXPECT_GT(order, p - 0.3) << coarse << ' ' << fine;
        EXPECT_LT(order, p + 0.7) << coarse << ' ' << fine;
    }
}

TEST(Manufactured, WithoutThePenaltyThereIsNoFloor) {
    // Table 1 stays at 1.7e-9, which is the penalty.
    const auto with = solve_manufactured({Formulation::standard, 5, 32, false, 1e-8});
    const auto without = solve_manufactured({Formulation::standard, 5, 32, false, 0});
    EXPECT_NEAR(with.error, 1.874e-9, 2e-12);
    EXPECT_LT(without.error, 1e-9); // what is left is the tolerance of the increment
}

} // namespace
} // namespace gaspard
