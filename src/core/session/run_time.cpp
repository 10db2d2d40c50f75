// Runs whose scenario has time: once the mesh of the first time is solved, every step of the run is a time
// step t_{k-1} -> t_k.
//
//   rule relaxation   tau d/dt s = s*(t) - s,  so  s_k = s_{k-1} + (1 - exp(-dt / tau)) (s* - s_{k-1})
//   other rules       s_k = s*(t_k) up to a residual, from a start that is extrapolated (extrapolation.hpp)
//
// where s*(t) is the map for the monitor at time t, in the first line approximated by one iteration
// (time_step.hpp). If a step is not solved, it begins again from s_{k-1}, then goes there in 2, 4 or 8 parts,
// and at last begins from the identity map.
#include "core/base/check.hpp"
#include "core/base/short_number.hpp"
#include "core/diagnostics/exact_map.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/session/following.hpp"
#include "core/session/history_thinning.hpp"
#include "core/session/run.hpp"
#include "core/session/run_timer.hpp"
#include "core/session/time_series.hpp"
#include "core/session/time_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

double fastest(const Points& x, const Points& before, double dt) {
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, norm(x[i] - before[i]));
    return largest / dt;
}

} // namespace

std::optional<double> Run::time() const {
    return now_.following ? std::optional(now_.following->time()) : std::nullopt;
}

/// The exact map for the present monitor, where one is known.
void Run::find_exact(Course& course) const {
    course.exact.reset();
    if (diagnostics(course) != Diagnostics::full) return;
    if (course.series && course.following && !course.series->find(exact_series().front().name)) return;
    if (space_of(*catalogue_, course.problem.scenario).kind == SpaceKind::sphere)
        if (const auto map = ExactMap::of(*course.data.monitor))
            course.exact = std::make_shared<Points>(map->apply(course.discretisation->mesh()->nodes));
    if (!course.exact) course.exact = course.method->exact(course.data);
}

bool Run::moves() const {
    return status() == RunStatus::running && now_.following && now_.following->arrived;
}

ProblemData Run::data_of(const Course& course, const Progress& progress, std::stop_token stop) const {
    const MonitorContext context = monitor_context(course, progress, stop);
    if (!course.following)
        return make_problem_data(*catalogue_, course.problem.scenario, course.own, context);
    const Following& following = *course.following;
    return make_problem_data(*catalogue_, following.clock->at(following.time()), course.own, context);
}

/// At the time t, or its nearest step; nullopt: at the start.
void Run::set_clock(Course& course, std::optional<double> t) const {
    course.following.reset();
    if (course.own) return; // the caller's monitor, which the caller moves
    const auto clock = make_clock(course.problem.scenario);
    if (!clock) return;
    course.following =
        std::make_shared<const Following>(Following{.clock = clock, .step = t ? clock->nearest(*t) : 0});
}

/// With a new history: the mesh of the present time comes first.
void Run::restart_following(Course& course) {
    if (course.following)
        course.following = std::make_shared<const Following>(
            Following{.clock = course.following->clock, .step = course.following->step});
}

/// Whether the first mesh is solved, and time is to pass.
bool Run::arrives(const Course& course, const StepReport& report) {
    return course.following && report.status == RunStatus::converged && !course.following->ends();
}

/// The run goes on, in time.
void Run::arrive(Course& course, StepReport& report) {
    auto following = std::make_shared<Following>(*course.following);
    following->arrived = true;
    following->maps.begin(following->time(), course.state);
    following->tolerance.reset();
    course.following = std::move(following);
    report.status = RunStatus::running;
}

void Run::add_time(const Course& course, StepReport& report) {
    if (course.following) report.set(time_names::time, course.following->time());
}

void Run::add_velocity(const Course& course, Snapshot& snapshot) {
    if (!course.following) return;
    const int dimension = snapshot.mesh->space_dimension;
    std::vector<Field> fields;
    for (const FieldInfo& info : velocity_fields(dimension))
        fields.push_back({info, std::vector<double>(snapshot.x.size())});
    if (const auto& before = course.following->before) {
        const double dt = course.following->time() - course.following->before_time;
        for (std::size_t i = 0; i < snapshot.x.size(); ++i) {
            const Vec3 v = (1 / dt) * (snapshot.x[i] - (*before)[i]);
            const std::array<double, 3> components{v.x, v.y, v.z};
            fields[0].values[i] = norm(v);
            for (std::size_t k = 0; k + 1 < fields.size(); ++k) fields[k + 1].values[i] = components[k];
        }
    }
    for (Field& field : fields) snapshot.fields.push_back(std::move(field));
}

/// What is reported of a time step and of the run, in time.
StepReport Run::report_step(Course& next, const StepMesh& mesh, int iteration, int time_steps) const {
    const Following& following = *next.following;
    StepReport report{.iteration = iteration,
                      .residual = mesh.evaluation.residual,
                      .step_size = mesh.evaluation.step_size,
                      .inner_iterations = mesh.inner_iterations,
                      .note = mesh.solved ? "" : "the time step is not solved",
                      .series = next.series};
    take_series(next, mesh.evaluation.series, report);
    add_time(next, report);
    report.set(time_names::iterations, mesh.iterations);
    report.set(time_names::monitor, mesh.monitor_seconds);
    report.set(time_names::speed, fastest(next.method->positions(), *following.before,
                                          following.time() - following.before_time));
    next.measured.reset();
    const auto every = next.problem.scenario.method.values.integer("diagnostics_every");
    const bool due = following.step % every < time_steps && diagnostics(next) != Diagnostics::none;
    if (following.ends() || due) measure(next, report, Diagnostics::full);
    return report;
}

