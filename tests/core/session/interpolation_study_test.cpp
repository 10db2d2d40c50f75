// Interpolation errors of runs: fields, series, snapshots, the table against the number of cells, and files.
#include "core/base/error.hpp"
#include "core/io/interpolation_files.hpp"
#include "core/io/run_files.hpp"
#include "core/session/interpolation_study.hpp"
#include "core/session/solver_thread.hpp"
#include "core/tessellate/colouring.hpp"
#include "support/layer.hpp"
#include "support/messages.hpp"
#include "support/solved_run.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace gaspard {
namespace {

using namespace std::chrono_literals;

const std::vector<std::string> quick{"domain.cells=16", "method.type=auto", "method.tolerance=1e-6"};

std::vector<std::string> with(std::vector<std::string> settings, const std::string& further) {
    settings.push_back(further);
    return settings;
}

TEST(InterpolationOfRuns, OnSurfacesInSpaceAndDisksHasTheKnownOrders) {
    for (const char* name : {"spline-torus", "spline-moebius", "spline-circle"}) {
        SCOPED_TRACE(name);
        const FunctionOf u([](Vec3 p) { return std::sin(p.x) * p.y + p.z * p.z; },
                           [](Vec3 p) {
                               return Vec3{std::cos(p.x) * p.y, std::sin(p.x), 2 * p.z};
                           });
        std::vector<InterpolationError> errors;
        for (const char* cells : {"domain.cells=16", "domain.cells=32"}) {
            const gaspard::Run run = solved_run(name, {cells, "monitor.type=constant"});
            const Mesh& mesh = *run.discretisation().mesh();
            errors.push_back(interpolation_error(mesh, mesh.nodes, run.space(), u));
            EXPECT_EQ(errors.back().tangled_cells, 0u);
        }
        EXPECT_NEAR(std::log2(errors[0].of(ErrorNorm::l2) / errors[1].of(ErrorNorm::l2)), 2, 0.1);
        EXPECT_NEAR(std::log2(errors[0].of(ErrorNorm::h1) / errors[1].of(ErrorNorm::h1)), 1, 0.1);
    }
}

/// Density m with its own u.
class WithSolution final : public Monitor {
  public:
    WithSolution(std::function<double(double)> density, std::shared_ptr<const ScalarFunction> u)
        : density_(std::move(density)), u_(std::move(u)) {}
    void values(const Points& x, std::span<double> values) const override {
        for (std::size_t i = 0; i < x.size(); ++i) values[i] = density_(x.x[i]);
    }
    std::shared_ptr<const ScalarFunction> solution() const override { return u_; }

  private:
    std::function<double(double)> density_;
    std::shared_ptr<const ScalarFunction> u_;
};

gaspard::Run solved_layer(std::function<double(double)> density, double width) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "walls-ring");
    apply_settings(*catalogue, scenario, {"domain.cells=80", "method.type=auto"});
    gaspard::Run run(catalogue, scenario,
                     {.monitor = std::make_shared<WithSolution>(std::move(density),
                                                                std::make_shared<FunctionOf>(layer(width)))});
    run.solve();
    return run;
}

TEST(InterpolationOfRuns, FallsByTheFactorOfTheory) {
    constexpr double width = 0.08;
    // Smooth where the second derivative vanishes.
    const double least = 1e-3 * bend_square(width, 0.5 + 0.66 * width);
    const auto density = [=](double x) { return std::pow(bend_square(width, x) + least, 0.2); };
    gaspard::Run run = solved_layer(density, width);
    ASSERT_EQ(run.status(), RunStatus::converged);
    const auto errors = run.interpolation();
    ASSERT_NE(errors, nullptr);
    const double expected = factor_of(width, density);
    EXPECT_GT(expected, 1.5);
    EXPECT_NEAR(errors->ratio(ErrorNorm::l2), expected, 0.05 * expected);
}

TEST(InterpolationOfRuns, DoesNotFallOnAMeshThatDoesNotMove) {
    gaspard::Run run = solved_layer([](double) { return 1.0; }, 0.05);
    const auto errors = run.interpolation();
    ASSERT_NE(errors, nullptr);
    EXPECT_FALSE(errors->exact());
    for (const ErrorNorm norm : error_norms) {
        EXPECT_GT(errors->uniform->of(norm), 0);
        EXPECT_EQ(errors->ratio(norm), 1); // exactly
    }
}

