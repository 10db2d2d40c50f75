// The mesh PDE on quadrilaterals, from the scenario to energy errors that an independent implementation
// (FEniCS) has.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

class QuadrilateralMeshPde : public testing::Test {
  protected:
    gaspard::Run run(const std::string& name, const std::vector<std::string>& settings) const {
        Scenario scenario = find_scenario(*catalogue, name);
        apply_settings(*catalogue, scenario, settings);
        return {catalogue, scenario};
    }
    std::string complaint(const std::string& name, const std::vector<std::string>& settings) const {
        try {
            run(name, settings);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(QuadrilateralMeshPde, HasTheErrorsOfTheIndependentImplementation) {
    const struct {
        const char *scenario, *eps;
        double error; ///< N = 32
    } cases[] = {{"layer-2d", "1e-2", 1.87e-2},
                 {"layer-2d", "1e-4", 3.09e-3},
                 {"layer-2d", "1e-8", 1.04e-3},
                 {"layer-quadrilateral", "1e-2", 4.73e-3},
                 {"layer-quadrilateral", "1e-4", 5.17e-4}};
    for (const auto& one : cases) {
        gaspard::Run made = run(one.scenario, {std::string("pde.eps=") + one.eps});
        made.solve();
        EXPECT_EQ(made.status(), RunStatus::converged);
        EXPECT_EQ(made.history().back().iteration, 3 * 4 + 5);
        EXPECT_NEAR(*made.history().back().value("energy_error"), one.error, 3e-3 * one.error)
            << one.scenario << ' ' << one.eps;
    }
}

// Without eps in the densities; the errors of those that know eps are in the test above.
TEST_F(QuadrilateralMeshPde, SolutionAdaptedFindsLayersOfAnyWidth) {
    const struct {
        const char *scenario, *eps;
        double known; ///< the error with densities that know eps, N = 32
    } cases[] = {{"layer-2d", "1e-2", 1.87e-2},
                 {"layer-2d", "1e-4", 3.09e-3},
                 {"layer-2d", "1e-8", 1.04e-3},
                 {"layer-quadrilateral", "1e-2", 4.73e-3},
                 {"layer-quadrilateral", "1e-4", 5.17e-4},
                 {"layer-quadrilateral", "1e-8", 5.19e-6}};
    for (const auto& one : cases) {
        gaspard::Run made =
            run(one.scenario, {"method.type=solution-adapted", std::string("pde.eps=") + one.eps});
        made.solve();
        const StepReport& last = made.history().back();
        EXPECT_EQ(made.status(), RunStatus::converged);
        EXPECT_EQ(*last.tangled_cells, 0U);
        EXPECT_LT(*last.value("energy_error"), 1.5 * one.known) << one.scenario << ' ' << one.eps;
        EXPECT_GT(*last.value("energy_error"), 0.4 * one.known) << one.scenario << ' ' << one.eps;
    }
}

// A step of Newton's method, a solve for densities, a step whose result is measured.
TEST_F(QuadrilateralMeshPde, StepsAreStoppedAndLeaveTheIterateBefore) {
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"method.finish=converged"}, {"method.type=solution-adapted"}, {}}) {
        gaspard::Run made = run("layer-2d", settings);
        for (int k = 0; k < 16; ++k) made.step();
        const Points before = made.snapshot()->x;
        const std::size_t reports = made.history().size();
        std::stop_source source;
        source.request_stop();
        ASSERT_EQ(made.status(), RunStatus::running);
        EXPECT_THROW(made.step(source.get_token()), Interrupted);
        EXPECT_EQ(made.history().size(), reports);
        EXPECT_EQ(made.snapshot()->x, before);
        EXPECT_EQ(made.solve(source.get_token()).status, RunStatus::interrupted);
        EXPECT_TRUE(made.history().back().value("energy_error")) << "what is there is measured";
    }
}

