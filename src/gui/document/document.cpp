#include "gui/document/document.hpp"

#include "core/base/check.hpp"
#include "gui/base/theme.hpp"
#include "gui/document/value_changes.hpp"

#include <algorithm>
#include <array>
#include <thread>
#include <tuple>
#include <utility>

namespace gaspard {

namespace {

constexpr double one_drag = 0.5; // seconds of solving between changes that belong together

std::string title_of(const Scenario& scenario) {
    return scenario.title.empty() ? scenario.name : scenario.title;
}

bool same(const SolverStatus& a, const SolverStatus& b) {
    return a.run == b.run && a.paused == b.paused && a.progress == b.progress && a.activity == b.activity &&
           a.messages == b.messages && a.answered == b.answered;
}

void begin_anew(DocumentRun& run) {
    run.history.clear();
    run.curves.clear();
    run.marks.clear();
    run.marked.reset();
}

/// Notes what has changed at the last report.
void mark_change(DocumentRun& run) {
    if (!run.marked || !run.status.scenario) return;
    const StepReport& report = run.history.back();
    const bool same_drag = !run.marks.empty() && report.seconds <= run.marks.back().last_seconds + one_drag;
    ChangeMark mark = same_drag ? run.marks.back()
                                : ChangeMark{.iteration = static_cast<double>(report.iteration),
                                             .seconds = report.seconds,
                                             .last_seconds = report.seconds,
                                             .before = run.marked,
                                             .text = {}};
    mark.last_seconds = report.seconds;
    mark.text = describe_changes(value_changes(*mark.before, *run.status.scenario));
    if (same_drag) run.marks.pop_back();
    if (!mark.text.empty()) run.marks.push_back(std::move(mark));
    run.marked = run.status.scenario;
}

void append(DocumentRun& run, const SolverEvent& event) {
    if (event.restarted) begin_anew(run);
    // A change of values adds a row for the iterate there is.
    const bool changed = !run.history.empty() && event.report.iteration == run.history.back().iteration;
    run.history.push_back(event.report);
    run.curves.append(event.report);
    if (changed) mark_change(run);
}

} // namespace

std::optional<double> iteration_rate(const std::vector<StepReport>& history) {
    if (history.size() < 2) return std::nullopt;
    const StepReport& last = history.back();
    const auto first = std::find_if(history.rbegin() + 1, history.rend() - 1, [&](const StepReport& report) {
        return report.seconds < last.seconds - 1;
    });
    const double seconds = last.seconds - first->seconds;
    if (!(seconds > 0)) return std::nullopt;
    return (last.iteration - first->iteration) / seconds;
}

Scenario for_window(const Catalogue& catalogue, Scenario scenario) {
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

DocumentRun Document::make_run(const Scenario& scenario) {
    DocumentRun run;
    run.number = ++last_number_;
    run.title = title_of(scenario);
    run.opened = run.scenario = scenario;
    run.name = describe_scenario(*catalogue_, scenario, scenario);
    run.colour = free_colour();
    return run;
}

DocumentRun& Document::add(const Scenario& scenario) {
    viewports_.push_back({.run = runs_.size(), .view = scenario.view});
    return runs_.emplace_back(make_run(scenario));
}

void Document::open(const Scenario& scenario) { add(scenario).solver = make_solver(scenario); }

std::unique_ptr<SolverThread> Document::make_solver(const Scenario& scenario) const {
    SolverThread::Options options;
    options.notify = notify_;
    options.before_publishing = before_publishing_;
    const unsigned cores = std::thread::hardware_concurrency(); // one of them is left to the window
    options.run.threads = cores > 2 ? static_cast<int>(cores) - 1 : 1;
    return std::make_unique<SolverThread>(catalogue_, scenario, std::move(options));
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

void Document::change(std::size_t run, const Scenario& scenario) {
    DocumentRun& entry = runs_[run];
    GASPARD_CHECK(entry.live());
    entry.scenario = scenario;
    entry.name = describe_scenario(*catalogue_, entry.opened, scenario);
    entry.asked_for_good = ++entry.asked;
    entry.solver->post(ChangeCommand{scenario, entry.asked});
}

void Document::change_by_hand(std::size_t run, const Scenario& scenario) {
    const std::uint64_t for_good = runs_[run].asked_for_good;
    change(run, scenario);
    runs_[run].asked_for_good = for_good;
}

void Document::replace(std::size_t run, const Scenario& scenario) {
    DocumentRun& entry = runs_[run];
    GASPARD_CHECK(entry.live());
    entry.asked_for_good = ++entry.asked;
    entry.opening = {entry.asked, scenario};
    entry.solver->post(ChangeCommand{scenario, entry.asked, true});
}

/// What was opened is there.
void Document::finish_opening(DocumentRun& run) {
    const Scenario& scenario = run.opening->scenario;
    run.opened = run.scenario = scenario;
    run.title = title_of(scenario);
    run.name = describe_scenario(*catalogue_, scenario, scenario);
    run.wants_to_run = true;
    if (&run == &runs_.front()) leave_waiting(0);
    ++run.openings;
    for (DocumentViewport& viewport : viewports_)
        if (&runs_[viewport.run] == &run) viewport.view = scenario.view;
}

void Document::take_answer(DocumentRun& run) {
    run.answered = run.status.answered;
    if (run.opening && run.opening->number <= run.answered) {
        const bool there = run.opening->number == run.answered && !run.status.refused;
        if (there) finish_opening(run);
        run.opening.reset();
    }
    // What was refused, or cancelled, is no longer shown as if it were so.
    if (run.answered == run.asked && run.status.refused && run.status.scenario) {
        run.scenario = *run.status.scenario;
        run.name = describe_scenario(*catalogue_, run.opened, run.scenario);
    }
}

/// What is asked of the first run from now on is no longer the comparison's affair.
void Document::leave_waiting(std::size_t run) {
    if (run == 0) comparison_.resume = false;
}

void Document::start(std::size_t run) {
    leave_waiting(run);
    if (runs_[run].ended()) runs_[run].solver->post(ResetCommand{});
    runs_[run].solver->post(StartCommand{});
    runs_[run].wants_to_run = true;
}

void Document::pause(std::size_t run) {
    leave_waiting(run);
    runs_[run].solver->post(PauseCommand{});
    runs_[run].wants_to_run = false;
}

void Document::step(std::size_t run) {
    leave_waiting(run);
    runs_[run].solver->post(StepCommand{});
    runs_[run].wants_to_run = false;
}

void Document::reset(std::size_t run) {
    if (runs_[run].ended()) pause(run);
    runs_[run].solver->post(ResetCommand{});
}

bool Document::collect() {
    bool news = false;
    for (DocumentRun& run : runs_)
        if (run.live()) news = collect(run) || news;
    collect_comparison();
    return news;
}

bool Document::collect(DocumentRun& run) {
    SolverStatus status = run.solver->status(); // first: a run that has ended has told all it has to tell
    const std::vector<SolverEvent> events = run.solver->drain();
    status.scenario = run.solver->status().scenario; // of the last of these events
    auto snapshot = run.solver->latest();
    const bool news = !events.empty() || snapshot != run.snapshot || !same(status, run.status);
    // All that waits for an answer, which may come after the sentence that belongs to it.
    const bool by_hand = run.answered < run.asked && run.asked_for_good <= run.answered;
    const bool news_of_change = status.answered != run.answered;
    run.snapshot = std::move(snapshot);
    run.status = std::move(status);
    if (news_of_change) take_answer(run);
    for (SolverMessage& message : run.solver->take_messages())
        run.messages.push_back({std::move(message.text), message.error, by_hand});
    for (const SolverEvent& event : events) append(run, event);
    if (run.history.size() <= 1 || !run.marked) // nothing has been solved with other values yet
        run.marked = run.status.scenario ? run.status.scenario : std::make_shared<const Scenario>(run.opened);
    return news;
}

std::optional<std::size_t> Document::keep(std::size_t run) {
    collect();
    const DocumentRun& source = runs_[run];
    if (source.history.empty()) return std::nullopt;
    DocumentRun kept;
    kept.number = ++last_number_;
    kept.title = source.title;
    kept.opened = source.opened;
    // What the history was made with, should the solver still be on its way to newer values.
    kept.scenario = source.status.scenario ? *source.status.scenario : source.scenario;
    kept.history = source.history;
    kept.curves = source.curves;
    kept.marks = source.marks;
    kept.snapshot = source.snapshot;
    kept.status = source.status;
    kept.wants_to_run = false;
    kept.marked = source.marked;
    kept.colour = free_colour();
    kept.name = free_name(describe_scenario(*catalogue_, kept.opened, kept.scenario));
    runs_.push_back(std::move(kept));
    return runs_.size() - 1;
}

void Document::remove(std::size_t run) {
    GASPARD_CHECK(run < runs_.size() && !runs_[run].live());
    runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(run));
    for (DocumentViewport& viewport : viewports_) {
        if (viewport.run == run) viewport.run = 0;
        if (viewport.run > run) --viewport.run;
    }
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

/// The first that no run has; when all are taken, the one that fewest have.
std::size_t Document::free_colour() const {
    std::array<int, std::tuple_size_v<decltype(Theme::curves)>> users{};
    for (const DocumentRun& run : runs_) ++users[run.colour % users.size()];
    return static_cast<std::size_t>(std::min_element(users.begin(), users.end()) - users.begin());
}

} // namespace gaspard
