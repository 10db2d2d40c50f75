#include "core/base/error.hpp"
#include "core/fem/surface_q2.hpp"
#include "core/method/driven.hpp"
#include "core/method/plane_equation.hpp"
#include "core/method/power_monitor.hpp"
#include "core/method/stepper.hpp"
#include "support/largest_distance.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace gaspard {
namespace {

int inner_iterations(const Driven& run) {
    int sum = 0;
    for (const auto& evaluation : run.history) sum += evaluation.inner_iterations;
    return sum;
}

/// Notes of all iterations, one after the other.
std::string notes(const Driven& run) {
    std::string all;
    for (const auto& evaluation : run.history) all += evaluation.note + "\n";
    return all;
}

TEST(Newton, FindsTheMapOfTheRelaxationInFewIterations) {
    struct Case {
        const char* monitor;
        bool periodic;
        int most;
    };
    for (const auto& [type, periodic, most] :
         {Case{"ring", true, 13}, {"bell", true, 21}, {"ring", false, 13}, {"bell", false, 21}}) {
        SCOPED_TRACE(std::string(type) + (periodic ? ", periodic" : ", walls"));
        Driven newton(newton_method(), 48, periodic), relaxed(relaxation_method(), 48, periodic);
        newton.begin(monitor_of(type, periodic));
        relaxed.begin(monitor_of(type, periodic));
        EXPECT_LE(newton.solve(), most);
        relaxed.solve();
        EXPECT_LT(largest_distance(newton.method->positions(), relaxed.method->positions()), 1e-8);
        EXPECT_NEAR(newton.history.back().series[0], relaxed.history.back().series[0], 1e-8);
        EXPECT_EQ(newton.quality().tangled_cells, 0u);
        EXPECT_LT(inner_iterations(newton), 25 * newton.history.size());
    }
}

// To a tenth of the tolerance, below which the linear solver does not go.
TEST(Newton, ConvergesQuadraticallyAtTheEnd) {
    Driven run(newton_method(), 30, true);
    run.begin(monitor_of("ring", true));
    run.solve(1e-9);
    ASSERT_GE(run.history.size(), 4u);
    for (std::size_t k = run.history.size() - 3; k < run.history.size(); ++k) {
        const double before = run.history[k - 1].residual;
        EXPECT_EQ(run.history[k].step_size, 1);
        EXPECT_LT(run.history[k].residual, std::max(20 * before * before, 1e-9)) << k;
    }
}

TEST(Newton, SolvesWhatIsHarsh) {
    struct Case {
        const char* monitor;
        Settings values;
        int most;
    };
    for (const auto& [type, values, most] : {Case{"bell", {{"amplitude", 500}}, 38},
                                             {"bell", {{"amplitude", 5000}}, 42},
                                             {"ring", {{"amplitude", 50}, {"center_x", 0.3}}, 34}}) {
        SCOPED_TRACE(std::string(type) + " " + std::to_string(values[0].second));
        Driven run(newton_method(), 40, true);
        run.begin(monitor_of(type, true, values));
        EXPECT_LE(run.solve(), most);
        EXPECT_EQ(run.quality().tangled_cells, 0u);
    }
}

TEST(Newton, FollowsAMonitorThatMovesALittle) {
    Driven run(newton_method(), 60, true);
    run.begin(monitor_of("ring", true));
    run.solve();
    for (const double x : {0.505, 0.510}) {
        run.begin(monitor_of("ring", true, {{"center_x", x}}));
        EXPECT_LE(run.solve(), 5) << x;
        EXPECT_EQ(notes(run).find("powers"), std::string::npos);
    }
    run.begin(monitor_of("ring", true, {{"center_x", 0.53}}));
    EXPECT_LE(run.solve(), 12);
    EXPECT_EQ(run.quality().tangled_cells, 0u);
}

TEST(Newton, RelaxesWhereNoStepIsAnyGood) { // on a mesh that is too coarse for the path
    Driven run(newton_method(), 30, true);
    run.begin(monitor_of("ring-and-bell", true));
    run.solve();
    EXPECT_NE(notes(run).find("relaxation steps"), std::string::npos) << notes(run);
}

TEST(Newton, SaysWhereItsPathBeginsAndEnds) {
    Driven run(newton_method(), 30, true);
    run.begin(monitor_of("bell", true));
    run.solve();
    EXPECT_NE(run.history[1].note.find("continuation in powers of the monitor, starting with m^0."),
              std::string::npos)
        << notes(run);
    EXPECT_NE(notes(run).find("failed, trying m^"), std::string::npos) << notes(run);
    EXPECT_NE(notes(run).find("solving for the monitor itself"), std::string::npos) << notes(run);
}

TEST(Newton, MovesNothingForAConstantMonitor) {
    for (const auto& type : {newton_method(), quasi_newton_method(), automatic_method()}) {
        Driven run(type, 60, false);
        run.begin(monitor_of("constant", false));
        for (int i = 0; i < 3; ++i) run.method->step(problem_of(*run.monitor), run.state, {});
        EXPECT_LT(largest_distance(run.method->positions(), run.plane->mesh()->nodes), 1e-13) << type.name;
    }
}

TEST(Newton, DoesNotDependOnThreads) {
    std::vector<State> states;
    for (const int threads : {1, 3}) {
        Driven run(newton_method(), 240, true);
        run.method->use_threads(threads);
        run.begin(monitor_of("ring", true));
        for (int i = 0; i < 9; ++i)
            run.history.push_back(run.method->step(problem_of(*run.monitor), run.state, {}));
        states.push_back(run.state);
    }
    EXPECT_EQ(states[0], states[1]);
}

TEST(Newton, LeavesTheMapAsItIsWhenStopped) {
    for (const auto& type : {newton_method(), quasi_newton_method()}) {
        Driven run(type, 30, true);
        run.begin(monitor_of("bell", true));
        for (int i = 0; i < 3; ++i) run.method->step(problem_of(*run.monitor), run.state, {});
        const State before = run.state;
        std::stop_source source;
        source.request_stop();
        const Evaluation same = run.method->step(problem_of(*run.monitor), run.state, source.get_token());
        EXPECT_EQ(run.state, before);
        EXPECT_TRUE(std::isfinite(same.residual));
        EXPECT_GT(run.method->step(problem_of(*run.monitor), run.state, {}).inner_iterations,
                  0); // and goes on
    }
}

// Newton's stepper with an equation whose derivative has the wrong sign.
class Wrong final : public NonlinearProblem {
  public:
    explicit Wrong(std::unique_ptr<NonlinearProblem> right)
        : NonlinearProblem(right->layout(), right->size(), "phi"), right_(std::move(right)) {}
    std::optional<State> adopt(const State& other, const Discretisation* of) override {
        return right_->adopt(other, of);
    }
    State adopt(NonlinearProblem& other, std::span<const double> phi) override {
        return right_->adopt(other, phi);
    }
    std::unique_ptr<NonlinearProblem> coarser(const Progress&, std::stop_token) const override {
        return nullptr;
    }
    Evaluation evaluate(const ProblemData& data, std::span<const double> phi) override {
        return right_->evaluate(data, phi);
    }
    const Points& positions() const override { return right_->positions(); }
    void move(std::span<const double> phi) override { right_->move(phi); }
    std::span<const double> residual() const override { return right_->residual(); }
    IterateShape shape() const override { return right_->shape(); }
    void direction(std::span<double> u) override { right_->direction(u); }
    void linearise(const ProblemData& data, Linearised how) override { right_->linearise(data, how); }
    void derivative(std::span<const double> w, std::span<double> out) override {
        right_->derivative(w, out);
        for (double& value : out) value = -value;
    }
    void precondition(std::span<const double> r, std::span<double> u) override { right_->precondition(r, u); }
    ProblemData continued(const ProblemData& data, double t) const override {
        return right_->continued(data, t);
    }
    std::string name_of_continued(double t) const override { return right_->name_of_continued(t); }