TEST(InterpolationOfRuns, IsInReportsAndSnapshotsOnceItIsMeasured) {
    gaspard::Run run = solved_run("plane-ring", quick);
    EXPECT_EQ(run.snapshot()->interpolation, nullptr);
    EXPECT_FALSE(run.history().back().value("l2_error"));
    const auto errors = run.interpolation();
    ASSERT_NE(errors, nullptr);
    EXPECT_EQ(run.interpolation(), errors); // not measured again
    const auto snapshot = run.snapshot();
    EXPECT_EQ(snapshot->interpolation, errors);
    EXPECT_EQ(errors->version, snapshot->version);
    EXPECT_EQ(run.history().back().value("l2_error"), errors->adapted->of(ErrorNorm::l2));
    EXPECT_EQ(run.history().back().value("h1_error_uniform"), errors->uniform->of(ErrorNorm::h1));
    // Colours of both meshes span the same range.
    const auto adapted = make_colouring(*snapshot, {.colouring = "interpolation_error"}),
               uniform = make_colouring(*snapshot, {.colouring = "interpolation_error_uniform"});
    ASSERT_TRUE(adapted && uniform);
    EXPECT_EQ(adapted->range.low, uniform->range.low);
    EXPECT_EQ(adapted->range.high, uniform->range.high);
    EXPECT_EQ(adapted->range.high, errors->range(ErrorNorm::l2).second);
    EXPECT_NE(adapted->values, uniform->values);
    const Field* ratio = snapshot->field("interpolation_ratio");
    ASSERT_NE(ratio, nullptr);
    const auto worst =
        static_cast<std::size_t>(std::ranges::max_element(uniform->values) - uniform->values.begin());
    EXPECT_GT(uniform->values[worst], 0);
    EXPECT_DOUBLE_EQ(ratio->values[worst], uniform->values[worst] / adapted->values[worst]);
}

TEST(InterpolationOfRuns, FollowsTheMeshAndTheMonitor) {
    gaspard::Run run = solved_run("plane-ring", quick);
    const auto before = run.interpolation();
    Scenario changed = run.scenario();
    const auto catalogue = builtin_catalogue();
    set_value(catalogue, changed, "monitor.amplitude", 20.0);
    run.change(changed);
    EXPECT_EQ(run.snapshot()->interpolation, before); // until it is measured again
    run.solve();
    const auto after = run.interpolation();
    EXPECT_NE(after->uniform->of(ErrorNorm::l2), before->uniform->of(ErrorNorm::l2));
    run.reset();
    for (const ErrorNorm norm : error_norms) EXPECT_EQ(run.interpolation()->ratio(norm), 1);
}

TEST(InterpolationOfRuns, CanBeSwitchedOff) {
    for (const char* setting : {"method.interpolation=false", "method.diagnostics=geometry"}) {
        gaspard::Run run = solved_run("plane-ring", with(quick, setting));
        EXPECT_EQ(run.interpolation(), nullptr);
        EXPECT_EQ(run.snapshot()->field("interpolation_error"), nullptr);
        EXPECT_TRUE(nlohmann::json::parse(summary_json(run))["interpolation"].is_null());
    }
}

TEST(InterpolationOfRuns, IsInTheSummaryUnlessTheFunctionIsConstant) {
    gaspard::Run run = solved_run("plane-ring", quick);
    const auto json = nlohmann::json::parse(summary_json(run))["interpolation"];
    EXPECT_EQ(json["uniform"]["l2"], run.interpolation({.tolerance = 1e-2})->uniform->of(ErrorNorm::l2));
    EXPECT_GT(json["adapted"]["h1"], 0);
    EXPECT_EQ(json["ratio"]["l2"], json["uniform"]["l2"].get<double>() / json["adapted"]["l2"].get<double>());
    EXPECT_EQ(json["adapted"]["tangled_cells"], 0);
    gaspard::Run constant = solved_run("plane-ring", with(quick, "monitor.type=constant"));
    EXPECT_TRUE(nlohmann::json::parse(summary_json(constant))["interpolation"].is_null());
    EXPECT_EQ(constant.snapshot()->field("interpolation_error"), nullptr);
}

