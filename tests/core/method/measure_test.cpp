// method.measure: equidistribution in space instead of the parameter square.
#include "core/base/error.hpp"
#include "core/method/measured_runs.hpp"
#include "core/method/spline_equation.hpp"
#include "core/session/comparison.hpp"
#include "core/spline/patch_file.hpp"
#include "support/built_in.hpp"
#include "support/largest_distance.hpp"
#include "support/messages.hpp"

#include <gtest/gtest.h>
#include <random>

namespace gaspard {
namespace {

const std::vector<std::string> patch_methods = {"picard", "picard-mixed", "newton", "accelerated", "auto"};

class MeasuredPatches : public testing::TestWithParam<MeasuredPatch> {};
INSTANTIATE_TEST_SUITE_P(All, MeasuredPatches, testing::ValuesIn(measured_patches()),
                         [](const auto& patch) { return std::string(patch.param.name); });

TEST_P(MeasuredPatches, AConstantMonitorMovesNothing) {
    for (const std::string& method : patch_methods)
        for (const std::string degree : {"2", "3", "7"}) {
            MeasuredPatch patch = GetParam(); // without the monitor
            std::erase_if(patch.settings, [](const auto& one) { return one.starts_with("monitor."); });
            const gaspard::Run run =
                measured_run(patch, method, 8, "physical",
                             {"monitor.type=constant", "monitor.value=3", "domain.degree=" + degree});
            EXPECT_EQ(run.status(), RunStatus::converged);
            EXPECT_LT(run.history().back().residual, 1e-12);
            EXPECT_NEAR(last_value(run, "theta"), 3, 1e-13);
            EXPECT_LT(last_value(run, "equidistribution"), 1e-10) << method << degree;
            EXPECT_NEAR(last_value(run, "min_jacobian"), 1, 1e-9) << method << degree;
        }
}

TEST_P(MeasuredPatches, AreEquidistributedInTheMeasureThatIsChosen) {
    for (const std::string method : {"picard", "picard-mixed", "newton"}) {
        const auto ratio = [&](const std::string& measure, const std::string& series) {
            double before = 0, after = 0;
            for (const int cells : {16, 32}) {
                const gaspard::Run run = measured_run(GetParam(), method, cells, measure);
                EXPECT_EQ(run.status(), RunStatus::converged);
                EXPECT_EQ(*run.history().back().tangled_cells, 0u);
                before = std::exchange(after, last_value(run, series));
            }
            return before / after;
        };
        // Order 1.8 and better; the other measure stays where it is.
        EXPECT_GT(ratio("physical", "equidistribution"), 3.4) << method;
        EXPECT_GT(ratio("parameter", "equidistribution_square"), 3.4) << method;
        EXPECT_LT(ratio("physical", "equidistribution_square"), 1.3) << method;
        EXPECT_LT(ratio("parameter", "equidistribution"), 1.3) << method;
    }
}

TEST_P(MeasuredPatches, TakeAsManyIterationsInEitherMeasure) {
    for (const std::string& method : patch_methods) {
        const int parameter = measured_run(GetParam(), method, 16, "parameter").history().back().iteration;
        const int physical = measured_run(GetParam(), method, 16, "physical").history().back().iteration;
        EXPECT_LE(physical, parameter + std::max(5, parameter / 8)) << method;
    }
}

TEST_P(MeasuredPatches, EveryMethodFindsTheSameMap) {
    const auto solved = [&](const std::string& method) {
        return measured_run(GetParam(), method, 16, "physical", {"method.tolerance=1e-11"}).snapshot()->x;
    };
    const Points newton = solved("newton");
    EXPECT_LT(largest_distance(newton, solved("picard")), 1e-8);
    EXPECT_LT(largest_distance(newton, solved("accelerated")), 1e-8);
}

TEST_P(MeasuredPatches, NewtonConvergesQuadratically) {
    const gaspard::Run run = measured_run(GetParam(), "newton", 16, "physical", {"method.tolerance=1e-11"});
    const auto& history = run.history();
    int steps = 0;
    for (std::size_t i = 1; i < history.size(); ++i) {
        const double before = history[i - 1].residual, after = history[i].residual;
        if (before > 2e-3 || before < 1e-6) continue;
        ++steps;
        EXPECT_LT(after, 20 * before * before) << before;
    }
    EXPECT_GT(steps, 0);
    EXPECT_LT(history.back().residual, 1e-11);
}

TEST_P(MeasuredPatches, TheMixedFormKeepsTheBorder) {
    EXPECT_LT(last_value(measured_run(GetParam(), "picard-mixed", 16, "physical"), "border_error"), 1e-14);
}

TEST_P(MeasuredPatches, ContinueFromThePresentMeshWhenTheMeasureChanges) {
    for (const std::string method : {"picard", "newton"}) {
        gaspard::Run run = measured_run(GetParam(), method, 16, "parameter");
        const Points before = run.snapshot()->x;
        Scenario changed = run.scenario();
        changed.method.values.set("measure", std::string("physical"));
        EXPECT_EQ(run.change(changed), "");
        EXPECT_EQ(run.history().size(), 1U) << "a history of the new values";
        EXPECT_LT(largest_distance(run.snapshot()->x, before), 1e-12);
        EXPECT_EQ(run.status(), RunStatus::running);
        run.solve();
        EXPECT_EQ(run.status(), RunStatus::converged);
        const gaspard::Run whole = measured_run(GetParam(), method, 16, "physical");
        EXPECT_NEAR(last_value(run, "equidistribution"), last_value(whole, "equidistribution"), 1e-5);
    }
}

TEST(Measure, HasNoEffectOnTheSquare) {
    for (const std::string& method : patch_methods) {
        const auto positions = [&](const std::string& measure) {
            return solved_run("spline-circle",
                              {"domain.cells=16", "method.type=" + method, "method.measure=" + measure})
                .snapshot()
                ->x;
        };
        const Points one = positions("parameter"), other = positions("physical");
        EXPECT_EQ(one.x, other.x) << method;
        EXPECT_EQ(one.y, other.y) << method;
    }
}

/// A curved patch, or its mirror image.
std::string curved_patch(bool mirrored) {
    const std::string s = mirrored ? "-" : "";
    return R"({"degrees":[2,1],"knots":[[0,0,0,1,1,1],[0,0,1,1]],"control_points":[[0,0],[)" + s +
           "0.5,0.2],[" + s + "1,0],[0,1],[" + s + "0.6,1.1],[" + s + "1.2,1]]}";
}

TEST(Measure, OfAMirroredPatchIsThatOfThePatch) {
    const auto solved = [&](bool mirrored, const std::string& method) {
        return measured_run(
            {"",
             {"domain.type=spline-patch", "domain.file=" + curved_patch(mirrored), "monitor.type=circle",
              "monitor.radius=0.3", "monitor.sharpness=20", "monitor.center_y=0.5",
              std::string("monitor.center_x=") + (mirrored ? "-0.5" : "0.5")}},
            method, 16, "physical");
    };
    for (const std::string& method : patch_methods) {
        gaspard::Run plain = solved(false, method), mirrored = solved(true, method);
        Points image = mirrored.snapshot()->x;
        for (double& x : image.x) x = -x;
        EXPECT_LT(largest_distance(plain.snapshot()->x, image), 1e-12) << method;
        EXPECT_EQ(plain.history().back().iteration, mirrored.history().back().iteration);
    }
}

/// det = f on the cells in space: theta and the least Jacobian of a monitor that only depends on the radius
/// of the annulus follow from a quadrature.
TEST(Measure, GivesTheMapOfARadialMonitor) {
    // m = 1 / r^2 on radii 1/2 to 1: m r dr = theta r0 dr0, so log(2 r) = theta (r0^2 - 1/4) / 2.
    gaspard::Run run = solved_run("spline-formula",
                                  {"domain.type=spline-annulus", "domain.cells=32", "method.measure=physical",
                                   "method.tolerance=1e-10", "monitor.expression=1/(x^2 + y^2)"});
    ASSERT_EQ(run.status(), RunStatus::converged);
    const double theta = 8 * std::log(2.0) / 3;
    EXPECT_NEAR(last_value(run, "theta"), theta, 1e-9);
    const auto snapshot = run.snapshot();
    for (std::size_t i = 0; i < snapshot->x.size(); ++i) {
        const double before = norm(snapshot->mesh->nodes[i]), after = norm(snapshot->x[i]);
        EXPECT_NEAR(after, 0.5 * std::exp(theta * (before * before - 0.25) / 2), 2e-5);
    }
}

class MeasuredEquations : public testing::TestWithParam<std::shared_ptr<const PatchMap>> {};
INSTANTIATE_TEST_SUITE_P(All, MeasuredEquations,
                         testing::Values(disk_map(), quarter_annulus_map(), torus_part_map(), moebius_map(),
                                         patch_map(nurbs_disk())));

TEST_P(MeasuredEquations, HaveTheDerivativesOfTheirDifferences) {
    const auto monitor =
        make_monitor("bell", {}, {{"amplitude", 4}, {"sharpness", 1}, {"center_x", 0.5}, {"center_y", 0.6}});
    for (const Formulation formulation : {Formulation::standard, Formulation::mixed}) {
        PatchForm patch(std::make_shared<SplineDomain>(3, 6, GetParam()), formulation, 6);
        patch.set_measure(Measure::physical);
        Bfo bfo(patch.form());
        const std::size_t n = patch.form()->unknowns();
        std::mt19937 random(1);
        std::uniform_real_distribution<double> number(-1, 1);
        std::vector<double> phi(n), w(n), whole(n), next(n), r(n), other(n), exact(n);
        for (std::size_t i = 0; i < n; ++i) phi[i] = 1e-4 * number(random), w[i] = number(random);
        const PatchSource source = patch.source(*monitor);
        constexpr double h = 1e-7;
        const auto residual = [&](double t, std::vector<double>& out) {
            std::vector<double> moved(n);
            for (std::size_t i = 0; i < n; ++i) moved[i] = phi[i] + t * w[i];
            patch.add_identity(moved, whole);
            bfo.iterate(source, whole, next);
            bfo.residual(whole, next, out);
        };
        patch.add_identity(phi, whole);
        bfo.linearise(source, whole, true);
        bfo.derivative(w, exact);
        residual(h, r);
        residual(-h, other);
        double error = 0, size = 0;
        for (std::size_t i = 0; i < n; ++i) {
            error += std::pow(-(r[i] - other[i]) / (2 * h) - exact[i], 2);
            size += exact[i] * exact[i];
        }
        EXPECT_LT(std::sqrt(error / size), 1e-5); // differences are less exact where J is small
    }
}

TEST(Measure, BoundsTheRatioOfAreasWhereThereIsNone) {
    const auto monitor = make_monitor("constant", {}, {{"value", 2}});
    PatchForm patch(std::make_shared<SplineDomain>(3, 8, disk_map()), Formulation::standard, 8);
    patch.set_measure(Measure::physical);
    const PatchSource source = patch.source(*monitor);
    const std::size_t row = patch.form()->line().points.size();
    Points corners(row); // at a corner of the disk, and beyond it
    for (std::size_t i = 0; i < row; ++i) corners.set(i, i % 2 == 0 ? Vec3{1, 1, 0} : Vec3{1 + 1e-3, 1, 0});
    std::vector<double> f(row);
    Points gradient;
    source.gradients(0, corners, f, gradient);
    for (std::size_t i = 0; i < row; ++i) {
        EXPECT_TRUE(f[i] > 0 && f[i] <= 1000 * (1 + 1e-12)) << f[i];
        EXPECT_TRUE(std::isfinite(gradient.x[i]) && std::isfinite(gradient.y[i]));
    }
    EXPECT_NEAR(f[0], 1000, 1e-9); // sigma = rho
    EXPECT_EQ(gradient.x[0], 0) << "the bound does not move";
}

// ---- the key

TEST(Measure, IsAKeyOfMethodsOnPatchesOnly) {
    const Catalogue catalogue = builtin_catalogue();
    Scenario scenario = find_scenario(catalogue, "plane-ring");
    set_value(catalogue, scenario, "method.type", std::string("newton"));
    EXPECT_FALSE(has_key(scenario, "method.measure"));
    const std::string message =
        message_of<InputError>([&] { apply_settings(catalogue, scenario, {"method.measure=physical"}); });
    EXPECT_TRUE(
        message.starts_with("method.measure is not a key for domain 'plane', but for 'spline-square'"))
        << message;
    set_value(catalogue, scenario, "domain.type", std::string("spline-disk"));
    for (const std::string& method : patch_methods) {
        set_value(catalogue, scenario, "method.type", method);
        EXPECT_TRUE(has_key(scenario, "method.measure")) << method;
        EXPECT_EQ(scenario.method.values.text("measure"), "parameter");
    }
    set_value(catalogue, scenario, "domain.type", std::string("plane"));
    EXPECT_FALSE(has_key(scenario, "method.measure"));
}

TEST(Measure, StaysWhenTheMethodChanges) {
    const Catalogue catalogue = builtin_catalogue();
    Scenario scenario = find_scenario(catalogue, "spline-two-circles");
    apply_settings(catalogue, scenario, {"method.measure=physical", "method.type=newton"});
    EXPECT_EQ(scenario.method.values.text("measure"), "physical");
    EXPECT_EQ(with_method(catalogue, scenario, "picard-mixed").method.values.text("measure"), "physical");
    const Scenario again = parse_scenario(catalogue, to_toml(scenario), "again.toml");
    EXPECT_EQ(again.method, scenario.method);
}

} // namespace
} // namespace gaspard
