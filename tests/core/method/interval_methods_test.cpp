// Methods on an interval, from the scenario to the numbers of Hill and Madden (2021).
#include "core/layer/interval_mesh.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class IntervalMethods : public testing::Test {
  protected:
    Scenario layer(const std::vector<std::string>& settings) const {
        Scenario scenario = find_scenario(*catalogue, "layer-1d");
        apply_settings(*catalogue, scenario, settings);
        return scenario;
    }
    gaspard::Run run(const std::vector<std::string>& settings) const { return {catalogue, layer(settings)}; }
    std::string complaint(const std::vector<std::string>& settings) const {
        try {
            run(settings);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    /// Algorithm 2 as in the paper.
    const std::vector<std::string> paper = {"method.tolerance=0.4", "method.normalised=false",
                                            "method.finish=fixed-point"};
};

/// Solves on the last mesh.
int final_solves(const gaspard::Run& run) {
    int count = 0;
    for (const StepReport& report : run.history())
        count += report.iteration > 0 && report.value("level") == 0.0;
    return count;
}

// Table 2 and 3, eps = 1e-8.
TEST_F(IntervalMethods, MeshPdeHasTheSolvesAndErrorsOfTheTables) {
    const int solves[] = {4, 4, 4, 4};
    const double errors[] = {4.141e-6, 2.071e-6, 1.036e-6, 5.181e-7};
    for (int i = 0, cells = 32; i < 4; ++i, cells *= 2) {
        auto settings = paper;
        settings.push_back("domain.cells=" + std::to_string(cells));
        settings.push_back("pde.eps=1e-8");
        gaspard::Run one = run(settings);
        one.solve();
        EXPECT_EQ(one.status(), RunStatus::converged);
        EXPECT_EQ(final_solves(one), solves[i]) << cells;
        EXPECT_NEAR(*one.history().back().value("energy_error"), errors[i], 2e-3 * errors[i]);
        EXPECT_NEAR(*one.history().back().value("exact_energy_error"), errors[i], 2e-2 * errors[i]);
        EXPECT_EQ(*one.history().back().tangled_cells, 0U);
        // Between two uniform nodes, the solution of order 2 knows as little of the layer.
        EXPECT_GT(*one.history().back().value("uniform_exact_energy_error"),
                  1.25 * *one.history().back().value("uniform_energy_error"));
    }
}

TEST_F(IntervalMethods, AlgorithmOneNeedsTheIterationsOfTableOne) {
    gaspard::Run one =
        run({"domain.cells=64", "method.refine=false", "method.normalised=false", "method.finish=fixed-point",
             "method.tolerance=0.02", "method.max_iterations=37", "pde.eps=1e-4"});
    one.solve();
    EXPECT_EQ(one.status(), RunStatus::iteration_limit);
    EXPECT_EQ(one.history().back().iteration, 37);
    gaspard::Run wide = run({"domain.cells=64", "method.refine=false", "method.normalised=false",
                             "method.finish=fixed-point", "method.tolerance=0.02", "pde.eps=1e-2"});
    wide.solve();
    EXPECT_EQ(wide.status(), RunStatus::converged);
    EXPECT_EQ(wide.history().back().iteration, 14);
}

TEST_F(IntervalMethods, EndAfterAFixedNumberOfSolves) {
    gaspard::Run one =
        run({"domain.cells=64", "method.final_solves=5", "method.finish=fixed-point", "pde.eps=1e-8"});
    one.solve();
    EXPECT_EQ(one.status(), RunStatus::converged);
    EXPECT_EQ(final_solves(one), 5);
    EXPECT_EQ(one.history().back().iteration, 4 * 3 + 5);
}

// Cells have equal shares to rounding, which no fixed point of thin layers reaches.
TEST_F(IntervalMethods, ConvergeForLayersOfAnyWidth) {
    for (const char* eps : {"1", "1e-2", "1e-4", "1e-8", "1e-12"})
        for (const char* cells : {"7", "32", "1000"}) {
            gaspard::Run one = run({std::string("pde.eps=") + eps, std::string("domain.cells=") + cells});
            one.solve();
            EXPECT_EQ(one.status(), RunStatus::converged) << eps << ' ' << cells;
            EXPECT_LT(one.history().back().residual, 1e-9) << eps << ' ' << cells;
            EXPECT_LE(one.history().back().iteration, 60) << eps << ' ' << cells;
        }
}

TEST_F(IntervalMethods, FindsTheLayerWithoutEps) {
    for (const char* density : {"arc-length", "curvature", "estimate"})
        for (const double eps : {1e-2, 1e-5, 1e-8}) {
            gaspard::Run one =
                run({"method.type=solution-adapted", "monitor.type=constant", "domain.cells=64",
                     std::string("method.density=") + density, "pde.eps=" + format_number(eps)});
            one.solve();
            EXPECT_EQ(one.status(), RunStatus::converged) << density << ' ' << eps;
            // (18) has 1.326 sqrt(eps) / N
            EXPECT_LT(*one.history().back().value("exact_energy_error"), 1.7 * 1.326 * std::sqrt(eps) / 64)
                << density << ' ' << eps;
        }
    EXPECT_EQ(complaint({"method.type=solution-adapted", "pde.type=none", "monitor.type=constant"}),
              "method solution-adapted needs a problem to solve; set pde.type");
}

// A result does not depend on the problems before it.
TEST_F(IntervalMethods, MeshPdeForgetsWhereItStarted) {
    gaspard::Run changed = run({"pde.eps=1e-2"});
    changed.solve();
    changed.change(layer({"pde.eps=1e-8"}));
    changed.solve();
    gaspard::Run fresh = run({"pde.eps=1e-8"});
    fresh.solve();
    EXPECT_EQ(changed.snapshot()->x.x, fresh.snapshot()->x.x);
}

TEST_F(IntervalMethods, TheUnitOfTheMonitorDoesNotMatter) {
    std::vector<double> meshes[3];
    int i = 0;
    for (const char* scale : {"1", "1e-200", "1e200"}) {
        gaspard::Run one =
            run({"monitor.type=formula",
                 std::string("monitor.expression=") + scale + "*max(1, 0.4*0.99/eps*exp(-0.396*x/eps))",
                 "monitor.ranges=eps 1e-12 1 log", "monitor.eps=1e-2", "method.normalised=true"});
        one.solve();
        EXPECT_EQ(one.status(), RunStatus::converged) << scale;
        meshes[i++] = one.snapshot()->x.x;
    }
    for (std::size_t node = 0; node < meshes[0].size(); ++node) {
        EXPECT_NEAR(meshes[1][node], meshes[0][node], 1e-13);
        EXPECT_NEAR(meshes[2][node], meshes[0][node], 1e-13);
    }
}

TEST_F(IntervalMethods, FormulasNeedOneStep) {
    for (const char* method : {"bakhvalov", "shishkin", "equidistribute"}) {
        gaspard::Run one = run({std::string("method.type=") + method, "domain.cells=64", "pde.eps=1e-6"});
        one.solve();
        EXPECT_EQ(one.status(), RunStatus::converged) << method;
        EXPECT_EQ(one.history().back().iteration, 1) << method;
        EXPECT_LT(*one.history().back().value("energy_error"), 7e-5) << method; // Bakhvalov 3.3e-5
        EXPECT_GT(*one.history().back().value("uniform_exact_energy_error"), 1e-2) << method;
    }
    gaspard::Run two = run({"method.type=bakhvalov", "pde.type=coupled-reaction-diffusion", "pde.eps1=1e-3",
                            "pde.eps2=1e-6", "monitor.type=two-layers"});
    two.solve();
    EXPECT_EQ(two.snapshot()->x.x, bakhvalov_mesh({.eps = 1e-6}, {}, 32).x);
    EXPECT_EQ(complaint({"method.type=bakhvalov", "pde.type=none", "monitor.type=constant"}),
              "method.eps = auto: the problem has no eps; set it to a number");
    gaspard::Run bakhvalov = run({"method.type=bakhvalov", "domain.cells=64", "pde.eps=1e-6"});
    bakhvalov.solve();
    EXPECT_EQ(bakhvalov.snapshot()->x.x, bakhvalov_mesh({.eps = 1e-6}, {}, 64).x);
}

TEST_F(IntervalMethods, LayersAtEitherEndAreMirrored) {
    for (const char* method : {"bakhvalov", "shishkin"}) {
        const auto mesh = [&](const char* layers) {
            gaspard::Run one =
                run({std::string("method.type=") + method, std::string("method.layers=") + layers,
                     "domain.cells=32", "method.eps=1e-3", "domain.start=-1", "domain.end=3"});
            one.solve();
            return one.snapshot()->x.x;
        };
        const auto left = mesh("left"), right = mesh("right"), both = mesh("both");
        for (std::size_t i = 0; i <= 32; ++i) {
            EXPECT_NEAR(left[i] + right[32 - i], 2, 1e-14);
            EXPECT_NEAR(both[i] + both[32 - i], 2, 1e-14);
        }
        EXPECT_NEAR(both[16], 1, 1e-14);
        EXPECT_LT(both[1] + 1, 1e-3);
    }
}

// No node moves by rounding alone.
TEST_F(IntervalMethods, AConstantMonitorMovesNothing) {
    for (const char* method : {"mesh-pde", "equidistribute"}) {
        gaspard::Run one = run({std::string("method.type=") + method, "monitor.type=constant"});
        one.solve();
        EXPECT_EQ(one.status(), RunStatus::converged);
        const auto snapshot = one.snapshot();
        for (std::size_t i = 0; i < snapshot->x.size(); ++i)
            EXPECT_NEAR(snapshot->x.x[i], snapshot->mesh->nodes.x[i], 1e-14);
    }
}

TEST_F(IntervalMethods, TransferBetweenMethodsAndResolutions) {
    gaspard::Run one = run({"pde.eps=1e-4"});
    one.solve();
    EXPECT_EQ(one.change(layer({"pde.eps=1e-4", "domain.cells=64"})), "");
    EXPECT_EQ(one.change(layer({"pde.eps=1e-4", "method.type=bakhvalov"})), "");
    one.solve();
    EXPECT_EQ(one.status(), RunStatus::converged);
}

TEST_F(IntervalMethods, SolutionsAreFields) {
    gaspard::Run one = run({"pde.type=coupled-reaction-diffusion", "monitor.type=two-layers"});
    one.solve();
    const auto snapshot = one.snapshot();
    for (const char* name : {"solution", "solution_2", "solution_uniform", "solution_2_uniform", "width"})
        ASSERT_NE(snapshot->field(name), nullptr) << name;
    EXPECT_EQ(snapshot->field("solution")->values.front(), 0);
    gaspard::Run without = run({"pde.type=none", "monitor.eps=1e-3"});
    without.solve();
    EXPECT_EQ(without.snapshot()->field("solution"), nullptr);
    EXPECT_FALSE(without.history().back().value("energy_error").has_value());
}

TEST_F(IntervalMethods, DensitiesOfLayersHaveTheirGradients) {
    for (const char* type : {"layer", "two-layers"}) {
        const MonitorType& monitor = catalogue->monitor(type);
        for (const int dimension : {1, 2}) {
            const Space space{.dimension = dimension};
            Section section = monitor_section(*catalogue, type, space);
            for (const char* key : {"eps", "eps1", "eps2", "right"})
                if (section.values.has(key)) section.values.parse(key, key[0] == 'r' ? "true" : "0.1");
            if (dimension > 1) section.values.parse("top", "true");
            const auto rho = monitor.make(section.values, {.space = space});
            Points x(3), gradients;
            for (std::size_t i = 0; i < 3; ++i)
                x.set(i, {0.02 + 0.4 * static_cast<double>(i), dimension > 1 ? 0.97 : 0.0, 0});
            rho->gradients(x, gradients);
            const double h = 1e-5;
            for (std::size_t i = 0; i < 3; ++i)
                for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
                    Points both(2);
                    both.set(0, x[i] - h * axis), both.set(1, x[i] + h * axis);
                    std::vector<double> values(2);
                    rho->values(both, values);
                    EXPECT_NEAR(dot(gradients[i], axis), (values[1] - values[0]) / (2 * h), 1e-5)
                        << type << ' ' << dimension << ' ' << i;
                }
        }
    }
}

