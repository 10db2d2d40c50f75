// Runs whose scenario has time: once the mesh of the first time is solved, every step of the run is a time
// step t_{k-1} -> t_k.
//
//   rule relaxation   tau d/dt s = s*(t) - s,  so  s_k = s_{k-1} + (1 - exp(-dt / tau)) (s* - s_{k-1})
//   other rules       s_k = s*(t_k) up to a residual, from a start that is extrapolated (extrapolation.hpp)
//
// where s*(t) is the map for the monitor at time t, in the first line approximated by one iteration. If a
// step is not solved, it begins again from s_{k-1}, then goes there in 2, 4 or 8 parts.
#include "core/base/stopwatch.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/session/following.hpp"
#include "core/session/run.hpp"
#include "core/session/run_timer.hpp"
#include "core/session/time_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr int most_parts = 8;                // of a time step that is not solved at once
constexpr std::int64_t most_learning = 1000; // iterations of a step to method.tolerance, for samples
constexpr double runaway_factor = 1e3;       // a time step is given up if its criterion grows so much

std::optional<int> degree_of(const Values& time) {
    const std::string& choice = time.text("extrapolation");
    if (choice == "auto") return std::nullopt;
    return choice == "none" ? 0 : choice == "linear" ? 1 : 2;
}

double fastest(const Points& x, const Points& before, double dt) {
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, norm(x[i] - before[i]));
    return largest / dt;
}

} // namespace

std::optional<double> Run::time() const {
    return now_.following ? std::optional(now_.following->time()) : std::nullopt;
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
    const auto clock = make_clock(*catalogue_, course.problem.scenario);
    if (!clock) return;
    course.following =
        std::make_shared<const Following>(Following{.clock = clock, .step = t ? clock->nearest(*t) : 0});
}

/// The first mesh is solved: the run goes on, in time.
void Run::arrive(Course& course, StepReport& report) {
    if (!course.following || report.status != RunStatus::converged || course.following->ends()) return;
    auto following = std::make_shared<Following>(*course.following);
    following->arrived = true;
    following->maps.begin(following->time(), course.state);
    following->tolerance.reset();
    course.following = std::move(following);
    report.status = RunStatus::running;
}