TEST(InterpolationOfRuns, IsMeasuredByTheSolverThreadIfItMayTakeTime) {
    const auto catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
    Scenario scenario = find_scenario(*catalogue, "plane-ring");
    apply_settings(*catalogue, scenario, quick);
    for (const double share : {0.0, 0.1}) {
        SolverThread thread(catalogue, scenario, {.interpolation_share = share});
        std::promise<bool> measured;
        const auto look = [&](gaspard::Run& run, const Activity&) {
            run.solve();
            measured.set_value(true);
        };
        thread.post(InspectCommand{look});
        ASSERT_EQ(measured.get_future().wait_for(60s), std::future_status::ready);
        std::promise<void> published; // the snapshot of what the task has made
        thread.post(InspectCommand{[&](gaspard::Run&, const Activity&) { published.set_value(); }});
        ASSERT_EQ(published.get_future().wait_for(60s), std::future_status::ready);
        const auto snapshot = thread.latest();
        ASSERT_EQ(snapshot->report.status, RunStatus::converged);
        EXPECT_EQ(snapshot->interpolation != nullptr, share > 0);
        if (share == 0) continue;
        EXPECT_EQ(snapshot->interpolation->version, snapshot->version);
        EXPECT_EQ(snapshot->report.value("l2_error"), snapshot->interpolation->adapted->of(ErrorNorm::l2));
        const auto events = thread.drain();
        EXPECT_TRUE(events.back().report.value("h1_error_uniform"));
    }
}

class StudyTest : public testing::Test {
  protected:
    Scenario scenario(const std::string& name, const std::vector<std::string>& settings = {}) const {
        Scenario of = find_scenario(*catalogue, name);
        apply_settings(*catalogue, of, settings);
        return of;
    }
    std::shared_ptr<const Catalogue> catalogue = std::make_shared<const Catalogue>(builtin_catalogue());
};

TEST_F(StudyTest, ChoosesAndReadsResolutions) {
    using Numbers = std::vector<std::int64_t>;
    EXPECT_EQ(usual_resolutions(scenario("plane-ring")), (Numbers{30, 60, 120}));
    EXPECT_EQ(usual_resolutions(scenario("plane-ring", {"domain.cells=200"})), (Numbers{100, 200}));
    EXPECT_EQ(usual_resolutions(scenario("plane-ring", {"domain.cells=5"})), (Numbers{5, 10}));
    EXPECT_EQ(usual_resolutions(scenario("sphere-cross", {"domain.refinements=3"})), (Numbers{2, 3, 4}));
    EXPECT_EQ(parse_resolutions(scenario("plane-ring"), "60,15"), (Numbers{15, 60}));
    const auto refused = [&](const char* text) {
        return message_of<InputError>([&] { parse_resolutions(scenario("plane-ring"), text); });
    };
    EXPECT_NE(refused("15,x").find("15,30,60"), std::string::npos);
    EXPECT_NE(refused("").find("list of integers"), std::string::npos);
    EXPECT_NE(refused("2").find("4 to 480"), std::string::npos);
    EXPECT_NE(refused("15,15").find("twice"), std::string::npos);
}

TEST_F(StudyTest, HasRowsWithOrders) {
    std::vector<InterpolationRow> rows;
    const Scenario bell =
        scenario("plane-bell", {"method.type=auto", "monitor.amplitude=3", "monitor.sharpness=30"});
    for (const std::int64_t n : {20, 40}) {
        gaspard::Run run(catalogue, with_resolution(*catalogue, bell, n));
        run.solve();
        rows.push_back(interpolation_row(run, rows.empty() ? nullptr : &rows.back()));
    }
    EXPECT_EQ(rows[1].cells, 1600u);
    EXPECT_TRUE(std::isnan(rows[0].uniform_order[0]));
    const auto norm = [&](std::size_t row, ErrorNorm which) { return rows[row].errors.adapted->of(which); };
    EXPECT_DOUBLE_EQ(rows[1].adapted_order[0], std::log2(norm(0, ErrorNorm::l2) / norm(1, ErrorNorm::l2)));
    EXPECT_NEAR(rows[1].adapted_order[0], 2, 0.3);
    EXPECT_NEAR(rows[1].adapted_order[2], 1, 0.3);
    // The cells at the foot of a bell, where it is curved, are long across its slope.
    EXPECT_NEAR(rows[1].errors.ratio(ErrorNorm::l2), 0.8, 0.05);
    EXPECT_EQ(interpolation_note(rows[1]), "");
    const std::string csv = why_csv(rows);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
    const auto json = nlohmann::json::parse(why_json(bell, rows));
    EXPECT_EQ(json["scenario"], "plane-bell");
    EXPECT_EQ(json["rows"][1]["adapted"]["l2"], norm(1, ErrorNorm::l2));
    EXPECT_TRUE(json["rows"][0]["uniform"]["order"]["l2"].is_null());
    const Plot plot = why_plot(rows);
    ASSERT_EQ(plot.curves.size(), 6u);
    EXPECT_EQ(plot.curves[1].x, (std::vector<double>{400, 1600}));
    EXPECT_EQ(plot.curves[1].y[1], norm(1, ErrorNorm::l2));
}

} // namespace
} // namespace gaspard