TEST_F(IntervalMethods, InvalidInputIsOneSentence) {
    EXPECT_EQ(complaint({"pde.type=none"}), "monitor.eps = auto: the problem has no eps; set it to a number");
    EXPECT_EQ(complaint({"domain.cells=3"}),
              "method.start_cells (4) must not be greater than domain.cells (3)");
    EXPECT_EQ(complaint({"domain.start=1"}), "domain.end (1) must be greater than domain.start (1)");
    EXPECT_EQ(
        complaint({"pde.eps=0"}),
        "pde.eps = 0 is out of range: 10⁻¹² to 1 (the smaller, the thinner the layers of the solution)");
    EXPECT_EQ(complaint({"monitor.q=1"}),
              "monitor.q = 1 is out of range: 0.01 to 0.99 (share of the cells in layers)");
    EXPECT_NE(complaint({"pde.source=1 + sine(x)"}).find("unknown function 'sine' at character 5"),
              std::string::npos);
    EXPECT_EQ(complaint({"pde.reaction=k*x"}),
              "pde.reaction: unknown name 'k' (did you mean 'x'?); known: x, eps");
    EXPECT_EQ(complaint({"pde.source=1/x", "domain.start=-1"}), "pde.source is not finite at x = 0");
    EXPECT_EQ(complaint({"pde.source=1/(x + 2)", "domain.start=-1"}), "");
    EXPECT_NE(complaint({"monitor.type=formula", "monitor.expression=x - 0.5"}), "");
    EXPECT_NE(complaint({"method.type=bakhvalov", "method.layers=both", "domain.cells=33"}), "");
}

} // namespace
} // namespace gaspard