TEST_F(QuadrilateralMeshPde, RefusesCoefficientsForWhichThePictureWouldBeWrong) {
    EXPECT_EQ(complaint("layer-2d", {"pde.source=log(x)"}), "pde.source is not finite at (0, 0)");
    EXPECT_EQ(complaint("layer-2d", {"pde.reaction=x - 0.5"}),
              "pde.reaction is −0.5 at (0, 0); it must not be negative");
    EXPECT_EQ(complaint("layer-2d", {"pde.squared=false", "pde.diffusion_y=-1"}),
              "pde.diffusion_y is −1 at (0, 0); it must not be negative");
    EXPECT_EQ(complaint("layer-2d", {"pde.diffusion_y=-1"}), "") << "its square is positive";
    EXPECT_EQ(complaint("layer-2d", {"pde.reaction=sin(pi*x)"}), "") << "-1e-16 at 1 is rounding";
    EXPECT_EQ(complaint("layer-1d", {"pde.source=log(x)"}), "pde.source is not finite at x = 0");
    EXPECT_EQ(complaint("layer-1d", {"pde.source=1/(x - 0.5)"}), "pde.source is not finite at x = 0.5");
    EXPECT_EQ(complaint("layer-1d", {"pde.reaction=-1"}),
              "pde.reaction is −1 at x = 0; it must not be negative");
    EXPECT_EQ(complaint("layer-1d-convection", {"pde.reaction=-1"}), "") << "u grows, and is unique";
}

// Galerkin's solutions on coarse meshes would oscillate. Along x, and with a flow across a slanted side.
TEST_F(QuadrilateralMeshPde, SolutionAdaptedFindsLayersOfConvection) {
    for (const char* eps : {"1e-2", "1e-4", "1e-8"}) {
        const std::string width = std::string("pde.eps=") + eps;
        gaspard::Run known = run("layer-2d-convection", {width}),
                     found = run("layer-2d-convection", {width, "method.type=solution-adapted"});
        const double best = *known.solve().value("energy_error"), own = *found.solve().value("energy_error");
        EXPECT_LT(own, 1.5 * best) << eps;
        EXPECT_EQ(*found.history().back().tangled_cells, 0U);
    }
    for (const char* eps : {"1e-2", "1e-4", "1e-6"}) {
        gaspard::Run slanted =
            run("layer-quadrilateral", {"pde.type=convection-diffusion-2d", "method.type=solution-adapted",
                                        std::string("pde.eps=") + eps});
        EXPECT_LT(*slanted.solve().value("energy_error"), 0.06) << eps;
    }
}

TEST_F(QuadrilateralMeshPde, SolutionAdaptedShortensStepsThatWouldInvertTriangles) {
    gaspard::Run made =
        run("layer-2d", {"method.type=solution-adapted", "method.smoothing=0", "pde.eps=1e-8"});
    made.solve();
    EXPECT_EQ(made.status(), RunStatus::converged);
    const auto shortened = [](const StepReport& report) {
        return report.iteration > 0 && report.step_size < 1;
    };
    const auto& history = made.history();
    EXPECT_GE(std::count_if(history.begin(), history.end(), shortened), 2);
    EXPECT_EQ(*history.back().tangled_cells, 0U);
    EXPECT_TRUE(history.back().value("energy_error")) << "the solution needs areas";
}

TEST_F(QuadrilateralMeshPde, SolutionAdaptedDoesNotUseTheMonitor) {
    std::vector<double> errors;
    for (const char* eps : {"1e-2", "0.5"}) {
        gaspard::Run made = run("layer-2d", {"method.type=solution-adapted", "monitor.type=layer",
                                             std::string("monitor.eps=") + eps, "pde.eps=1e-4"});
        made.solve();
        errors.push_back(*made.history().back().value("energy_error"));
    }
    EXPECT_EQ(errors[0], errors[1]);
}

TEST_F(QuadrilateralMeshPde, RefusesSolutionsWithoutAnEnergyAndProblemsWithoutASolution) {
    for (const char* name : {"layer-1d", "layer-2d"})
        for (const char* source : {"1e155", "1e308"})
            EXPECT_NE(complaint(name, {std::string("pde.source=") + source}).find("so large that its energy"),
                      std::string::npos)
                << name << ' ' << source;
    std::vector<std::string> free = {"pde.hold_left=false", "pde.hold_right=false", "pde.hold_bottom=false",
                                     "pde.hold_top=false"};
    EXPECT_EQ(complaint("layer-2d", free), "") << "reaction makes it unique";
    free.emplace_back("pde.reaction=0");
    EXPECT_NE(complaint("layer-2d", free).find("u is not unique"), std::string::npos);
}

TEST_F(QuadrilateralMeshPde, EitherMethodShowsTheSolution) {
    for (const char* method : {"mesh-pde", "solution-adapted"}) {
        Scenario scenario = find_scenario(*catalogue, "layer-2d");
        apply_settings(*catalogue, scenario, {std::string("method.type=") + method});
        EXPECT_EQ(scenario.view.text("color"), "solution") << method;
    }
}