/// Other values of how the mesh follows, from the next time step on.
void Run::take_rule() {
    if (!now_.following) return;
    auto following = std::make_shared<Following>(*now_.following);
    following->tolerance.reset();
    now_.following = std::move(following);
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

/// One time step of a course, which it changes.
class Run::TimeStep {
  public:
    struct Mesh {
        Evaluation evaluation; ///< of the course's state
        int iterations = 0, inner_iterations = 0;
        bool solved = false;
        double monitor_seconds = 0;
        std::vector<StepTolerance::Sample> samples{}; ///< if asked for: at least one
    };

    TimeStep(const Run& run, Course& course, std::stop_token stop)
        : run_(run), course_(course), stop_(std::move(stop)), time_(course.problem.scenario.time),
          rule_(time_.text("rule")) {}

    Mesh make(const Following& following) {
        Mesh mesh = follow(following);
        mesh.monitor_seconds = monitor_seconds_;
        return mesh;
    }

  private:
    Mesh follow(const Following& following) {
        const double from = following.before_time, to = following.time();
        const State before = course_.state;
        const bool samples = rule_ == time_rule::equidistribution && following.tolerance->learns();
        set_time(following, to);
        if (rule_ == time_rule::relaxation) return relax(to - from);
        const double aim = samples || !following.tolerance ? smallest() : following.tolerance->value();
        const auto degree = degree_of(time_);
        course_.state = following.maps.at(to, degree);
        Mesh mesh = solve(aim, samples);
        if (!mesh.solved && degree != 0) {
            course_.state = before;
            mesh = solve(aim, samples);
        }
        for (int parts = 2; !mesh.solved && rule_ != time_rule::iterations && parts <= most_parts;
             parts *= 2) {
            course_.state = before;
            for (int part = 1; part <= parts; ++part) {
                set_time(following, part == parts ? to : from + part * (to - from) / parts);
                mesh = solve(aim, samples && part == parts);
            }
        }
        return mesh;
    }

    /// Tells the method how far it is to solve, as long as this lives.
    class LooserMethod {
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

    /// The data of the problem at a time.
    void set_time(const Following& following, double t) {
        const Stopwatch watch;
        course_.data = make_problem_data(*run_.catalogue_, following.clock->at(t), course_.own,
                                         run_.monitor_context(course_, {}, stop_));
        course_.data.stop = stop_;
        monitor_seconds_ += watch.seconds();
    }

    /// What the criterion must be below.
    double smallest() const {
        const Values& method = course_.problem.scenario.method.values;
        const auto own = time_.real_or_auto("tolerance");
        return rule_ == time_rule::tolerance && own ? *own : method.real("tolerance");
    }

    double criterion(const Evaluation& evaluation) const {
        StepReport report{.residual = evaluation.residual, .series = course_.series};
        run_.take_series(course_, evaluation.series, report);
        return *report.value(course_.series->criterion());
    }

    void sample(Mesh& mesh, double residual) {
        const MeshQuality& quality =
            course_.meter->measure(course_.method->positions(), *course_.data.monitor);
        mesh.samples.push_back({residual, quality.equidistribution});
    }

    Evaluation step(Mesh& mesh) {
        Evaluation evaluation = course_.method->step(course_.data, course_.state, stop_);
        if (stop_.stop_requested()) throw Interrupted();
        ++mesh.iterations;
        mesh.inner_iterations += evaluation.inner_iterations;
        return evaluation;
    }

    /// Iterates from the course's state.
    Mesh solve(double aim, bool samples) {
        const LooserMethod looser(course_, aim);
        Mesh mesh{.evaluation = course_.method->evaluate(course_.data, course_.state, stop_)};
        const auto most =
            samples ? std::max(most_learning, time_.integer("iterations")) : time_.integer("iterations");
        const bool counted = rule_ == time_rule::iterations;
        double first = 0;
        for (;;) {
            const double reached = criterion(mesh.evaluation);
            if (samples && std::isfinite(reached)) sample(mesh, reached);
            if (mesh.iterations == 0) first = std::max(1.0, reached);
            if (!std::isfinite(reached) || reached > runaway_factor * first) return mesh;
            if (mesh.evaluation.ending == Ending::complete) break;
            if (!counted && reached < aim && mesh.evaluation.ending == Ending::by_criterion) break;
            if (mesh.iterations >= most) {
                mesh.solved = counted && std::isfinite(reached);
                return mesh;
            }
            mesh.evaluation = step(mesh);
        }
        mesh.solved = true;
        return mesh;
    }

    Mesh relax(double dt) {
        const State before = course_.state;
        Mesh mesh{.evaluation = course_.method->evaluate(course_.data, course_.state, stop_)};
        const auto most = std::max<std::int64_t>(1, time_.integer("iterations"));
        do mesh.evaluation = step(mesh); // methods of nested iteration return from coarser meshes
        while (course_.state.layout != before.layout && mesh.iterations < most);
        if (course_.state.layout != before.layout || !std::isfinite(mesh.evaluation.residual)) {
            course_.state = before;
        } else {
            const double share = -std::expm1(-dt / time_.real("tau"));
            for (std::size_t k = 0; k < before.arrays.size(); ++k)
                for (std::size_t i = 0; i < before.arrays[k].values.size(); ++i) {
                    double& value = course_.state.arrays[k].values[i];
                    value = before.arrays[k].values[i] + share * (value - before.arrays[k].values[i]);
                }
            mesh.solved = true;
        }
        mesh.evaluation = course_.method->evaluate(course_.data, course_.state, stop_);
        mesh.solved = mesh.solved && std::isfinite(mesh.evaluation.residual);
        return mesh;
    }

    const Run& run_;
    Course& course_;
    std::stop_token stop_;
    const Values& time_;
    const std::string& rule_;
    double monitor_seconds_ = 0;
};

/// The next time step, as a row of the history.
const StepReport& Run::advance(std::stop_token stop, int time_steps) {
    const Timer timer(now_);
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
    stale_ = true; // until the step is in place
    const TimeStep::Mesh mesh = TimeStep(*this, next, stop).make(*following);
    if (!std::isfinite(mesh.evaluation.residual)) { // the run ends at the time before
        refresh();
        StepReport last = history_.back();
        ++last.iteration;
        last.status = RunStatus::diverged;
        last.note = "the iteration diverged in the time step to t = " + format_number(following->time()) +
                    "; a smaller time.step may help";
        timer.add_to(last, history_.back(), now_);
        history_.push_back(std::move(last));
        ++version_;
        return history_.back();
    }
    // An extrapolated map that was near enough tells nothing new.
    if (mesh.iterations > 0) following->maps.add(following->time(), next.state);
    if (!mesh.solved) ++following->unsolved;
    if (following->tolerance) {
        if (mesh.samples.size() > 0 && mesh.solved)
            following->tolerance->learn(mesh.samples);
        else
            following->tolerance->pass();
    }
    next.following = following;
    next.measured.reset();
    StepReport report{.iteration = history_.back().iteration + 1,
                      .residual = mesh.evaluation.residual,
                      .step_size = mesh.evaluation.step_size,
                      .inner_iterations = mesh.inner_iterations,
                      .note = mesh.solved ? "" : "the time step is not solved",
                      .series = next.series};
    take_series(next, mesh.evaluation.series, report);
    add_time(next, report);
    report.set(time_names::iterations, mesh.iterations);
    report.set(time_names::monitor, mesh.monitor_seconds);
    report.set(time_names::speed, fastest(next.method->positions(), *following->before,
                                          following->time() - following->before_time));
    const auto every = next.problem.scenario.method.values.integer("diagnostics_every");
    if (following->ends() || (following->step % every < time_steps && diagnostics(next) != Diagnostics::none))
        measure(next, report, Diagnostics::full);
    if (report.tangled_cells.value_or(0) > 0) ++following->tangled;
    if (const auto e = report.value("equidistribution"); e && following->tolerance)
        following->tolerance->check(*e);
    if (following->ends()) {
        report.status = following->tangled > 0    ? RunStatus::tangled
                        : following->unsolved > 0 ? RunStatus::iteration_limit
                                                  : RunStatus::converged;
        if (following->unsolved > 0)
            report.note = std::to_string(following->unsolved) + " of " + std::to_string(following->step) +
                          " time steps were not solved within time.iterations; a smaller time.step may help";
        if (following->tangled > 0)
            report.note =
                std::to_string(following->tangled) + " time steps that were measured have tangled cells";
    }
    timer.add_to(report, history_.back(), next);
    next.data.stop = {};
    history_.push_back(std::move(report));
    put_in_place(std::move(next));
    return history_.back();
}

void Run::go_on_from(const State& state, double t, std::stop_token stop) {
    Course next = now_;
    set_clock(next, t);
    stale_ = true; // until the start is in place
    next.state = adopted(next, state);
    if (next.following) next.data = data_of(next, {}, stop);
    restart(std::move(next), stop);
}

} // namespace gaspard
