#include "core/session/run.hpp"

#include "core/base/check.hpp"
#include "core/base/stopwatch.hpp"
#include "core/diagnostics/exact_map.hpp"
#include "core/diagnostics/quality.hpp"
#include "core/method/nonlinear_problem.hpp"
#include "core/scenario/view_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

MonitorContext Run::monitor_context(const Scenario& scenario, const Discretisation& discretisation,
                                    const Progress& progress, std::stop_token stop) const {
    return {.space = space_of(*catalogue_, scenario),
            .discretisation = &discretisation,
            .folder = scenario.folder,
            .progress = progress,
            .stop = std::move(stop)};
}

std::unique_ptr<Method> Run::make_method(const Problem& problem,
                                         std::shared_ptr<const Discretisation> discretisation,
                                         const Progress& progress, std::stop_token stop) const {
    MethodContext context{.discretisation = discretisation, .progress = progress, .stop = std::move(stop)};
    if (const auto& make = problem.capability->problem)
        context.problem = [make, discretisation] { return make(discretisation); };
    const Section& section = problem.scenario.method;
    auto method = catalogue_->method(section.type).make(context, section.values);
    method->use_threads(options_.threads);
    return method;
}

Run::Run(std::shared_ptr<const Catalogue> catalogue, Scenario scenario, RunOptions options,
         const Progress& progress, std::stop_token stop)
    : catalogue_(std::move(catalogue)), options_(std::move(options)),
      problem_(check(*catalogue_, std::move(scenario))) {
    const Stopwatch watch;
    discretisation_ = prepare(problem_, progress, stop);
    data_ = make_problem_data(*catalogue_, problem_.scenario, own_,
                              monitor_context(problem_.scenario, *discretisation_, progress, stop));
    method_ = make_method(problem_, discretisation_, progress, stop);
    make_meter();
    find_exact_map();
    name_series();
    State state = method_->initial_state();
    if (options_.start) {
        auto adopted = method_->adopt(*options_.start, nullptr);
        if (!adopted)
            throw InputError("the start state has layout '" + options_.start->layout +
                             "', which is not compatible with '" + state.layout + "'");
        state = std::move(*adopted);
    }
    setup_seconds_ = watch.seconds();
    const Evaluation evaluation = first_look(data_, state);
    begin(std::move(state), evaluation);
}

Run::Run(Run&&) noexcept = default;
Run::~Run() = default;

// Only a state or monitor of the caller may have no finite residual.
Evaluation Run::first_look(const ProblemData& data, const State& state) {
    const Evaluation evaluation = method_->evaluate(data, state, {});
    if (std::isfinite(evaluation.residual)) return evaluation;
    GASPARD_CHECK(options_.start || data.monitor != data_.monitor || own_);
    throw InputError("the residual of the start state is not finite for this monitor");
}

void Run::make_meter() {
    constexpr int points = 6; // see quality.hpp
    meter_ = std::make_unique<QualityMeter>(discretisation_->mesh(), options_.threads, points, space());
}

void Run::find_exact_map() {
    exact_.reset();
    if (space().kind != SpaceKind::sphere) return;
    if (const auto map = ExactMap::of(*data_.monitor))
        exact_ = std::make_shared<const Points>(map->apply(discretisation_->mesh()->nodes));
}

/// Once the method and the exact map are there.
void Run::name_series() {
    std::vector<SeriesInfo> diagnostics = quality_series();
    if (exact_)
        for (SeriesInfo& one : exact_series()) diagnostics.push_back(std::move(one));
    if (method_->knows_map()) diagnostics.push_back(folded_drawn_cells_series());
    auto table = std::make_shared<const SeriesTable>(method_type().residual, std::move(diagnostics),
                                                     method_->series(), method_type().criterion);
    if (!series_ || series_->all() != table->all()) series_ = std::move(table);
}

const MethodType& Run::method_type() const { return catalogue_->method(problem_.scenario.method.type); }