TEST_F(QuadrilateralMeshPde, SolutionAdaptedNeedsAProblemAndADensityOfItsOwn) {
    const auto of = [&](const std::string& setting) {
        return complaint("layer-2d", {"method.type=solution-adapted", "monitor.eps=0.1", setting});
    };
    EXPECT_NE(of("pde.type=none").find("needs a problem to solve; set pde.type"), std::string::npos);
    EXPECT_NE(of("method.density=estimate").find("use arc-length or curvature"), std::string::npos);
    EXPECT_NE(of("method.start_cells=1").find("method.start_cells must be at least 2"), std::string::npos);
}

// As the triangles on which the problem is solved.
TEST_F(QuadrilateralMeshPde, MeshesHaveRightDiagonals) {
    gaspard::Run made = run("layer-2d", {"domain.cells=4"});
    const std::vector<std::int32_t> cells = made.snapshot()->mesh->cells;
    const std::vector<std::int32_t> first = {0, 1, 6, 0, 6, 5};
    EXPECT_TRUE(std::equal(first.begin(), first.end(), cells.begin()));
}

TEST_F(QuadrilateralMeshPde, ConvergesByNewtonsMethod) {
    gaspard::Run made = run("layer-2d", {"method.finish=converged", "domain.cells=16", "pde.eps=1e-4"});
    made.solve();
    EXPECT_EQ(made.status(), RunStatus::converged);
    EXPECT_LT(made.history().back().residual, 1e-8);
    EXPECT_LT(made.history().back().iteration, 40);
    EXPECT_EQ(*made.history().back().tangled_cells, 0U);
}

// In one direction and at corners for thin layers; the error is not that of the five solves of the paper.
TEST_F(QuadrilateralMeshPde, ConvergesInColumns) {
    gaspard::Run made = run("layer-quadrilateral", {"method.finish=converged", "method.samples=corners",
                                                    "domain.cells=32", "pde.eps=1e-6"});
    made.solve();
    const StepReport& last = made.history().back();
    EXPECT_EQ(made.status(), RunStatus::converged);
    EXPECT_LT(last.residual, 1e-8);
    EXPECT_EQ(*last.tangled_cells, 0U);
    EXPECT_NEAR(*last.value("energy_error"), 5.442e-5, 2e-8);
}

// Densities of degree 4 leave columns apart, each with its own number of nodes in the layer.
TEST_F(QuadrilateralMeshPde, SaysWhatHelpsWhereNewtonsMethodDoesNotConverge) {
    gaspard::Run made = run("layer-quadrilateral", {"method.finish=converged", "pde.eps=1e-8",
                                                    "method.reference=off", "method.max_iterations=220"});
    made.solve();
    const StepReport& last = made.history().back();
    EXPECT_NE(made.status(), RunStatus::converged);
    EXPECT_NE(last.note.find("method.samples = corners may help"), std::string::npos) << last.note;
    EXPECT_TRUE(made.history()[100].note.empty());
}

// Of a rotated and stretched square: nodes of a side stay on it, corners stay.
TEST_F(QuadrilateralMeshPde, NodesSlideAlongSidesOfAnyDirection) {
    for (const char* form : {"both", "vertical"}) {
        gaspard::Run made =
            run("layer-2d", {"domain.cells=16", "domain.corners=0 0, 2 1, 1.5 3, -1 2", "pde.eps=1e-2",
                             std::string("method.form=") + form, "monitor.width_x=eps", "monitor.width_y=eps",
                             "pde.diffusion_x=1", "pde.diffusion_y=1"});
        made.solve();
        const auto snapshot = made.snapshot();
        const Points& x = snapshot->x;
        const Vec3 corners[] = {{0, 0, 0}, {2, 1, 0}, {1.5, 3, 0}, {-1, 2, 0}};
        const auto node = [&](std::size_t i, std::size_t j) { return x[j * 17 + i]; };
        double moved = 0;
        for (std::size_t k = 0; k <= 16; ++k) {
            const Vec3 on_sides[] = {node(k, 0), node(16, k), node(k, 16), node(0, k)};
            const std::pair<int, int> ends[] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}};
            for (std::size_t side = 0; side < 4; ++side) {
                const Vec3 from = corners[ends[side].first], along = corners[ends[side].second] - from;
                EXPECT_NEAR(cross(along, on_sides[side] - from).z, 0, 1e-13);
                const double place = dot(along, on_sides[side] - from) / dot(along, along);
                moved = std::max(moved, std::abs(place - static_cast<double>(k) / 16));
            }
        }
        EXPECT_GT(moved, 0.1) << form;
        EXPECT_EQ(*made.history().back().tangled_cells, 0U) << form;
    }
}

