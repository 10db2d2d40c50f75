#include "core/session/run.hpp"

#include "core/base/check.hpp"
#include "core/base/short_number.hpp"
#include "core/base/stopwatch.hpp"
#include "core/diagnostics/cell_quality.hpp"
#include "core/diagnostics/exact_map.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/method/nonlinear_problem.hpp"
#include "core/monitor/own_problem.hpp"
#include "core/scenario/view_rows.hpp"
#include "core/session/following.hpp"
#include "core/session/run_timer.hpp"
#include "core/session/time_series.hpp"
#include "core/spline/patch_file.hpp"
#include "core/spline/solid_domain.hpp"
#include "core/spline/spline_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>

namespace gaspard {

namespace {

// A run has diverged if a bounded series (theta) exceeds divergence_factor times its first value, or the
// criterion (the residual, MethodType::criterion) exceeds divergence_factor times max(1, its first value).
constexpr double divergence_factor = 1e3;
constexpr double worthwhile = 0.999; // an improvement is a criterion below this fraction of the best one
constexpr int patience = 200;        // iterations without improvement after which a run has stalled

} // namespace

std::shared_ptr<const Discretisation> prepare(const Problem& problem, const Progress& progress,
                                              std::stop_token stop) {
    auto discretisation = problem.capability->prepare({problem.scenario, progress, stop});
    if (stop.stop_requested()) throw Interrupted();
    GASPARD_CHECK(discretisation != nullptr);
    return discretisation;
}

// Its names are those of the choices of method.diagnostics.
Diagnostics Run::diagnostics(const Course& course) {
    const std::string& level = course.problem.scenario.method.values.text("diagnostics");
    if (level == "none") return Diagnostics::none;
    return level == "geometry" ? Diagnostics::geometry : Diagnostics::full;
}

MonitorContext Run::monitor_context(const Course& course, const Progress& progress,
                                    std::stop_token stop) const {
    const Scenario& scenario = course.problem.scenario;
    return {.space = space_of(*catalogue_, scenario),
            .discretisation = course.discretisation.get(),
            .folder = scenario.folder,
            .files = files_,
            .progress = progress,
            .stop = std::move(stop)};
}

std::unique_ptr<Method> Run::make_method(const Course& course, const Progress& progress,
                                         std::stop_token stop) const {
    MethodContext context{
        .discretisation = course.discretisation, .progress = progress, .stop = std::move(stop)};
    if (const auto& make = course.problem.capability->problem)
        context.problem = [make, discretisation = course.discretisation] { return make(discretisation); };
    const Section& section = course.problem.scenario.method;
    const auto& makers = course.problem.capability->makers;
    const auto own = makers.find(section.type);
    const MethodType& type = catalogue_->method(section.type);
    auto method = (own == makers.end() ? type.make : own->second)(context, section.values);
    method->use_threads(threads_);
    return method;
}

std::shared_ptr<QualityMeter> Run::make_meter(const Course& course) const {
    const int points = cell_dimension(course.discretisation->mesh()->kind) == 3 ? 4 : 6; // see quality.hpp
    return std::make_shared<QualityMeter>(course.discretisation->mesh(), threads_, points,
                                          space_of(*catalogue_, course.problem.scenario));
}

/// `anew`: although the domain's files were read before.
static Scenario located(const Catalogue& catalogue, Scenario scenario, bool anew = false) {
    if (anew) scenario.place.files.clear();
    locate_domain(catalogue, scenario);
    return scenario;
}

/// Sets the scenario's domain to the caller's patch or solid. Of a scenario on another one, its mesh remains.
static Scenario on_patch(const Catalogue& catalogue, Scenario scenario, const SplinePatch* patch) {
    if (!patch) return located(catalogue, std::move(scenario));
    const std::string_view type = patch->space.directions.size() == 3 ? own_solid_domain : own_patch_domain;
    Section domain = domain_section(catalogue, type);
    if (scenario.domain.type == type)
        for (const char* key : {"cells", "degree"}) domain.values.set(key, scenario.domain.values.at(key));
    domain.values.set("file", patch_json(*patch));
    scenario.domain = std::move(domain);
    locate_domain(catalogue, scenario);
    return scenario;
}

Run::Run(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, RunOptions options,
         const Progress& progress, std::stop_token stop)
    : catalogue_(std::move(catalogue)),
      threads_(options.threads), now_{.problem = check(
                                          *catalogue_,
                                          on_patch(*catalogue_, std::move(scenario), options.patch.get()),
                                          options.monitor.get()),
                                      .own = std::move(options.monitor)} {
    const Stopwatch watch;
    now_.discretisation = prepare(now_.problem, progress, stop);
    set_clock(now_, {});
    now_.data = data_of(now_, progress, stop);
    now_.method = make_method(now_, progress, stop);
    now_.meter = make_meter(now_);
    prepare_reports(now_);
    now_.state = now_.method->initial_state();
    if (options.start) now_.state = adopted(now_, *options.start);
    setup_seconds_ = watch.seconds();
    restart(now_, stop);
    epoch_ = 0;
}

Run::Run(Run&&) noexcept = default;
Run::~Run() = default;

/// What is reported and shown of the problem: the exact map, the names of the series.
void Run::prepare_reports(Course& course) const {
    const auto known = std::exchange(course.series, nullptr);
    find_exact(course);
    std::vector<SeriesInfo> diagnostics = quality_series();
    if (course.exact)
        for (SeriesInfo& one : exact_series()) diagnostics.push_back(std::move(one));
    if (course.method->knows_map()) diagnostics.push_back(folded_drawn_cells_series());
    if (interpolates(course))
        for (SeriesInfo& one : interpolation_series()) diagnostics.push_back(std::move(one));
    prepare_shapes(course);
    if (course.shapes)
        for (SeriesInfo& one : cell_quality_series()) diagnostics.push_back(std::move(one));
    if (course.following)
        for (SeriesInfo& one : time_series()) diagnostics.push_back(std::move(one));
    const auto table =
        std::make_shared<const SeriesTable>(method_type(course).residual, std::move(diagnostics),
                                            course.method->series(), method_type(course).criterion);
    course.series = known && known->all() == table->all() ? known : table;
}

const MethodType& Run::method_type(const Course& course) const {
    return catalogue_->method(course.problem.scenario.method.type);
}

Evaluation Run::first_look(const Course& course, std::stop_token stop) const {
    const Evaluation evaluation = course.method->evaluate(stoppable(course.data, stop), course.state, stop);
    if (stop.stop_requested()) throw Interrupted();
    if (std::isfinite(evaluation.residual)) return evaluation;
    throw InputError("the residual of the start state is not finite for this monitor");
}

/// Begins a new history with the state of the course.
void Run::restart(Course next, std::stop_token stop) {
    next.untangled = next.state;
    begin_history(std::move(next), {}, stop, Diagnostics::full);
}

/// With a row for the state of the course, measured up to `at_most` where it is.
void Run::begin_history(Course next, std::string note, std::stop_token stop, Diagnostics at_most) {
    const Timer timer(next);
    const Evaluation evaluation = first_look(next, stop);
    next.judging = {};
    restart_following(next);
    const ProblemData data = std::exchange(next.data, stoppable(next.data, stop));
    std::vector<StepReport> history = {report(next, evaluation, 0, std::move(note), at_most)};
    next.data = data;
    timer.add_to(history[0], {}, next);
    history_ = std::move(history);
    put_in_place(std::move(next));
    ++epoch_;
}

/// When nothing can fail any more.
void Run::put_in_place(Course&& next) noexcept {
    now_ = std::move(next);
    stale_ = failed_ = false;
    ++version_;
}

/// After an exception: makes the method's last evaluation that of the present state and data.
void Run::refresh() {
    if (!stale_) return;
    now_.measured.reset();
    now_.method->evaluate(now_.data, now_.state, {});
    stale_ = false;
}

void Run::reset() {
    Course next = now_;
    set_clock(next, {});
    if (next.following) next.data = data_of(next, {}, {}), find_exact(next);
    next.state = next.method->initial_state();
    stale_ = true; // until the start is in place
    restart(std::move(next), {});
}

/// A state as the unknowns of the course.
State Run::adopted(const Course& course, const State& start) {
    auto state = course.method->adopt(start, nullptr);
    if (!state)
        throw InputError("the start state has layout '" + start.layout + "', which is not compatible with '" +
                         course.method->initial_state().layout + "'");
    return std::move(*state);
}

void Run::start_from(const State& state, std::stop_token stop) { go_on_from(state, {}, stop); }

void Run::follow(std::shared_ptr<const Monitor> monitor, std::stop_token stop) {
    if (!monitor) throw InputError("Run::follow: the monitor is null");
    Course next = now_;
    next.problem = check(*catalogue_, scenario(), monitor.get());
    next.own = std::move(monitor);
    next.following.reset();
    next.data = data_of(next, {}, stop);
    if (returns()) next.state = next.untangled;
    prepare_reports(next);
    stale_ = true; // until the start is in place
    restart(std::move(next), stop);
}

/// Whether other values begin at the last mesh without tangled cells.
bool Run::returns() const {
    return status() == RunStatus::diverged || status() == RunStatus::tangled || failed_;
}

const StepReport& Run::solve(std::stop_token stop) {
    while (status() == RunStatus::running) {
        if (stop.stop_requested()) {
            interrupt();
            continue;
        }
        try {
            step(stop);
        } catch (const Interrupted&) { // the iterate before it is there
            if (!stop.stop_requested()) throw;
        }
    }
    return history_.back();
}

const StepReport& Run::step(std::stop_token stop, int time_steps) {
    GASPARD_CHECK(status() == RunStatus::running);
    refresh();
    if (moves()) return advance(stop, time_steps);
    const Timer timer(now_);
    last_finite_ = now_.state;
    const Judging judging = now_.judging;
    const auto following = now_.following;
    now_.data.stop = stop; // of the measures, too
    try {
        Evaluation evaluation = now_.method->step(now_.data, now_.state, stop);
        std::string note = evaluation.note;
        if (!std::isfinite(evaluation.residual)) take_back(evaluation, note);
        StepReport next = report(now_, evaluation, history_.back().iteration + 1, std::move(note));
        timer.add_to(next, history_.back(), now_);
        next.all_iterations = history_.back().all_iterations + 1;
        history_.push_back(std::move(next));
        now_.data.stop = {};
    } catch (...) { // undo the incomplete step
        now_.data.stop = {};
        now_.state = last_finite_;
        now_.judging = judging;
        now_.following = following;
        now_.measured.reset();
        stale_ = true;
        failed_ = !stop.stop_requested(); // an interruption is no failure
        throw;
    }
    failed_ = false;
    ++version_;
    return history_.back();
}

// If an update is not finite, the run ends with the iterate before it.
void Run::take_back(Evaluation& evaluation, std::string& note) {
    const Evaluation lost = evaluation;
    now_.state = last_finite_;
    evaluation = now_.method->evaluate(now_.data, now_.state, {});
    evaluation.step_size = lost.step_size;
    evaluation.inner_iterations = lost.inner_iterations;
    now_.judging.not_finite = true;
    note = "the last update was not finite and was discarded";
}

/// The report of the iterate last evaluated: judged, and measured where that is due.
StepReport Run::report(Course& course, const Evaluation& evaluation, int iteration, std::string note,
                       Diagnostics at_most) const {
    StepReport report{.iteration = iteration,
                      .residual = evaluation.residual,
                      .step_size = evaluation.step_size,
                      .inner_iterations = evaluation.inner_iterations,
                      .note = std::move(note),
                      .series = course.series};
    take_series(course, evaluation.series, report);
    course.measured.reset();
    if (evaluation.anew) course.judging.best = std::numeric_limits<double>::infinity();
    report.status = judge(course, report, evaluation.ending, report.note);
    const auto every = course.problem.scenario.method.values.integer("diagnostics_every");
    const bool due = iteration % every == 0 && diagnostics(course) != Diagnostics::none;
    if (is_final(report.status) || due) measure(course, report, at_most);
    const bool diverged = report.status == RunStatus::diverged;
    if (is_final(report.status) && !diverged && *report.tangled_cells > 0) report.status = RunStatus::tangled;
    if (arrives(course, report)) arrive(course, report);
    if (is_final(report.status)) note_folds(course, report);
    if (is_final(report.status) && report.status != RunStatus::converged) note_advice(course, report);
    add_time(course, report);
    return report;
}

/// What the monitor says if a mesh cannot follow it.
void Run::note_advice(const Course& course, StepReport& report) {
    if (!course.data.report || course.data.report->advice.empty()) return;
    report.note += (report.note.empty() ? "" : "; ") + course.data.report->advice;
}

/// Where cells fold although the map, by which the mesh is judged, does not.
void Run::note_folds(const Course& course, StepReport& report) {
    const double drawn = report.value(folded_drawn_cells_series().name).value_or(0);
    if (!(drawn > 0) || *report.tangled_cells > 0) return;
    report.note += (report.note.empty() ? "" : "; ") + exact_number(drawn) + " of " +
                   std::to_string(course.discretisation->mesh()->cell_count()) +
                   " drawn cells fold; the map does not";
}

/// The values that every iterate has; those that are measured stay empty.
void Run::take_series(const Course& course, const SeriesValues& values, StepReport& report) const {
    const auto& all = course.series->all();
    report.values.assign(course.series->slots(), std::numeric_limits<double>::quiet_NaN());
    const double* next = values.begin();
    for (std::size_t i = course.series->first_of_method(); i < all.size(); ++i) {
        if (all[i].measured) continue;
        GASPARD_CHECK(next != values.end());
        report.values[course.series->slot(i)] = *next++;
    }
    GASPARD_CHECK(next == values.end());
}

bool Run::out_of_bounds(const Course& course, const StepReport& report) const {
    const SeriesTable& series = *course.series;
    for (std::size_t i = series.first_of_method(); i < series.all().size(); ++i) {
        if (!series.all()[i].bounded) continue;
        const std::size_t slot = series.slot(i);
        const double value = report.values[slot];
        if (!(value > 0) || value / divergence_factor > course.judging.first_values[slot]) return true;
    }
    return false;
}

RunStatus Run::judge(Course& course, const StepReport& report, Ending ending, std::string& note) const {
    const Values& method = course.problem.scenario.method.values;
    Judging& by = course.judging;
    if (std::exchange(by.not_finite, false)) return RunStatus::diverged;
    const auto criterion = report.value(course.series->criterion());
    GASPARD_CHECK(criterion.has_value());
    if (std::isinf(by.first)) by.first = *criterion, by.first_values = report.values;
    if (*criterion < worthwhile * by.best) by.best = *criterion, by.best_iteration = report.iteration;
    if (ending == Ending::complete) return RunStatus::converged;
    if (*criterion < method.real("tolerance") && ending == Ending::by_criterion) return RunStatus::converged;
    if (*criterion > divergence_factor * std::max(1.0, by.first) || out_of_bounds(course, report)) {
        const Values& domain = course.problem.scenario.domain.values;
        note = "the iteration diverged; ";
        if (const auto remedy = find_remedy(domain)) note += describe(domain, *remedy) + " or ";
        note +=
            method.has("step_size") ? "a smaller step may help" : "a finer mesh or a weaker monitor may help";
        return RunStatus::diverged;
    }
    if (report.iteration >= method.integer("max_iterations")) return RunStatus::iteration_limit;
    if (report.iteration - by.best_iteration >= patience) {
        const std::string reason = note.empty() ? "" : "; " + note;
        note = "the " + course.series->all()[course.series->criterion()].name + " has not decreased for " +
               std::to_string(patience) + " iterations" + reason;
        if (const auto remedy = find_remedy(method)) note += "; " + describe(method, *remedy) + " may help";
        return RunStatus::stalled;
    }
    return RunStatus::running;
}

/// Measures the method's last evaluation, up to a level that method.diagnostics allows.
void Run::measure(Course& course, StepReport& report, Diagnostics at_most) const {
    const Diagnostics level = std::min(at_most, diagnostics(course));
    if (course.measured && *course.measured >= level) return;
    const Points& x = course.method->positions();
    const MeshQuality& quality = level == Diagnostics::full ? course.meter->measure(x, *course.data.monitor)
                                                            : course.meter->measure_geometry(x);
    course.tangled.reset();
    if (course.method->knows_map())
        course.tangled = std::make_shared<const std::vector<std::uint32_t>>(course.method->folded_cells());
    // As prepare_reports() has them: the diagnostics, then the method's.
    std::vector<double> values = report.values;
    auto next = values.begin();
    if (level != Diagnostics::none) std::ranges::copy(values_of(quality), next);
    next += static_cast<std::ptrdiff_t>(values_of(quality).size());
    if (report.series->find(exact_series().front().name)) {
        if (level == Diagnostics::full && course.exact)
            std::ranges::copy(values_of(exact_deviation(*course.discretisation->mesh(), x, *course.exact,
                                                        space_of(*catalogue_, course.problem.scenario).kind ==
                                                            SpaceKind::sphere)),
                              next);
        next += static_cast<std::ptrdiff_t>(exact_series().size());
    }
    if (course.tangled) *next++ = static_cast<double>(quality.tangled_cells);
    if (interpolates(course)) next += static_cast<std::ptrdiff_t>(interpolation_series().size());
    if (course.shapes && level == Diagnostics::full) std::ranges::copy(shapes(course), next);
    if (course.shapes) next += static_cast<std::ptrdiff_t>(cell_quality_series().size());
    if (course.following) next += static_cast<std::ptrdiff_t>(time_series().size());
    if (level == Diagnostics::full) {
        const std::vector<double> measures = course.method->measures(course.data);
        auto measure = measures.begin();
        for (std::size_t i = report.series->first_of_method(); i < report.series->all().size(); ++i, ++next)
            if (report.series->all()[i].measured) {
                GASPARD_CHECK(measure != measures.end());
                *next = *measure++;
            }
        GASPARD_CHECK(measure == measures.end());
    }
    report.values = std::move(values);
    report.tangled_cells = course.tangled ? course.tangled->size() : quality.tangled_cells;
    course.measured = level;
    if (*report.tangled_cells == 0) course.untangled = course.state;
}

void Run::complete() {
    refresh();
    measure(now_, history_.back(), Diagnostics::full);
}

void Run::interrupt() {
    GASPARD_CHECK(status() == RunStatus::running);
    complete();
    history_.back().status = RunStatus::interrupted;
}

std::string Run::change(const Scenario& scenario, const Progress& progress, std::stop_token stop,
                        Diagnostics at_most, bool reread) {
    Problem problem = check(*catalogue_, located(*catalogue_, scenario, reread), now_.own.get());
    const Scenario& old = now_.problem.scenario;
    const bool new_data = reread || !same_problem_data(problem.scenario, old);
    if (!new_data && problem.scenario.method == old.method) {
        now_.problem = std::move(problem);
        return {};
    }
    const bool other_files = find_role(old.domain.values.rows(), ParameterRole::file) != nullptr &&
                             (reread || problem.scenario.folder != old.folder);
    const bool new_domain = !(problem.scenario.domain == old.domain) || other_files;
    const bool new_method = new_domain || problem.scenario.method.type != old.method.type;
    const Stopwatch watch;
    Course next = now_;
    next.problem = std::move(problem);
    if (new_domain) next.discretisation = prepare(next.problem, progress, stop);
    if (new_domain) next.meter = make_meter(next);
    if (new_data) set_clock(next, time());
    if (new_data) next.data = data_of(next, progress, stop);
    // From divergence or tangled cells no step leads on: restart from the last untangled mesh.
    refresh();
    measure(now_, history_.back(), Diagnostics::none);
    const bool back = returns() || *history_.back().tangled_cells > 0;
    next.untangled = now_.untangled;
    if (back) next.state = next.untangled;
    bool transferred = true;
    double setup_seconds = setup_seconds_;
    stale_ = true; // until the new values are in place
    if (new_method) {
        next.method = make_method(next, progress, stop);
        transferred = transfer(next);
        if (!transferred) next.state = next.method->initial_state();
        setup_seconds = watch.seconds();
    }
    try {
        if (!new_method) next.method->configure(next.problem.scenario.method.values);
        prepare_reports(next);
        if (transferred)
            begin_history(std::move(next),
                          back ? "values changed; restarted from the last mesh without tangled cells"
                               : "values changed",
                          stop, at_most);
        else
            restart(std::move(next), stop);
    } catch (...) {
        if (!new_method) now_.method->configure(now_.problem.scenario.method.values);
        throw;
    }
    setup_seconds_ = setup_seconds;
    return transferred ? "" : "The map could not be transferred; the run restarts from the uniform mesh.";
}

/// Transfers the maps to a new method; false if that is impossible.
bool Run::transfer(Course& course) const {
    const bool same = course.state == course.untangled;
    auto state = course.method->adopt(course.state, now_.discretisation.get());
    if (!state) return false;
    auto untangled = same ? state : course.method->adopt(course.untangled, now_.discretisation.get());
    course.state = std::move(*state);
    course.untangled = untangled ? std::move(*untangled) : course.method->initial_state();
    return true;
}

std::shared_ptr<const Snapshot> Run::snapshot(Diagnostics at_most) {
    refresh();
    measure(now_, history_.back(), at_most);
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->mesh = now_.discretisation->mesh();
    snapshot->x = now_.method->positions();
    snapshot->tangled = now_.tangled;
    snapshot->exact = now_.exact;
    snapshot->control = now_.discretisation->control_points();
    snapshot->control_columns = now_.discretisation->control_columns();
    snapshot->target = now_.discretisation->target_outline();
    snapshot->patches = now_.discretisation->patches();
    snapshot->monitor_report = now_.data.report;
    Field monitor{mesh_colour("monitor"), std::vector<double>(snapshot->x.size())};
    now_.data.monitor->values(snapshot->x, monitor.values);
    for (double& value : monitor.values) value *= now_.data.unit;
    snapshot->fields.push_back(std::move(monitor));
    const MeshQuality& quality = now_.meter->quality();
    if (*now_.measured == Diagnostics::full) {
        const FieldInfo info{.name = "mass", .label = "cell mass", .symbol = "Mᵢ", .place = FieldPlace::cell};
        Field mass{info, quality.cell_mass};
        for (double& value : mass.values) value *= now_.data.unit;
        snapshot->fields.push_back(std::move(mass));
    }
    snapshot->fields.push_back({mesh_colour("jacobian"), quality.cell_jacobian});
    add_interpolation(*snapshot);
    add_fields_of_method(*snapshot);
    add_fields_of_monitor(*snapshot);
    add_velocity(now_, *snapshot);
    snapshot->report = history_.back();
    snapshot->version = version_;
    return snapshot;
}

void Run::add_fields_of_method(Snapshot& snapshot) {
    const std::vector<FieldInfo>& infos = method_type(now_).fields;
    auto values = now_.method->fields(now_.data);
    GASPARD_CHECK(values.size() == infos.size());
    for (std::size_t i = 0; i < infos.size(); ++i) {
        if (values[i].empty()) continue; // the problem has no such field
        const bool of_nodes = infos[i].place == FieldPlace::node;
        GASPARD_CHECK(values[i].size() ==
                      (of_nodes ? snapshot.mesh->node_count() : snapshot.mesh->cell_count()));
        snapshot.fields.push_back({infos[i], std::move(values[i])});
    }
}

/// Those whose names are taken, by a caller's monitor, are left out.
void Run::add_fields_of_monitor(Snapshot& snapshot) const {
    for (Field& field : now_.data.monitor->fields(snapshot.x)) {
        if (snapshot.field(field.name) != nullptr) continue;
        GASPARD_CHECK(field.place == FieldPlace::node && field.values.size() == snapshot.x.size());
        snapshot.fields.push_back(std::move(field));
    }
}

} // namespace gaspard
