#include "core/session/time_step.hpp"

#include "core/base/error.hpp"
#include "core/base/short_number.hpp"
#include "core/base/stopwatch.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/scenario/time_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

constexpr int most_parts = 8;          // of a time step that is not solved at once
constexpr int most_learning = 1000;    // iterations of a step that learns
constexpr int most_returning = 200;    // iterations on coarser meshes, until the fine one is reached
constexpr double runaway_factor = 1e3; // a time step is given up if its criterion grows so much
constexpr double far = 0.1;            // criterion: counted iterations that do not come nearer may lead away

std::optional<int> degree_of(const Values& time) {
    const std::string& choice = time.text("extrapolation");
    if (choice == "auto") return std::nullopt;
    return choice == "none" ? 0 : choice == "linear" ? 1 : 2;
}

/// Whether nodes have moved by more than rounding; the unknowns may differ by what moves no node.
bool moved(const Points& before, const Points& after) {
    constexpr double rounding = 1e-9;
    double size = 0, distance = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        size = std::max(size, norm(before[i]));
        distance = std::max(distance, norm(after[i] - before[i]));
    }
    return distance > rounding * size;
}

/// before + share (after - before), of states of one layout.
State between(const State& before, State after, double share) {
    for (std::size_t k = 0; k < before.arrays.size(); ++k)
        for (std::size_t i = 0; i < before.arrays[k].values.size(); ++i) {
            double& value = after.arrays[k].values[i];
            value = before.arrays[k].values[i] + share * (value - before.arrays[k].values[i]);
        }
    return after;
}

} // namespace

/// Tells the method how far it is to solve, as long as this lives.
class Run::TimeStep::LooserMethod {
  public:
    LooserMethod(Course& course, double aim)
        : method_(*course.method), values_(course.problem.scenario.method.values) {
        Values values = values_;
        values.set("tolerance", std::clamp(aim, 1e-14, 1.0)); // the range of its row
        method_.configure(values);
    }
    ~LooserMethod() { method_.configure(values_); }
    LooserMethod(const LooserMethod&) = delete;
    LooserMethod& operator=(const LooserMethod&) = delete;

  private:
    Method& method_;
    const Values& values_;
};

Run::TimeStep::TimeStep(const Run& run, Course& course, std::stop_token stop)
    : run_(run), course_(course), stop_(std::move(stop)), time_(course.problem.scenario.time),
      rule_(time_.text("rule")) {}

Run::StepMesh Run::TimeStep::make(const Following& following) {
    Attempt made = follow(following);
    if (!(made.state == course_.state)) { // the method's last evaluation is of another attempt
        set_time(following, following.time());
        course_.state = std::move(made.state);
        course_.method->evaluate(course_.data, course_.state, stop_);
    }
    return {std::move(made.evaluation), made.solved,      iterations_,
            inner_iterations_,          monitor_seconds_, std::move(made.samples)};
}

Run::TimeStep::Attempt Run::TimeStep::follow(const Following& following) {
    const double from = following.before_time, to = following.time();
    const State before = course_.state;
    set_time(following, to);
    if (rule_ == time_rule::relaxation) return relax(to - from, *following.before);
    const bool samples = rule_ == time_rule::equidistribution && following.tolerance->learns();
    const double aim = following.tolerance ? following.tolerance->aim() : smallest();
    const bool counted = rule_ == time_rule::iterations; // then every attempt is solved
    const State expected = following.maps.at(to, degree_of(time_));
    Attempt best = solve(expected, aim, samples);
    const auto keep = [&](Attempt attempt) {
        const bool nearer = attempt.criterion < best.criterion;
        if (attempt.solved == best.solved ? nearer : attempt.solved) best = std::move(attempt);
    };
    const auto good = [&] { return best.solved && (!counted || best.criterion < far); };
    if (!good() && !(expected == before)) keep(solve(before, aim, samples));
    for (int parts = 2; !best.solved && !counted && parts <= most_parts; parts *= 2)
        keep(follow_in_parts(following, before, aim, samples, parts));
    if (good()) return best;
    State identity = course_.method->initial_state();
    if (!counted || best.criterion >= criterion_of(identity)) keep(solve(std::move(identity), aim, samples));
    return best;
}

/// An attempt with an infinite criterion if a part is not solved.
Run::TimeStep::Attempt Run::TimeStep::follow_in_parts(const Following& following, const State& before,
                                                      double aim, bool samples, int parts) {
    const double from = following.before_time, to = following.time();
    Attempt attempt{.evaluation = {}, .state = before, .solved = true};
    for (int part = 1; part < parts && attempt.solved; ++part) {
        try {
            set_time(following, from + part * (to - from) / parts);
        } catch (const InputError&) { // the monitor cannot be made in between, where no mesh is wanted
            attempt.solved = false;
            break;
        }
        attempt = solve(std::move(attempt.state), aim, false);
    }
    set_time(following, to);
    if (attempt.solved) return solve(std::move(attempt.state), aim, samples);
    attempt.criterion = std::numeric_limits<double>::infinity();
    return attempt;
}