TEST_F(QuadrilateralMeshPde, AConstantMonitorMovesNothing) {
    for (const char* finish : {"converged", "fixed-point"}) {
        gaspard::Run made =
            run("layer-2d", {"monitor.type=constant", "domain.cells=12",
                             "domain.corners=0 0, 2 0, 1.5 1, 0 2", std::string("method.finish=") + finish});
        made.solve();
        EXPECT_EQ(made.status(), RunStatus::converged);
        const auto snapshot = made.snapshot();
        for (std::size_t i = 0; i < snapshot->x.size(); ++i)
            EXPECT_LT(norm(snapshot->x[i] - snapshot->mesh->nodes[i]), 1e-12);
    }
}

TEST_F(QuadrilateralMeshPde, TransfersToOtherResolutionsAndCorners) {
    gaspard::Run made = run("layer-2d", {"domain.cells=16"});
    made.solve();
    Scenario changed = made.scenario();
    apply_settings(*catalogue, changed, {"domain.cells=24", "domain.corners=0 0, 1 0.2, 1 1, 0 1"});
    EXPECT_EQ(made.change(changed), "");
    made.solve();
    EXPECT_EQ(made.status(), RunStatus::converged);
}

// The unknowns of the two forms are in different coordinates.
TEST_F(QuadrilateralMeshPde, TheFormMayChangeDuringARun) {
    gaspard::Run made = run("layer-quadrilateral", {"domain.cells=16"});
    made.solve();
    const auto before = made.snapshot();
    Scenario changed = made.scenario();
    apply_settings(*catalogue, changed, {"method.form=both"});
    EXPECT_EQ(made.change(changed), "");
    const auto same = made.snapshot();
    for (std::size_t i = 0; i < before->x.size(); ++i) EXPECT_LT(norm(same->x[i] - before->x[i]), 1e-14);
    made.solve();
    gaspard::Run fresh = run("layer-quadrilateral", {"domain.cells=16", "method.form=both"});
    fresh.solve();
    EXPECT_EQ(made.snapshot()->x.y, fresh.snapshot()->x.y);
}

TEST_F(QuadrilateralMeshPde, ErrorsOfFineMeshesAreMeasuredOnRequest) {
    gaspard::Run made = run("layer-2d", {"domain.cells=68", "method.final_solves=1"});
    made.solve();
    EXPECT_FALSE(made.history().back().value("energy_error").has_value());
    EXPECT_NE(made.snapshot()->field("solution"), nullptr);
    gaspard::Run measured =
        run("layer-2d", {"domain.cells=68", "method.final_solves=1", "method.reference=on"});
    measured.solve();
    EXPECT_TRUE(measured.history().back().value("energy_error").has_value());
}

TEST_F(QuadrilateralMeshPde, InvalidInputIsOneSentence) {
    EXPECT_EQ(complaint("layer-2d", {"domain.corners=0 0, 1 0, 0.2 0.2, 0 1"}),
              "domain.corners are not those of a convex quadrilateral, anticlockwise from the lower left");
    EXPECT_EQ(complaint("layer-2d", {"domain.corners=0 0, 0 1, 1 1, 1 0"}),
              "domain.corners are clockwise; write them anticlockwise from the lower left");
    EXPECT_EQ(complaint("layer-2d", {"domain.corners=0 0, 1 0, 1 1"}),
              "domain.corners lists 3 points, but a quadrilateral has 4");
    EXPECT_EQ(complaint("layer-2d", {"domain.cells=3"}),
              "method.start_cells (4) must not be greater than domain.cells (3)");
    EXPECT_EQ(complaint("layer-2d", {"monitor.width_x=x - 0.5"}).substr(0, 32),
              "monitor.width_x must be positive");
    EXPECT_EQ(complaint("layer-2d", {"pde.source=1/0"}).substr(0, 27), "pde.source is not finite at");
    EXPECT_NE(complaint("layer-2d", {"monitor.type=formula", "monitor.expression=x - 0.5"}), "");
}

} // namespace
} // namespace gaspard