void Run::begin(State state, const Evaluation& evaluation) {
    state_ = last_untangled_ = std::move(state);
    history_.clear();
    seconds_ = cpu_seconds_ = 0;
    restart_judging();
    record(evaluation, 0, {});
}

void Run::restart_judging() {
    judged_from_ = best_iteration_ = history_.empty() ? 0 : history_.back().iteration;
    first_ = best_ = std::numeric_limits<double>::infinity();
}

void Run::reset() {
    State state = method_->initial_state();
    const Evaluation evaluation = first_look(data_, state);
    ++epoch_;
    begin(std::move(state), evaluation);
}

void Run::follow(std::shared_ptr<const Monitor> monitor) {
    if (!monitor) throw InputError("Run::follow: the monitor is null");
    Problem problem = check(*catalogue_, problem_.scenario, monitor.get());
    ProblemData data = data_;
    data.monitor = scalar_problem(monitor).monitor;
    data.tensor.reset();
    const bool back = status() == RunStatus::diverged || status() == RunStatus::tangled;
    State state = back ? last_untangled_ : state_;
    const Evaluation evaluation = first_look(data, state);
    data_ = std::move(data);
    own_ = std::move(monitor);
    problem_ = std::move(problem);
    find_exact_map();
    name_series();
    ++epoch_;
    begin(std::move(state), evaluation);
}

const StepReport& Run::solve(std::stop_token stop) {
    while (status() == RunStatus::running) {
        if (stop.stop_requested())
            interrupt();
        else
            step(stop);
    }
    return history_.back();
}

const StepReport& Run::step(std::stop_token stop) {
    GASPARD_CHECK(status() == RunStatus::running);
    const Stopwatch watch;
    const double others_before = method_->other_cpu_seconds();
    last_finite_ = state_;
    Evaluation evaluation;
    try {
        evaluation = method_->step(data_, state_, stop);
    } catch (...) { // undo the incomplete step
        state_ = last_finite_;
        throw;
    }
    std::string note = evaluation.note;
    if (!std::isfinite(evaluation.residual)) take_back(evaluation, note);
    record(evaluation, history_.back().iteration + 1, std::move(note));
    seconds_ += watch.seconds();
    cpu_seconds_ += watch.cpu_seconds() + method_->other_cpu_seconds() - others_before +
                    (measured_ ? meter_->other_cpu_seconds() : 0);
    history_.back().seconds = seconds_;
    history_.back().cpu_seconds = cpu_seconds_;
    return history_.back();
}

// If an update is not finite, the run ends with the iterate before it.
void Run::take_back(Evaluation& evaluation, std::string& note) {
    const Evaluation lost = evaluation;
    state_ = last_finite_;
    evaluation = method_->evaluate(data_, state_, {});
    evaluation.step_size = lost.step_size;
    evaluation.inner_iterations = lost.inner_iterations;
    not_finite_ = true;
    note = "the last update was not finite and was discarded";
}

void Run::record(const Evaluation& evaluation, int iteration, std::string note) {
    StepReport report{.iteration = iteration,
                      .residual = evaluation.residual,
                      .step_size = evaluation.step_size,
                      .inner_iterations = evaluation.inner_iterations,
                      .seconds = seconds_,
                      .cpu_seconds = cpu_seconds_,
                      .note = std::move(note),
                      .series = series_};
    take_series(evaluation.series, report);
    ++version_;
    measured_ = false;
    report.status = judge(report, report.note);
    const auto every = problem_.scenario.method.values.integer("diagnostics_every");
    if (is_final(report.status) || iteration % every == 0) measure(report);
    if (is_final(report.status) && *report.tangled_cells > 0) report.status = RunStatus::tangled;
    if (is_final(report.status)) note_folds(report);
    history_.push_back(std::move(report));
}

/// Where cells fold although the map, by which the mesh is judged, does not.
void Run::note_folds(StepReport& report) const {
    const double drawn = report.value(folded_drawn_cells_series().name).value_or(0);
    if (drawn == 0 || *report.tangled_cells > 0) return;
    report.note += (report.note.empty() ? "" : "; ") + format_number(drawn) + " of " +
                   std::to_string(discretisation_->mesh()->cell_count()) +
                   " drawn cells fold; the map does not";
}

