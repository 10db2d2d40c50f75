// Time steps that the expected map does not solve: what they try, and what that counts.
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"
#include "core/session/time_series.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace gaspard {
namespace {

struct Count {
    int steps = 0;
    int last = 1 << 30; ///< after so many the residual is not finite
};

/// Another method, whose iterations are counted.
class CountedMethod : public Method {
  public:
    CountedMethod(std::unique_ptr<Method> method, Count& count) : method_(std::move(method)), count_(count) {}
    State initial_state() const override { return method_->initial_state(); }
    std::optional<State> adopt(const State& other, const Discretisation* of) override {
        return method_->adopt(other, of);
    }
    Evaluation evaluate(const ProblemData& data, const State& state, std::stop_token stop) override {
        return finite_at_first(method_->evaluate(data, state, stop));
    }
    Evaluation step(const ProblemData& data, State& state, std::stop_token stop) override {
        ++count_.steps;
        return finite_at_first(method_->step(data, state, stop));
    }
    const Points& positions() override { return method_->positions(); }
    std::vector<SeriesInfo> series() const override { return method_->series(); }
    std::vector<double> measures(const ProblemData& data) override { return method_->measures(data); }
    void configure(const Values& values) override { method_->configure(values); }

  private:
    Evaluation finite_at_first(Evaluation evaluation) const {
        if (count_.steps > count_.last) evaluation.residual = std::numeric_limits<double>::infinity();
        return evaluation;
    }
    std::unique_ptr<Method> method_;
    Count& count_;
};

class UnsolvedStepTest : public testing::Test {
  protected:
    Scenario scenario(const std::vector<std::string>& settings) const {
        Scenario made = find_scenario(*catalogue, "plane-ring");
        apply_settings(*catalogue, made, {"method.type=newton", "time.end=1"});
        apply_settings(*catalogue, made, settings);
        return made;
    }
    std::shared_ptr<Catalogue> catalogue = std::make_shared<Catalogue>(builtin_catalogue());
};

/// The ring jumps, and between a quarter and three quarters of each step its monitor cannot be made: of all
/// attempts only that from the uniform mesh solves some steps.
TEST_F(UnsolvedStepTest, BeginsWithTheUniformMeshAtLast) {
    struct Case {
        const char *cells, *iterations, *step, *sharpness;
    };
    for (const Case& one :
         {Case{"8", "20", "0.1", "200"}, {"8", "40", "0.1", "200"}, {"10", "15", "0.05", "800"}}) {
        const std::string step = one.step, sharpness = one.sharpness;
        const Scenario moving = scenario(
            {std::string("domain.cells=") + one.cells, std::string("time.iterations=") + one.iterations,
             "time.step=" + step, "monitor.type=formula",
             "monitor.expression=1+10/cosh(" + sharpness + "*(dist(0.5+t,0.5)^2-0.0625))^2+(cos(2*pi*t/" +
                 step + ")<0.5?log(-1):0)"});
        gaspard::Run run(catalogue, moving);
        while (run.status() == RunStatus::running) {
            run.step();
            const StepReport& report = run.history().back();
            if (!is_time_step(report)) continue;
            EXPECT_LT(report.residual, 0.1) << one.cells << ", t = " << *run.time();
            Scenario still = moving; // the monitor is that of the time that is reported
            apply_settings(*catalogue, still, {"time.end=0", "monitor.t=" + format_number(*run.time())});
            const gaspard::Run again(catalogue, still, {.start = run.state()});
            EXPECT_NEAR(again.history().front().residual, report.residual, 1e-12 + 1e-6 * report.residual)
                << one.cells << ", t = " << *run.time();
        }
        EXPECT_EQ(run.status(), RunStatus::converged) << one.cells << ": " << run.history().back().note;
    }
}

TEST_F(UnsolvedStepTest, CountsTheIterationsOfEveryAttempt) {
    Count count;
    MethodType& newton = *std::ranges::find(catalogue->methods, std::string("newton"),
                                            [](const auto& type) { return type.name; });
    newton.make = [make = newton.make, &count](const MethodContext& context, const Values& values) {
        return std::make_unique<CountedMethod>(make(context, values), count);
    };
    for (const std::vector<std::string>& settings :
         {// steps that are made again, since what was learnt is too little
          std::vector<std::string>{"domain.cells=20", "monitor.sharpness=60", "time.end=0.14",
                                   "time.step=0.02", "method.diagnostics_every=1",
                                   "time.monitor.center_x=center_x + 0.1*t",
                                   "time.monitor.amplitude=amplitude*(1 + 20*t)"},
          // steps that are divided
          {"domain.cells=16", "time.step=0.1", "time.iterations=3", "time.monitor.center_x=center_x + t"},
          // a step that is given up
          {"domain.cells=16", "time.step=0.1", "monitor.type=formula",
           "monitor.expression=1 + 5*exp(-40*(x-0.5-t)^2) + (t > 0.25 ? log(-1) : 0)"}}) {
        count = {};
        gaspard::Run run(catalogue, scenario(settings));
        run.solve();
        EXPECT_GT(count.steps, 10);
        EXPECT_EQ(run.history().back().all_iterations, count.steps) << settings.back();
        int before = 0; // and each row has its own
        for (const StepReport& report : run.history()) {
            const auto own = report.value(time_names::iterations);
            const int made = own ? static_cast<int>(*own) : report.iteration > 0 ? 1 : 0;
            EXPECT_EQ(report.all_iterations, before + made);
            before = report.all_iterations;
        }
    }
    count = {.last = 20}; // in the middle of a time step
    gaspard::Run run(catalogue, scenario({"domain.cells=16", "time.step=0.1", "time.rule=tolerance",
                                          "time.monitor.center_x=center_x + t"}));
    run.solve();
    EXPECT_EQ(run.status(), RunStatus::diverged);
    EXPECT_TRUE(is_given_up(run.history().back()));
    EXPECT_GT(*run.history().back().value(time_names::iterations), 0);
    EXPECT_EQ(run.history().back().all_iterations, count.steps);
}

} // namespace
} // namespace gaspard
