#include "gui/document/document.hpp"

#include "core/base/check.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/session/time_series.hpp"
#include "gui/base/theme.hpp"
#include "gui/document/value_changes.hpp"

#include <algorithm>
#include <array>
#include <thread>
#include <tuple>
#include <utility>

namespace gaspard {

namespace {

bool same(const SolverStatus& a, const SolverStatus& b) {
    return a.run == b.run && a.paused == b.paused && a.progress == b.progress && a.activity == b.activity &&
           a.messages == b.messages && a.answered == b.answered;
}

} // namespace

Scenario for_window(const Catalogue& catalogue, Scenario scenario) {
    if (has_time(scenario.time)) return scenario; // its method suits meshes that follow
    const auto methods = methods_for(catalogue, scenario);
    if (std::find(methods.begin(), methods.end(), "auto") != methods.end())
        return with_method(catalogue, scenario, "auto");
    if (const auto remedy = find_remedy(scenario.method.values))
        scenario.method.values.set(remedy->key, remedy->value);
    return scenario;
}

Document::Document(std::shared_ptr<const Catalogue> catalogue, std::function<void()> notify,
                   std::function<void(const Snapshot&)> before_publishing)
    : catalogue_(std::move(catalogue)), notify_(std::move(notify)),
      before_publishing_(std::move(before_publishing)) {}

DocumentRun& Document::active() {
    DocumentRun* run = runs_.find(active_);
    GASPARD_CHECK(run);
    return *run;
}

const DocumentRun& Document::active() const {
    const DocumentRun* run = runs_.find(active_);
    GASPARD_CHECK(run);
    return *run;
}

DocumentRun& Document::live(RunId run) {
    DocumentRun* found = runs_.find(run);
    GASPARD_CHECK(found && found->live());
    return *found;
}

DocumentRun Document::make_run(const Scenario& scenario) {
    DocumentRun run;
    run.id = RunId{++last_id_};
    run.title = scenario_title(scenario);
    run.opened = run.scenario = scenario;
    run.name = describe_scenario(*catalogue_, scenario, scenario);
    run.colour = free_colour();
    return run;
}

/// All recordings together may take so much memory.
void Document::share_memory() {
    std::size_t recordings = 0;
    for (const DocumentRun& run : runs_) recordings += run.recording ? 1 : 0;
    for (DocumentRun& run : runs_)
        if (run.recording) run.recording->set_budget(recording_memory / recordings);
}

DocumentRun& Document::add(const Scenario& scenario) {
    DocumentRun& run = runs_.push_back(make_run(scenario));
    if (active_ == no_run) active_ = run.id;
    viewports_.push_back({.run = run.id, .view = scenario.view});
    recorded_.push_back(scenario.view);
    update_views(run);
    return run;
}

void Document::open(const Scenario& scenario, const std::optional<Scenario>& named) {
    name_opened(scenario, named.value_or(scenario));
    DocumentRun& run = add(scenario);
    name_values(run);
    attach_solver(run);
    share_memory();
}

void Document::name_opened(const Scenario& opened, const Scenario& named) {
    std::erase_if(named_, [&](const NamedValues& one) { return one.opened == opened; });
    named_.push_back({opened, named});
}

void Document::name_saved(RunId run, const Scenario& saved) {
    DocumentRun& entry = live(run);
    std::erase_if(named_, [&](const NamedValues& one) { // the file has other values now
        return one.named.name == saved.name && one.opened == entry.opened;
    });
    named_.push_back({entry.opened, saved});
    if (!entry.opening) post_change(entry, Scenario(entry.scenario)); // what is exported has the name, too
}

/// Gives a scenario, of a run that was opened as `opened`, name and title by its values.
void Document::name_values(const Scenario& opened, Scenario& scenario) const {
    for (const NamedValues& one : named_) {
        if (one.opened != opened) continue;
        scenario.name = one.named.name;
        scenario.title = one.named.title;
        scenario.description = one.named.description;
        scenario.modified = modified_keys(one.named, scenario);
        if (scenario.modified.empty()) return;
    }
}

void Document::name_values(DocumentRun& run) const {
    name_values(run.opened, run.scenario);
    run.title = scenario_title(run.scenario);
}

DocumentRun& Document::open_for_comparison(const Scenario& scenario, const std::string& method) {
    const Scenario own = with_method(*catalogue_, scenario, method);
    DocumentRun run = make_run(own);
    run.title = active().title;
    run.name = free_name(catalogue_->method(method).label);
    attach_solver(run);
    DocumentRun& added = runs_.push_back(std::move(run));
    share_memory();
    return added;
}

/// Begins to solve the run's values.
void Document::attach_solver(DocumentRun& run) const {
    run.recording = std::make_shared<Recording>(recording_memory);
    SolverThread::Options options;
    options.recording = run.recording;
    options.notify = notify_;
    options.before_publishing = before_publishing_;
    options.interpolation_share = 0.1;
    options.rest_for_drawing = 0.03;
    options.nicer = 3;                                          // as the painter of meshes
    const unsigned cores = std::thread::hardware_concurrency(); // one of them is left to the window
    options.run.threads = cores > 2 ? static_cast<int>(cores) - 1 : 1;
    run.solver = std::make_unique<SolverThread>(catalogue_, run.scenario, std::move(options));
}

void Document::show(const FinishedRun& finished) {
    GASPARD_CHECK(!finished.history.empty());
    DocumentRun& run = add(finished.scenario);
    run.history = finished.history;
    for (const StepReport& report : run.history) run.curves.append(report);
    run.snapshot = finished.snapshot;
    run.status.run = run.history.back().status;
    run.wants_to_run = false;
}

void Document::change(RunId run, const Scenario& scenario, bool dragging) {
    DocumentRun& entry = live(run);
    const bool other_types = scenario.method.type != entry.scenario.method.type ||
                             scenario.monitor.type != entry.scenario.monitor.type;
    if (other_types) record_views();
    const RunValues before = values_of(entry);
    const std::vector<EditPart> views = views_of(run);
    const std::uint64_t for_good = entry.changes.asked_for_good;
    std::string key = "values " + std::to_string(static_cast<std::uint64_t>(run));
    for (const ValueChange& one : scenario_changes(before.scenario, scenario))
        key += dragging ? "" : " " + one.key;
    post_change(entry, scenario, edits_.continues(key));
    if (dragging) entry.changes.asked_for_good = for_good;
    const RunValues after = values_of(entry);
    Edit edit{.key = std::move(key), .before = {before}, .after = {after}, .settled = false};
    if (other_types) { // they may have other fields to colour by
        edit.before.insert(edit.before.end(), views.begin(), views.end());
        for (EditPart& view : views_of(run)) edit.after.push_back(std::move(view));
    }
    record(std::move(edit));
}

/// Gives the views of a run the choices of its method and its monitor, such as the fields to colour by.
void Document::update_views(const DocumentRun& run) {
    for (std::size_t i = 0; i < viewports_.size() && i < recorded_.size(); ++i)
        if (viewports_[i].run == run.id)
            for (Values* view : {&viewports_[i].view, &recorded_[i]})
                update_view_rows(*catalogue_, run.scenario, *view);
}

void Document::post_change(DocumentRun& run, const Scenario& scenario, bool same_gesture) {
    run.opening.reset(); // superseded: the solver goes on to these values
    run.scenario = scenario;
    name_values(run);
    run.name = describe_scenario(*catalogue_, run.opened, scenario);
    update_views(run);
    run.changes.asked_for_good = ++run.changes.asked;
    run.solver->post(
        ChangeCommand{.scenario = run.scenario, .number = run.changes.asked, .same_gesture = same_gesture});
}

void Document::reread(RunId run) {
    DocumentRun& entry = live(run);
    if (entry.opening) return; // they are being read
    entry.changes.asked_for_good = ++entry.changes.asked;
    entry.solver->post(
        ChangeCommand{.scenario = entry.scenario, .number = entry.changes.asked, .reread = true});
}

void Document::start_from(RunId run, std::shared_ptr<const State> state) {
    DocumentRun& entry = live(run);
    if (entry.opening) return; // the state is of other values
    entry.changes.asked_for_good = ++entry.changes.asked;
    entry.wants_to_run = true;
    entry.solver->post(ChangeCommand{
        .scenario = entry.scenario, .number = entry.changes.asked, .anew = true, .start = std::move(state)});
}

std::optional<WentBack> Document::go_on_from(RunId run, const RecordedIterate& iterate) {
    DocumentRun& entry = live(run);
    if (entry.opening) return std::nullopt;
    end_gesture();
    const DocumentRun* kept = add_copy(run);
    entry.changes.asked_for_good = ++entry.changes.asked;
    entry.wants_to_run = false;
    entry.solver->post(ChangeCommand{.scenario = entry.scenario,
                                     .number = entry.changes.asked,
                                     .anew = true,
                                     .paused = true,
                                     .start = iterate.state(),
                                     .time = time_of(iterate.report())});
    return WentBack{kept ? std::optional(kept->id) : std::nullopt};
}

void Document::replace(RunId run, const Scenario& scenario) {
    post_opening(live(run), {.opened = scenario, .scenario = scenario});
}

void Document::post_opening(DocumentRun& run, RunOpening opening) {
    if (opening.from_history) name_values(opening.opened, opening.scenario);
    opening.number = run.changes.asked_for_good = ++run.changes.asked;
    run.solver->post(ChangeCommand{opening.scenario, opening.number, true});
    run.opening = std::move(opening);
}

void Document::take_answer(DocumentRun& run) {
    run.changes.answered = run.status.answered;
    if (run.opening && run.opening->number <= run.changes.answered) {
        const bool accepted = run.opening->number == run.changes.answered && !run.status.refused;
        if (accepted) finish_opening(run);
        run.opening.reset();
    }
    if (!run.changes.settled()) return;
    if (!run.status.refused) {
        take_place(run);
        edits_.settle(run.id);
    } else if (run.status.scenario) { // back to the values that the solver works with
        run.scenario = *run.status.scenario;
        name_values(run);
        run.name = describe_scenario(*catalogue_, run.opened, run.scenario);
        update_views(run);
        take_back_refused(run);
    }
    moves_.clear();
}

/// The solver has read the file of another domain, or the same file anew; monitors are fitted to it.
void Document::take_place(DocumentRun& run) const {
    if (!run.status.scenario) return;
    const Scenario& read = *run.status.scenario;
    if (is_located(*catalogue_, run.scenario) && run.scenario.place.content == read.place.content) return;
    if (run.scenario.domain != read.domain || run.scenario.folder != read.folder) return;
    run.scenario.place = read.place;
    update_typed_rows(*catalogue_, run.scenario);
    name_values(run);
    run.name = describe_scenario(*catalogue_, run.opened, run.scenario);
}

void Document::start(RunId run) {
    if (run == active_) comparison_.leave_active_run();
    DocumentRun& entry = live(run);
    if (entry.ended()) entry.solver->post(ResetCommand{});
    entry.solver->post(StartCommand{});
    entry.wants_to_run = true;
}

void Document::pause(RunId run) {
    if (run == active_) comparison_.leave_active_run();
    DocumentRun& entry = live(run);
    entry.solver->post(PauseCommand{});
    entry.wants_to_run = false;
}

void Document::step(RunId run) {
    if (run == active_) comparison_.leave_active_run();
    DocumentRun& entry = live(run);
    entry.solver->post(StepCommand{});
    entry.wants_to_run = false;
}

void Document::reset(RunId run) {
    DocumentRun& entry = live(run);
    pause(run);
    entry.solver->post(ResetCommand{});
}

bool Document::collect() {
    bool news = false;
    for (DocumentRun& run : runs_)
        if (run.live()) news = collect(run) || news;
    comparison_.collect();
    return news;
}

/// What the views of a run show while its values change: the masses, as colours or of a picked cell, or not.
static Diagnostics needed(const std::vector<DocumentViewport>& viewports, RunId run) {
    const bool masses = std::any_of(viewports.begin(), viewports.end(), [&](const DocumentViewport& shown) {
        return shown.run == run &&
               (shown.view.text("color") == "equidistribution" || !shown.view.text("pick").empty());
    });
    return masses ? Diagnostics::full : Diagnostics::geometry;
}

bool Document::collect(DocumentRun& run) {
    run.solver->need(needed(viewports_, run.id));
    auto [status, messages] = run.solver->take_news(); // first: a run that has ended has sent all its reports
    const std::vector<SolverEvent> events = run.solver->drain();
    status.scenario = run.solver->status().scenario; // of the last of these events
    auto snapshot = run.solver->latest();
    const bool news = !events.empty() || snapshot != run.snapshot || !same(status, run.status);
    const bool dragging = run.changes.only_dragging();
    const bool answered = status.answered != run.changes.answered;
    run.snapshot = std::move(snapshot);
    run.status = std::move(status);
    if (answered) take_answer(run);
    for (SolverMessage& message : messages)
        run.messages.push_back({std::move(message.text), message.error, dragging});
    for (const SolverEvent& event : events) append(run, *catalogue_, event);
    if (run.history.size() <= 1 || !run.solved) // nothing has been solved with other values yet
        run.solved = run.status.scenario ? run.status.scenario : std::make_shared<const Scenario>(run.opened);
    return news;
}

std::string Document::free_name(const std::string& wish) const {
    const auto taken = [&](const std::string& name) {
        return std::any_of(runs_.begin(), runs_.end(),
                           [&](const DocumentRun& other) { return !other.live() && other.name == name; });
    };
    if (!taken(wish)) return wish;
    for (int number = 2;; ++number)
        if (const std::string numbered = wish + " (" + std::to_string(number) + ")"; !taken(numbered))
            return numbered;
}

/// The first colour that no run has; if all are taken, the one with the fewest runs.
std::size_t Document::free_colour() const {
    std::array<int, std::tuple_size_v<decltype(Theme::curves)>> users{};
    for (const DocumentRun& run : runs_) ++users[run.colour % users.size()];
    return static_cast<std::size_t>(std::min_element(users.begin(), users.end()) - users.begin());
}

} // namespace gaspard