/// The values that every iterate has; those that are measured stay empty.
void Run::take_series(const SeriesValues& values, StepReport& report) const {
    const auto& all = series_->all();
    report.values.assign(series_->slots(), std::numeric_limits<double>::quiet_NaN());
    const double* next = values.begin();
    for (std::size_t i = series_->first_of_method(); i < all.size(); ++i) {
        if (all[i].measured) continue;
        GASPARD_CHECK(next != values.end());
        report.values[series_->slot(i)] = *next++;
    }
    GASPARD_CHECK(next == values.end());
}

bool Run::out_of_bounds(const StepReport& report) const {
    for (std::size_t i = series_->first_of_method(); i < series_->all().size(); ++i) {
        if (!series_->all()[i].bounded) continue;
        const std::size_t slot = series_->slot(i);
        const double value = report.values[slot];
        if (!(value > 0) || value > divergence_factor * first_values_[slot]) return true;
    }
    return false;
}

RunStatus Run::judge(const StepReport& report, std::string& note) {
    const Values& method = problem_.scenario.method.values;
    if (std::exchange(not_finite_, false)) return RunStatus::diverged;
    const auto criterion = report.value(series_->criterion());
    GASPARD_CHECK(criterion.has_value());
    if (std::isinf(first_)) first_ = *criterion, first_values_ = report.values;
    if (*criterion < worthwhile * best_) best_ = *criterion, best_iteration_ = report.iteration;
    if (*criterion < method.real("tolerance")) return RunStatus::converged;
    if (*criterion > divergence_factor * std::max(1.0, first_) || out_of_bounds(report)) {
        const Values& domain = problem_.scenario.domain.values;
        note = "the iteration diverged; ";
        if (const auto remedy = find_remedy(domain)) note += describe(domain, *remedy) + " or ";
        note += "a smaller step may help";
        return RunStatus::diverged;
    }
    if (report.iteration - judged_from_ >= method.integer("max_iterations"))
        return RunStatus::iteration_limit;
    if (report.iteration - best_iteration_ >= patience) {
        note = "the " + series_->all()[series_->criterion()].name + " has not decreased for " +
               std::to_string(patience) + " iterations";
        if (const auto remedy = find_remedy(method)) note += "; " + describe(method, *remedy) + " may help";
        return RunStatus::stalled;
    }
    return RunStatus::running;
}

void Run::measure(StepReport& report) {
    if (measured_) return;
    const MeshQuality& quality = meter_->measure(method_->positions(), *data_.monitor);
    tangled_.reset();
    if (method_->knows_map())
        tangled_ = std::make_shared<const std::vector<std::uint32_t>>(method_->folded_cells());
    report.tangled_cells = tangled_ ? tangled_->size() : quality.tangled_cells;
    auto next = report.values.begin(); // as name_series() has them: the diagnostics, then the method's
    for (const double value : values_of(quality)) *next++ = value;
    if (exact_)
        for (const double value :
             values_of(exact_deviation(*discretisation_->mesh(), method_->positions(), *exact_)))
            *next++ = value;
    if (tangled_) *next++ = static_cast<double>(quality.tangled_cells);
    const std::vector<double> measures = method_->measures(data_);
    auto measure = measures.begin();
    for (std::size_t i = report.series->first_of_method(); i < report.series->all().size(); ++i, ++next)
        if (report.series->all()[i].measured) {
            GASPARD_CHECK(measure != measures.end());
            *next = *measure++;
        }
    GASPARD_CHECK(measure == measures.end());
    measured_ = true;
    if (*report.tangled_cells == 0) last_untangled_ = state_;
}

void Run::complete() { measure(history_.back()); }

void Run::interrupt() {
    GASPARD_CHECK(status() == RunStatus::running);
    measure(history_.back());
    history_.back().status = RunStatus::interrupted;
}