/// "2 time steps have tangled cells; ..."; empty if all is well.
static std::string complaints_about(const Following& following) {
    std::string all;
    const auto say = [&](int count, const std::string& what) {
        if (count > 0)
            all += (all.empty() ? "" : "; ") + std::to_string(count) +
                   (count == 1 ? " time step " : " time steps ") + what;
    };
    say(following.tangled, following.tangled == 1 ? "has tangled cells" : "have tangled cells");
    say(following.unsolved, std::string(following.unsolved == 1 ? "was" : "were") +
                                " not solved within time.iterations, and a smaller time.step may help");
    return all;
}

/// The status and the note of the last time step.
void Run::end_time(const Course& course, StepReport& report) const {
    const Following& following = *course.following;
    report.status = following.tangled > 0    ? RunStatus::tangled
                    : following.unsolved > 0 ? RunStatus::iteration_limit
                                             : RunStatus::converged;
    report.note = complaints_about(following);
    note_folds(course, report);
    if (report.status != RunStatus::converged) note_advice(course, report);
}

/// The run ends at the time before, after a step to another one that cannot be made. Its row of the history
/// has the time and the mesh of the row before, and no speed.
const StepReport& Run::give_up_time(RunStatus status, const std::string& note, int iterations,
                                    const Timer& timer) {
    const Evaluation evaluation = now_.method->evaluate(now_.data, now_.state, {});
    stale_ = false;
    now_.measured.reset();
    const std::string others = complaints_about(*now_.following);
    StepReport report{.iteration = history_.back().iteration + 1,
                      .residual = evaluation.residual,
                      .all_iterations = history_.back().all_iterations + iterations,
                      .status = status,
                      .note = note + (others.empty() ? "" : "; " + others),
                      .series = now_.series};
    take_series(now_, evaluation.series, report);
    add_time(now_, report);
    report.set(time_names::iterations, iterations);
    measure(now_, report, Diagnostics::full);
    timer.add_to(report, history_.back(), now_);
    history_.push_back(std::move(report));
    ++version_;
    return history_.back();
}

/// The same, but the next step is solved to method.tolerance.
static std::shared_ptr<const Following> demanding(const Following& following) {
    auto changed = std::make_shared<Following>(following);
    changed->tolerance->learn_anew();
    return changed;
}

/// A time step that was not solved far enough: what it took counts, too.
struct Run::FirstAttempt {
    const Timer& timer;
    const StepMesh& mesh;
};

/// The next time step, as a row of the history. `first`: it is made again.
const StepReport& Run::advance(std::stop_token stop, int time_steps, const FirstAttempt* first) {
    GASPARD_CHECK(time_steps > 0);
    const Timer own(now_);
    const Timer& timer = first ? first->timer : own;
    Course next = now_;
    auto following = std::make_shared<Following>(*now_.following);
    following->before = std::make_shared<const Points>(now_.method->positions());
    following->before_time = following->time();
    following->step = std::min(following->step + time_steps, following->clock->steps());
    const Values& time = next.problem.scenario.time;
    if (time.text("rule") != time_rule::equidistribution)
        following->tolerance.reset();
    else if (!following->tolerance)
        following->tolerance.emplace(time.real("factor"),
                                     next.problem.scenario.method.values.real("tolerance"));
    next.following = following;
    stale_ = true; // until the step is in place
    StepMesh mesh;
    TimeStep step(*this, next, stop);
    const auto iterations = [&] { return step.iterations() + (first ? first->mesh.iterations : 0); };
    try {
        mesh = step.make(*following);
    } catch (const InputError& error) { // the monitor cannot be made at this time
        return give_up_time(RunStatus::invalid_input, error.what(), iterations(), timer);
    }
    mesh.iterations = iterations();
    if (first) {
        mesh.inner_iterations += first->mesh.inner_iterations;
        mesh.monitor_seconds += first->mesh.monitor_seconds;
    }
    if (!std::isfinite(mesh.evaluation.residual))
        return give_up_time(RunStatus::diverged,
                            "the iteration diverged in the time step to t = " +
                                exact_number(following->time()) + "; a smaller time.step may help",
                            mesh.iterations, timer);
    if (!mesh.solved)
        following->maps.begin(following->time(), next.state), ++following->unsolved;
    else if (mesh.iterations > 0) // an expected map that was near enough tells nothing new
        following->maps.add(following->time(), next.state);
    if (following->tolerance) following->tolerance->learn(mesh.samples, mesh.solved);
    find_exact(next);
    StepReport report = report_step(next, mesh, history_.back().iteration + 1, time_steps);
    const auto e = report.value("equidistribution");
    if (!first && e && mesh.samples.empty() && following->tolerance &&
        following->tolerance->exceeded_by(*e)) {
        refresh();
        now_.following = demanding(*now_.following);
        const FirstAttempt attempt{timer, mesh};
        return advance(stop, time_steps, &attempt);
    }
    if (report.tangled_cells.value_or(0) > 0) ++following->tangled;
    if (following->ends()) end_time(next, report);
    timer.add_to(report, history_.back(), next);
    report.all_iterations = history_.back().all_iterations + mesh.iterations;
    next.data.stop = {};
    history_.push_back(std::move(report));
    thin_out_time_steps(history_);
    put_in_place(std::move(next));
    return history_.back();
}

void Run::go_on_from(const State& state, std::optional<double> t, std::stop_token stop) {
    Course next = now_;
    set_clock(next, t);
    stale_ = true; // until the start is in place
    next.state = adopted(next, state);
    if (next.following) next.data = data_of(next, {}, stop), find_exact(next);
    restart(std::move(next), stop);
}

} // namespace gaspard