/// The data of the problem at a time.
void Run::TimeStep::set_time(const Following& following, double t) {
    const Stopwatch watch;
    const Scenario now = following.clock->at(t); // its errors name the time
    try {
        course_.data =
            make_problem_data(*run_.catalogue_, now, course_.own, run_.monitor_context(course_, {}, stop_));
    } catch (const InputError& error) {
        throw InputError(std::string(error.what()) + ", at t = " + short_number(t, 6));
    }
    course_.data.stop = stop_;
    monitor_seconds_ += watch.seconds();
}

/// What the criterion must be below.
double Run::TimeStep::smallest() const {
    const Values& method = course_.problem.scenario.method.values;
    const auto own = time_.real_or_auto("tolerance");
    return rule_ == time_rule::tolerance && own ? *own : method.real("tolerance");
}

double Run::TimeStep::criterion(const Evaluation& evaluation) const {
    StepReport report{.residual = evaluation.residual, .series = course_.series};
    run_.take_series(course_, evaluation.series, report);
    const double value = *report.value(course_.series->criterion());
    return std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
}

double Run::TimeStep::criterion_of(const State& state) {
    return criterion(course_.method->evaluate(course_.data, state, stop_));
}

StepTolerance::Sample Run::TimeStep::sample(double residual) {
    const MeshQuality& quality = course_.meter->measure(course_.method->positions(), *course_.data.monitor);
    return {residual, quality.equidistribution};
}

Evaluation Run::TimeStep::step() {
    Evaluation evaluation = course_.method->step(course_.data, course_.state, stop_);
    if (stop_.stop_requested()) throw Interrupted();
    ++iterations_;
    inner_iterations_ += evaluation.inner_iterations;
    return evaluation;
}

/// Iterates from a state.
Run::TimeStep::Attempt Run::TimeStep::solve(State start, double aim, bool samples) {
    const LooserMethod looser(course_, aim);
    course_.state = std::move(start);
    const std::string layout = course_.state.layout;
    const bool counted = rule_ == time_rule::iterations;
    const auto limit = static_cast<int>(time_.integer("iterations"));
    const int most = samples ? std::max(most_learning, limit) : limit;
    Attempt attempt{.evaluation = course_.method->evaluate(course_.data, course_.state, stop_), .state = {}};
    double first = 0;
    for (int iterations = 0;; ++iterations) {
        attempt.criterion = criterion(attempt.evaluation);
        const double reached = attempt.criterion;
        if (samples && std::isfinite(reached)) attempt.samples.push_back(sample(reached));
        if (iterations == 0) first = std::max(1.0, reached);
        if (!std::isfinite(reached) || reached > runaway_factor * first) break;
        const bool fine = course_.state.layout == layout;
        const bool enough = counted ? iterations >= most && fine
                                    : reached < aim && attempt.evaluation.ending == Ending::by_criterion;
        attempt.solved = enough || attempt.evaluation.ending == Ending::complete;
        if (attempt.solved || iterations >= most + (counted ? most_returning : 0)) break;
        attempt.evaluation = step();
    }
    attempt.state = course_.state;
    return attempt;
}

/// Methods of nested iteration may go to coarser meshes, also more than once, and return with nothing done:
/// the iteration that counts is one that moves the mesh.
Run::TimeStep::Attempt Run::TimeStep::relax(double dt, const Points& nodes) {
    const State before = course_.state;
    const double first =
        std::max(1.0, criterion(course_.method->evaluate(course_.data, course_.state, stop_)));
    Evaluation last;
    const auto arrived = [&] {
        return course_.state.layout == before.layout &&
               (moved(nodes, course_.method->positions()) || criterion(last) < smallest());
    };
    for (int i = 0; i < most_returning && (i == 0 || !arrived()); ++i) last = step();
    Attempt attempt{.evaluation = {}, .state = before};
    const bool usable = arrived() && criterion(last) <= runaway_factor * first;
    if (usable) attempt.state = between(before, course_.state, -std::expm1(-dt / time_.real("tau")));
    course_.state = attempt.state;
    attempt.evaluation = course_.method->evaluate(course_.data, course_.state, stop_);
    attempt.evaluation.step_size = last.step_size;
    attempt.criterion = criterion(attempt.evaluation);
    attempt.solved = usable && std::isfinite(attempt.criterion);
    return attempt;
}

} // namespace gaspard
