#include "gui/document/document_run.hpp"

#include "core/base/check.hpp"
#include "core/base/join.hpp"
#include "core/session/history_thinning.hpp"
#include "gui/document/value_changes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gaspard {

namespace {

auto with_id(RunId id) {
    return [id](const DocumentRun& run) { return run.id == id; };
}

/// Makes the history that of an earlier solve; nothing if no step was made, or only output was changed.
void put_aside(DocumentRun& run, const Catalogue& catalogue) {
    if (run.history.size() < 2 || !run.solved || !run.status.scenario) return;
    if (!alike(*run.solved, *run.status.scenario)) return run.earlier.clear();
    std::string name = join(names_before(catalogue, value_changes(*run.solved, *run.status.scenario)), ", ");
    if (name.empty()) return;
    run.earlier.push_back({std::move(run.curves), std::move(name)});
    if (run.earlier.size() > most_earlier) run.earlier.pop_front();
}

void begin_history(DocumentRun& run, const Catalogue& catalogue, SolverEventKind kind) {
    if (kind == SolverEventKind::change) put_aside(run, catalogue);
    if (kind == SolverEventKind::restart) run.earlier.clear();
    run.history.clear();
    run.curves.clear();
    ++run.histories;
    run.solved = kind == SolverEventKind::restart ? nullptr : run.status.scenario;
}

/// A choice of the domain; empty where it has none.
std::string choice_of(const Scenario& scenario, std::string_view key) {
    const Values& domain = scenario.domain.values;
    return domain.has(key) ? domain.text(key) : std::string();
}

} // namespace

bool alike(const Scenario& a, const Scenario& b) {
    const auto of_one_kind = [&](auto key) { return choice_of(a, key) == choice_of(b, key); };
    return a.domain.type == b.domain.type && of_one_kind("boundary") && of_one_kind("shape") &&
           of_one_kind("file") && a.monitor.type == b.monitor.type && a.source.type == b.source.type &&
           a.pde.type == b.pde.type;
}

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

void append(DocumentRun& run, const Catalogue& catalogue, const SolverEvent& event) {
    if (event.kind == SolverEventKind::completion) {
        if (run.history.empty()) return;
        run.curves.complete(run.history.back(), event.report);
        run.history.back() = event.report;
        return;
    }
    if (event.kind != SolverEventKind::step) begin_history(run, catalogue, event.kind);
    run.history.push_back(event.report);
    if (!thin_out_time_steps(run.history)) return run.curves.append(event.report);
    run.curves.clear();
    for (const StepReport& report : run.history) run.curves.append(report);
}

std::size_t recorded_bytes(const DocumentRuns& runs) {
    std::size_t bytes = 0;
    for (const DocumentRun& run : runs) bytes += run.recording ? run.recording->bytes() : 0;
    return bytes;
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
