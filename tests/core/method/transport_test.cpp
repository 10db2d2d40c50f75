// Transport between convex domains, from scenarios to meshes.
#include "core/base/error.hpp"
#include "core/method/transport_equation.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "support/messages.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace gaspard {
namespace {

using TransportRun = gaspard::Run;

class TransportTest : public testing::Test {
  protected:
    Scenario with(const std::vector<std::string>& settings, const std::string& name = "transport-ellipse") {
        Scenario scenario = find_scenario(*catalogue, name);
        apply_settings(*catalogue, scenario, settings);
        return scenario;
    }
    TransportRun solved(const std::vector<std::string>& settings) {
        TransportRun run(catalogue, with(settings));
        run.solve();
        return run;
    }
    std::string refusal(const std::vector<std::string>& settings) {
        return message_of<InputError>([&] { TransportRun run(catalogue, with(settings)); });
    }
    /// The largest |gauge - 1| of nodes on the boundary, the last ring; the target is an ellipse around 0.
    static double off_ellipse(const TransportRun& run, double a, double b) {
        const auto snapshot = const_cast<TransportRun&>(run).snapshot();
        double worst = 0;
        for (std::size_t i = 0; i < snapshot->x.size(); ++i)
            if (norm(snapshot->mesh->nodes[i]) > 1 - 1e-9)
                worst = std::max(worst, std::abs(std::hypot(snapshot->x.x[i] / a, snapshot->x.y[i] / b) - 1));
        return worst;
    }
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(TransportTest, DiskGoesToTheEllipse) {
    for (const char* degree : {"1", "2", "3"}) {
        const TransportRun run = solved({std::string("domain.degree=") + degree, "domain.cells=12"});
        EXPECT_EQ(run.status(), RunStatus::converged);
        EXPECT_LT(off_ellipse(run, 2, 3), degree[0] == '1' ? 2e-2 : 2e-3);
        EXPECT_GT(*run.history().back().value("convexity"), 1.8);
        EXPECT_EQ(run.history().back().tangled_cells, 0U);
    }
}

TEST_F(TransportTest, BoundaryAndAreaConvergeToThoseOfTheTarget) {
    const auto errors = [&](const char* cells) {
        TransportRun run = solved({std::string("domain.cells=") + cells});
        const auto snapshot = run.snapshot();
        double area = 0;
        for (std::size_t c = 0; c < snapshot->mesh->cell_count(); ++c) {
            const auto cell = snapshot->mesh->cell(c);
            const auto at = [&](std::size_t i) { return snapshot->x[static_cast<std::size_t>(cell[i])]; };
            area += cross(at(1) - at(0), at(2) - at(0)).z / 2;
        }
        return std::pair(off_ellipse(run, 2, 3), std::abs(area / (6 * std::numbers::pi) - 1));
    };
    const auto [boundary, area] = errors("12");
    const auto [fine_boundary, fine_area] = errors("24");
    EXPECT_GT(std::log2(boundary / fine_boundary), 0.9);
    EXPECT_GT(std::log2(area / fine_area), 1.3);
    EXPECT_LT(fine_area, 1e-2);
}

TEST_F(TransportTest, CellsHaveEqualMassesOfTheMonitorAsMeshesGetFiner) {
    const auto equidistribution = [&](const char* cells) {
        const TransportRun run = solved({std::string("domain.cells=") + cells, "domain.degree=2",
                                         "monitor.type=ring", "monitor.amplitude=3", "monitor.sharpness=5"});
        EXPECT_EQ(run.status(), RunStatus::converged);
        return *run.history().back().value("equidistribution");
    };
    const double coarse = equidistribution("16"), fine = equidistribution("32");
    EXPECT_GT(std::log2(coarse / fine), 1);
    EXPECT_LT(fine, 2e-2);
}

TEST_F(TransportTest, DensityOfTheSourceCounts) {
    // The same density on both sides of equal domains: the identity is the solution.
    const TransportRun run =
        solved({"domain.target.a=1", "domain.target.b=1", "domain.degree=2", "monitor.type=ring",
                "monitor.amplitude=3", "monitor.sharpness=5", "monitor.source.type=ring",
                "monitor.source.amplitude=3", "monitor.source.sharpness=5"});
    EXPECT_EQ(run.status(), RunStatus::converged);
    const auto snapshot = const_cast<TransportRun&>(run).snapshot();
    double far = 0;
    for (std::size_t i = 0; i < snapshot->x.size(); ++i)
        far = std::max(far, norm(snapshot->x[i] - snapshot->mesh->nodes[i]));
    EXPECT_LT(far, 1e-3);
}

TEST_F(TransportTest, AnotherTargetOrMeshStartsFromThePresentMap) {
    TransportRun run = solved({"domain.cells=12"});
    run.change(with({"domain.cells=12", "domain.target.a=3.2"}));
    EXPECT_LT(run.history().back().residual, 0.2) << "from the map to the ellipse before";
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    run.change(with({"domain.cells=24", "domain.target.a=3.2", "domain.degree=2"}));
    EXPECT_LT(run.history().back().residual, 1) << "not from the start";
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
    EXPECT_LT(off_ellipse(run, 2, 3.2), 1e-3);
}

TEST_F(TransportTest, StatesOfOtherMeshesOfTheSourceAreAdopted) {
    TransportRun coarse = solved({"domain.cells=8", "domain.degree=2"});
    RunOptions options;
    options.start = coarse.state();
    TransportRun run(catalogue, with({"domain.cells=12"}), options);
    EXPECT_LT(run.history().front().residual, 0.5);
    EXPECT_THROW(TransportRun(catalogue, with({"domain.a=2"}), options), InputError) << "another source";
}

TEST_F(TransportTest, SourcesAndTargetsAreDraggedWithoutBeginningAnew) {
    TransportRun run = solved({"domain.cells=12"});
    EXPECT_EQ(run.change(with({"domain.cells=12", "domain.a=1.1"})), "");
    EXPECT_LT(run.history().back().residual, 0.3);
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
}

// From the map to one target, Newton's method does not reach the one to another; from the start it does.
TEST_F(TransportTest, MapsThatAreOfNoUseAreGivenUp) {
    const auto egg = [&](const std::string& right) {
        return with(
            {"domain.cells=40", "domain.target.points=" + right +
                                    " 0, 0.9 0.9, -0.4 1, -1.2 0.6, -1.4 0, -1.2 -0.6, -0.4 -1, 0.9 -0.9"},
            "transport-ring");
    };
    TransportRun run(catalogue, egg("1.6"));
    run.solve();
    ASSERT_EQ(run.status(), RunStatus::converged);
    run.change(egg("2.045"));
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::converged);
}

// While coarser meshes are at work, positions and fields of the finest one belong together.
TEST_F(TransportTest, FieldsAreThoseOfThePositions) {
    TransportRun run(catalogue, with({"domain.cells=24", "monitor.type=ring"}));
    bool moved = false;
    for (int i = 0; i < 3; ++i) {
        run.step();
        const auto snapshot = run.snapshot();
        double shown = 0;
        for (const double value : snapshot->field("boundary_defect")->values) shown = std::max(shown, value);
        double off = 0; // the same of the positions: the target is an ellipse around 0
        for (std::size_t k = 0; k < snapshot->x.size(); ++k)
            if (norm(snapshot->mesh->nodes[k]) > 1 - 1e-9) {
                const double x = snapshot->x.x[k], y = snapshot->x.y[k], g = std::hypot(x / 2, y / 3);
                off = std::max(off, std::abs(1 - g * g) / 2 / std::hypot(x / 4, y / 9));
            }
        EXPECT_NEAR(shown, off, 1e-9);
        moved = moved || run.history().back().value("level") > 0;
    }
    EXPECT_TRUE(moved) << "on a coarser mesh";
}

TEST_F(TransportTest, WithoutRecoveryDegreeOneHasNoConvexSolution) {
    TransportRun run(catalogue, with({"method.recovery=false", "method.max_iterations=20"}));
    run.solve();
    EXPECT_LT(*run.history().back().value("convexity"), 0);
    const TransportRun second = solved({"method.recovery=false", "domain.degree=2"});
    EXPECT_EQ(second.status(), RunStatus::converged);
    EXPECT_GT(*second.history().back().value("convexity"), 1.8);
}

TEST_F(TransportTest, ShapesHaveTheirRows) {
    Scenario scenario = with({"domain.shape=polygon", "domain.target.shape=curve"});
    EXPECT_TRUE(scenario.domain.values.has("corner_radius"));
    EXPECT_FALSE(scenario.domain.values.has("a"));
    EXPECT_TRUE(scenario.domain.values.has("target.points"));
    EXPECT_FALSE(scenario.domain.values.has("target.a"));
    const Scenario read = parse_scenario(*catalogue, to_toml(scenario), "again.toml");
    EXPECT_EQ(read.domain, scenario.domain);
    EXPECT_EQ(read.source, scenario.source);
    apply_settings(*catalogue, scenario,
                   {"domain.target.shape=rounded-rectangle", "domain.target.exponent=6"});
    EXPECT_EQ(scenario.domain.values.real("target.exponent"), 6);
}

TEST_F(TransportTest, MonitorsLieOnTheTargetAndSourcesOnTheSource) {
    const Scenario scenario = with({"domain.target.x=100", "monitor.type=ring", "monitor.source.type=ring"});
    EXPECT_NEAR(scenario.monitor.values.real("center_x"), 100, 1e-9);
    EXPECT_NEAR(scenario.source.values.real("center_x"), 0, 1e-9);
    EXPECT_EQ(TransportRun(catalogue, scenario).status(), RunStatus::running);
}

TEST_F(TransportTest, ShapesThatAreNotConvexAreRefused) {
    const std::string square = "domain.target.shape=polygon";
    for (const auto& [settings, sentence] :
         std::initializer_list<std::pair<std::vector<std::string>, std::string>>{
             {{square, "domain.target.points=0 0, 1 0, 0.2 0.2, 0 1"}, "domain.target.points: "},
             {{square, "domain.target.points=0 0, 1 1, 1 0, 0 1"}, "domain.target.points: "},
             {{square, "domain.target.points=0 0, 1 0"}, "3 to 200 points"},
             {{square, "domain.target.points=0 0, 1 0, x"}, "list of points"},
             {{square, "domain.target.corner_radius=9"}, "too large"},
             {{"monitor.type=formula", "monitor.expression=x"}, "must be positive"}})
        EXPECT_NE(refusal(settings).find(sentence), std::string::npos) << refusal(settings);
    EXPECT_NE(message_of<InputError>([&] { with({"domain.target.a=-1"}); }).find("domain.target.a"),
              std::string::npos);
    EXPECT_NE(message_of<InputError>([&] { with({"domain.target.a=1"}, "plane-ring"); }).find("reserved"),
              std::string::npos);
}

} // namespace
} // namespace gaspard
