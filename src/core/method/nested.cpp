#include "core/method/nested.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

constexpr double restart_residual = 0.3; ///< residual above which the iteration starts on the coarsest mesh
constexpr double good_enough = 3e-2;     ///< residual below which a coarser mesh is solved
constexpr int coarse_iterations = 150;   ///< maximum number of iterations on a coarser mesh
constexpr double hopeless = 100;         ///< residual above which a coarser mesh is given up

/// As Nested::series() orders them.
Evaluation with_level(Evaluation evaluation, std::size_t level) {
    evaluation.series.push_back(static_cast<double>(level));
    return evaluation;
}

} // namespace

Nested::Nested(std::unique_ptr<NonlinearProblem> problem, std::unique_ptr<Stepper> stepper,
               const Values& values, const Progress& progress, std::stop_token stop)
    : stepper_(std::move(stepper)) {
    for (; problem; problem = levels_.back()->coarser(progress, stop)) levels_.push_back(std::move(problem));
    configure(values);
    select(0);
}

void Nested::configure(const Values& values) {
    tolerance_ = values.real("tolerance");
    enough_ = std::max(good_enough, tolerance_);
    for (auto& level : levels_) level->configure(values);
}

void Nested::use_threads(int threads) {
    for (auto& level : levels_) level->use_threads(threads);
}

double Nested::other_cpu_seconds() const {
    double sum = 0;
    for (const auto& level : levels_) sum += level->other_cpu_seconds();
    return sum;
}

std::optional<State> Nested::adopt(const State& other, const Discretisation* of) {
    for (const auto& level : levels_) // continue from that level
        if (other.layout == level->layout()) return level->adopt(other, of);
    return levels_[0]->adopt(other, of);
}

Evaluation Nested::evaluate(const ProblemData& data, const State& state, std::stop_token) {
    const auto of_state = std::find_if(levels_.begin(), levels_.end(),
                                       [&](const auto& level) { return level->layout() == state.layout; });
    GASPARD_CHECK(of_state != levels_.end());
    select(static_cast<std::size_t>(of_state - levels_.begin()));
    may_go_down_ = true;
    doubtful_ = false;
    start_.clear();
    from_elsewhere_ = here().unknowns(state) != here().start();
    look_at(data, here().unknowns(state));
    if (level_ == 0) return with_level(now_.evaluation, 0);
    // Report the residual on the finest mesh; a small residual on a coarser one must not end the run.
    const State fine = levels_[0]->adopt(here(), here().unknowns(state));
    prolonged_ = true;
    return with_level(levels_[0]->evaluate(data, fine.arrays[0].values), 0);
}

Evaluation Nested::step(const ProblemData& data, State& state, std::stop_token stop) {
    here().unknowns(state); // checks the layout before anything is changed
    if (std::exchange(may_go_down_, false) && level_ == 0 && now_.evaluation.residual > restart_residual &&
        levels_.size() > 1) {
        start_ = here().unknowns(state);
        go_to(levels_.size() - 1, start_, data, state);
    }
    const std::size_t level_of_update = level_;
    auto& u = here().unknowns(state);
    now_ = stepper_->step(data, u, now_, stop);
    prolonged_ = false;
    if (level_ > 0) u_of_positions_ = u;
    ++iterations_here_;
    const Evaluation update = now_.evaluation;
    const bool late = iterations_here_ >= coarse_iterations;
    const bool lost = now_.lost || !(update.residual < hopeless);
    const bool arrived = update.residual < enough_ || ((late || lost) && update.residual < restart_residual);
    doubtful_ = doubtful_ && !(now_.shape.admissibility > 0);
    bool anew = false;
    if (now_.lost && from_elsewhere_ && here().begins_anew() && !stop.stop_requested()) {
        from_elsewhere_ = false;
        start_ = levels_[0]->start();
        restart(levels_.size() - 1, data, state);
        anew = true;
    } else if (doubtful_ && now_.lost && !stop.stop_requested())
        restart(level_, data, state);
    else if (level_ > 0 && (arrived || late || lost) && !stop.stop_requested())
        go_up(arrived, data, state);
    Evaluation evaluation = now_.evaluation;
    evaluation.step_size = update.step_size;
    evaluation.inner_iterations = update.inner_iterations;
    evaluation.note = update.note;
    evaluation.anew = update.anew || anew;
    if (anew) evaluation.note += "; beginning anew from the start";
    return with_level(std::move(evaluation), level_of_update);
}

const Points& Nested::positions() {
    if (level_ == 0) return levels_[0]->positions();
    if (!std::exchange(prolonged_, true)) {
        const State fine = levels_[0]->adopt(here(), u_of_positions_);
        levels_[0]->move(fine.arrays[0].values);
    }
    return levels_[0]->positions();
}

std::vector<SeriesInfo> Nested::series() const {
    std::vector<SeriesInfo> all = levels_[0]->series();
    all.push_back(level_series());
    return all;
}

std::vector<double> Nested::measures(const ProblemData& data) {
    positions(); // prolongs to the finest mesh, where measures are taken
    return levels_[0]->measures(data);
}

std::vector<std::uint32_t> Nested::folded_cells() {
    positions();
    return levels_[0]->folded_cells();
}

void Nested::select(std::size_t level) {
    level_ = level;
    stepper_->begin(here(), level == 0 ? tolerance_ : enough_);
    iterations_here_ = 0;
}

void Nested::look_at(const ProblemData& data, const std::vector<double>& u) {
    now_ = gaspard::evaluate(here(), data, u);
    prolonged_ = false;
    if (level_ > 0) u_of_positions_ = u;
}

/// Changes to another level; u: unknowns on the current level, which are transferred. From the start to the
/// start, which a stepper recognises.
void Nested::go_to(std::size_t level, const std::vector<double>& u, const ProblemData& data, State& state) {
    NonlinearProblem& next = *levels_[level];
    State there = u == here().start() ? next.state_of(next.start()) : next.adopt(here(), u);
    state = std::move(there); // u may refer to an array of state
    select(level);
    look_at(data, here().unknowns(state));
}

/// Continues on the next finer level; if the result of this level is no use there, restarts from start_ on
/// that level.
void Nested::go_up(bool arrived, const ProblemData& data, State& state) {
    const std::size_t next = level_ - 1;
    if (arrived) go_to(next, here().unknowns(state), data, state);
    if (arrived && (now_.shape.admissibility > 0 || now_.evaluation.residual < restart_residual)) {
        doubtful_ = !(now_.shape.admissibility > 0);
        if (level_ > 0 && now_.evaluation.residual < enough_) go_up(true, data, state); // already solved
        return;
    }
    restart(next, data, state);
}

void Nested::restart(std::size_t level, const ProblemData& data, State& state) {
    doubtful_ = false;
    if (start_.empty()) start_ = levels_[0]->start(); // the run started on a coarser level
    select(0);
    go_to(level, start_, data, state);
}

MethodType nested_method(std::string name, std::string label, std::string help,
                         std::function<std::unique_ptr<Stepper>()> stepper) {
    return {.name = std::move(name),
            .label = std::move(label),
            .help = std::move(help),
            .rows = {},
            .make = [stepper = std::move(stepper)](const MethodContext& context,
                                                   const Values& values) -> std::unique_ptr<Method> {
                return std::make_unique<Nested>(context.problem(), stepper(), values, context.progress,
                                                context.stop);
            }};
}

} // namespace gaspard
