#include "gui/document/document_run.hpp"

#include "core/base/check.hpp"
#include "gui/document/value_changes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gaspard {

namespace {

constexpr double one_drag = 0.5; // seconds of solving between changes that share a mark

auto with_id(RunId id) {
    return [id](const DocumentRun& run) { return run.id == id; };
}

void clear_history(DocumentRun& run) {
    run.history.clear();
    run.curves.clear();
    run.marks.clear();
    run.marked.reset();
}

/// Marks the last report as the first with other values.
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

} // namespace

std::list<DocumentRun>::iterator DocumentRuns::at(std::size_t place) {
    GASPARD_CHECK(place < runs_.size());
    return std::next(runs_.begin(), static_cast<std::ptrdiff_t>(place));
}

const DocumentRun& DocumentRuns::operator[](std::size_t place) const {
    GASPARD_CHECK(place < runs_.size());
    return *std::next(runs_.begin(), static_cast<std::ptrdiff_t>(place));
}

DocumentRun& DocumentRuns::push_back(DocumentRun run) {
    runs_.push_back(std::move(run));
    return runs_.back();
}

DocumentRun* DocumentRuns::find(RunId id) {
    const auto found = std::find_if(runs_.begin(), runs_.end(), with_id(id));
    return found == runs_.end() ? nullptr : &*found;
}

const DocumentRun* DocumentRuns::find(RunId id) const {
    const auto found = std::find_if(runs_.begin(), runs_.end(), with_id(id));
    return found == runs_.end() ? nullptr : &*found;
}

std::size_t DocumentRuns::place_of(RunId id) const {
    const auto found = std::find_if(runs_.begin(), runs_.end(), with_id(id));
    return static_cast<std::size_t>(std::distance(runs_.begin(), found));
}

std::list<DocumentRun> DocumentRuns::take(RunId id) {
    std::list<DocumentRun> taken;
    taken.splice(taken.end(), runs_, at(place_of(id)));
    return taken;
}

DocumentRun& DocumentRuns::put_back(std::size_t place, std::list<DocumentRun> run) {
    GASPARD_CHECK(run.size() == 1);
    DocumentRun& same = run.front();
    runs_.splice(place < runs_.size() ? at(place) : runs_.end(), run);
    return same;
}

void append(DocumentRun& run, const SolverEvent& event) {
    if (event.restarted) clear_history(run);
    if (event.completes && !run.history.empty()) {
        run.curves.complete(run.history.back(), event.report);
        run.history.back() = event.report;
        return;
    }
    // A change of values adds a row for the current iterate.
    const bool changed = !run.history.empty() && event.report.iteration == run.history.back().iteration;
    run.history.push_back(event.report);
    run.curves.append(event.report);
    if (changed) mark_change(run);
}

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

} // namespace gaspard