  private:
    std::unique_ptr<NonlinearProblem> right_;
};

TEST(Newton, SaysSoWhereItsStepsAreOfNoUse) {
    const auto monitor = monitor_of("ring", true);
    for (const bool wrong : {false, true}) {
        std::unique_ptr<NonlinearProblem> equation =
            std::make_unique<PlaneEquation>(std::make_shared<PlaneQ2>(LineGrid{20, true}));
        if (wrong) equation = std::make_unique<Wrong>(std::move(equation));
        const auto stepper = make_newton_stepper();
        stepper->begin(*equation, 1e-8);
        std::vector<double> phi(equation->size(), 0.0);
        Iterate now = evaluate(*equation, problem_of(*monitor), phi);
        int steps = 0;
        for (bool lost = false; !lost && now.evaluation.residual > 1e-8 && steps < 30; ++steps) {
            now = stepper->step(problem_of(*monitor), phi, now, {});
            lost = now.lost;
        }
        EXPECT_EQ(now.lost, wrong);
        EXPECT_EQ(now.evaluation.residual < 1e-8, !wrong);
        if (wrong) {
            EXPECT_LE(steps, 5);
            EXPECT_NE(now.evaluation.note.find("relaxation steps"), std::string::npos);
        }
    }
}

TEST(PowerMonitor, HasTheGradientOfItsValues) {
    const auto whole = monitor_of("bell", false);
    const PowerMonitor part(whole, 0.3);
    Points x(3), gradients;
    x.set(0, {0.4, 0.45, 0}), x.set(1, {0.4 + 1e-6, 0.45, 0}), x.set(2, {0.4, 0.45 + 1e-6, 0});
    std::vector<double> m(3), m_whole(3);
    part.values(x, m);
    whole->values(x, m_whole);
    part.gradients(x, gradients);
    EXPECT_NEAR(m[0], std::pow(m_whole[0], 0.3), 1e-14);
    EXPECT_NEAR(gradients.x[0], (m[1] - m[0]) / 1e-6, 1e-4 * std::abs(gradients.x[0]));
    EXPECT_NEAR(gradients.y[0], (m[2] - m[0]) / 1e-6, 1e-4 * std::abs(gradients.y[0]));
}

TEST(QuasiNewton, ConvergesAsThePaperSays) {
    Driven ring(quasi_newton_method(), 30, true);
    ring.begin(monitor_of("ring", true));
    const int iterations = ring.solve();
    EXPECT_GE(iterations, 20);
    EXPECT_LE(iterations, 45);
    Driven newton(newton_method(), 30, true);
    newton.begin(ring.monitor);
    newton.solve();
    EXPECT_LT(largest_distance(newton.method->positions(), ring.method->positions()), 1e-8);
}

TEST(QuasiNewton, FailsForAHarshMonitorAndSaysHow) {
    Driven run(quasi_newton_method(), 20, true);
    run.begin(monitor_of("bell", true, {{"amplitude", 5000}}));
    for (int i = 0; i < 60; ++i) {
        run.history.push_back(run.method->step(problem_of(*run.monitor), run.state, {}));
        ASSERT_TRUE(std::isfinite(run.history.back().residual));
    }
    EXPECT_GT(run.history.back().residual, 1e-3);
    EXPECT_TRUE(notes(run).find("no longer convex") != std::string::npos ||
                notes(run).find("did not converge") != std::string::npos)
        << notes(run);
}

TEST(Automatic, SolvesWhatTheOthersSolveWithoutBeingTold) {
    struct Case {
        const char* monitor;
        Settings values;
        bool newton;
    };
    for (const auto& [type, values, newton] : {Case{"ring", {}, true},
                                               {"bell", {{"amplitude", 500}}, true},
                                               {"ring", {{"amplitude", 0.1}}, false}}) {
        SCOPED_TRACE(std::string(type) + std::to_string(values.size()));
        Driven run(automatic_method(), 40, true);
        run.begin(monitor_of(type, true, values));
        EXPECT_LE(run.solve(), 200);
        EXPECT_EQ(run.quality().tangled_cells, 0u);
        EXPECT_EQ(inner_iterations(run) > 0, newton);
        EXPECT_EQ(notes(run).find("Newton's method takes over") != std::string::npos, newton);
        EXPECT_NE(notes(run).find("accelerated relaxation"), std::string::npos);
    }
}

} // namespace
} // namespace gaspard