std::string Run::change(const Scenario& scenario, const Progress& progress, std::stop_token stop) {
    Problem problem = check(*catalogue_, scenario, own_.get());
    const Scenario& old = problem_.scenario;
    const bool new_data = !same_problem_data(problem.scenario, old);
    if (!new_data && problem.scenario.method == old.method) {
        problem_ = std::move(problem);
        return {};
    }
    const bool other_files = find_role(old.domain.values.rows(), ParameterRole::file) != nullptr &&
                             problem.scenario.folder != old.folder;
    const bool new_domain = !(problem.scenario.domain == old.domain) || other_files;
    const bool new_method = new_domain || problem.scenario.method.type != old.method.type;
    // From divergence or tangled cells no step leads on: restart from the last untangled mesh.
    measure(history_.back());
    const bool back = status() == RunStatus::diverged || history_.back().tangled_cells.value_or(0) > 0;
    std::optional<State> state = back ? last_untangled_ : state_;
    std::optional<State> untangled = last_untangled_;
    const Stopwatch watch;
    auto discretisation = new_domain ? prepare(problem, progress, stop) : discretisation_;
    ProblemData data = data_;
    if (new_data)
        data = make_problem_data(*catalogue_, problem.scenario, own_,
                                 monitor_context(problem.scenario, *discretisation, progress, stop));
    if (new_method) {
        auto method = make_method(problem, discretisation, progress, stop);
        const bool same = *state == last_untangled_;
        state = method->adopt(*state, discretisation_.get());
        untangled = same ? state : method->adopt(last_untangled_, discretisation_.get());
        discretisation_ = std::move(discretisation);
        method_ = std::move(method);
        setup_seconds_ = watch.seconds();
    } else {
        method_->configure(problem.scenario.method.values);
    }
    data_ = std::move(data);
    problem_ = std::move(problem);
    if (new_domain) make_meter();
    if (new_data) find_exact_map();
    name_series();
    if (!state) {
        reset();
        return "The map could not be transferred; the run restarts from the uniform mesh.";
    }
    state_ = std::move(*state);
    last_untangled_ = untangled ? std::move(*untangled) : method_->initial_state();
    const Evaluation evaluation = method_->evaluate(data_, state_, {});
    GASPARD_CHECK(std::isfinite(evaluation.residual));
    restart_judging();
    record(evaluation, history_.back().iteration,
           back ? "values changed; restarted from the last mesh without tangled cells" : "values changed");
    measure(history_.back());
    return {};
}

std::shared_ptr<const Snapshot> Run::snapshot() {
    measure(history_.back());
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->mesh = discretisation_->mesh();
    snapshot->x = method_->positions();
    snapshot->tangled = tangled_;
    snapshot->exact = exact_;
    snapshot->control = discretisation_->control_points();
    snapshot->patches = discretisation_->patches();
    Field monitor{mesh_colour("monitor"), std::vector<double>(snapshot->x.size())};
    data_.monitor->values(snapshot->x, monitor.values);
    const FieldInfo mass{.name = "mass", .label = "cell mass", .symbol = "Mᵢ", .place = FieldPlace::cell};
    snapshot->fields = {std::move(monitor),
                        {mass, meter_->quality().cell_mass},
                        {mesh_colour("jacobian"), meter_->quality().cell_jacobian}};
    add_fields_of_method(*snapshot);
    snapshot->report = history_.back();
    snapshot->version = version_;
    return snapshot;
}

void Run::add_fields_of_method(Snapshot& snapshot) {
    const std::vector<FieldInfo>& infos = method_type().fields;
    auto values = method_->fields(data_);
    GASPARD_CHECK(values.size() == infos.size());
    for (std::size_t i = 0; i < infos.size(); ++i) {
        const bool of_nodes = infos[i].place == FieldPlace::node;
        GASPARD_CHECK(values[i].size() ==
                      (of_nodes ? snapshot.mesh->node_count() : snapshot.mesh->cell_count()));
        snapshot.fields.push_back({infos[i], std::move(values[i])});
    }
}

} // namespace gaspard
