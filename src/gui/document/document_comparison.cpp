// Several methods on the problem of a document's first run, each as a run of the document.
#include "core/base/check.hpp"
#include "gui/document/document.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

/// How far a run is, by the logarithm of its residual.
double share_done(const DocumentRun& run) {
    if (run.history.empty()) return 0;
    if (run.ended()) return 1;
    const double tolerance = run.scenario.method.values.real("tolerance");
    const double first = run.history.front().residual, now = run.history.back().residual;
    if (!(first > tolerance) || !(now > 0)) return 0;
    return std::clamp(std::log(first / now) / std::log(first / tolerance), 0.0, 1.0);
}

} // namespace

DocumentRun* Document::run_numbered(std::uint64_t number) {
    const auto found = std::find_if(runs_.begin(), runs_.end(),
                                    [number](const DocumentRun& run) { return run.number == number; });
    return found == runs_.end() ? nullptr : &*found;
}

/// Takes the place of the comparison before.
void Document::compare(std::vector<std::string> methods) {
    GASPARD_CHECK(!runs_.empty() && runs_.front().live());
    cancel_comparison();
    for (const auto& [method, number] : comparison_.begun)
        for (std::size_t i = 1; i < runs_.size(); ++i)
            if (runs_[i].number == number) remove(i--);
    comparison_ = {.scenario = runs_.front().scenario, .waiting = {}, .begun = {}, .total = methods.size()};
    comparison_.waiting.assign(methods.begin(), methods.end());
    const bool solving = runs_.front().solving();
    if (solving) pause(0); // the methods have the cores for themselves
    comparison_.resume = solving;
    compare_next();
}

void Document::compare_next() {
    if (comparison_.waiting.empty()) {
        resume_first();
        return;
    }
    const std::string method = comparison_.waiting.front();
    comparison_.waiting.pop_front();
    const Scenario scenario = with_method(*catalogue_, comparison_.scenario, method);
    DocumentRun run = make_run(scenario);
    run.title = runs_.front().title;
    run.name = free_name(catalogue_->method(method).label);
    run.solver = make_solver(scenario);
    comparison_.begun.emplace_back(method, run.number);
    comparison_.now = run.number;
    runs_.push_back(std::move(run));
}

/// A run whose method has come to its end stays as it is, and the next method has its turn.
void Document::collect_comparison() {
    DocumentRun* run = comparison_.now != 0 ? run_numbered(comparison_.now) : nullptr;
    if (!run || !run->ended()) return;
    const bool told = !run->history.empty() && is_final(run->history.back().status);
    const bool gave_up = run->status.run == RunStatus::failed || run->status.run == RunStatus::interrupted;
    if (!told && !(gave_up && run->status.messages > 0)) return; // the sentence why follows the status
    let_rest(*run);
    comparison_.now = 0;
    compare_next();
}

void Document::let_rest(DocumentRun& run) {
    // A step under way may be a long one: the solver stops, but the window does not wait for it.
    std::erase_if(leaving_, [](const std::future<void>& one) {
        return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    leaving_.push_back(
        std::async(std::launch::async, [solver = std::move(run.solver)]() mutable { solver.reset(); }));
    run.wants_to_run = false;
    if (run.ended()) return;
    run.status.run = RunStatus::interrupted;
    run.status.activity.clear();
    if (!run.history.empty()) run.history.back().status = RunStatus::interrupted;
}

void Document::cancel_comparison() {
    comparison_.waiting.clear();
    if (DocumentRun* run = comparison_.now != 0 ? run_numbered(comparison_.now) : nullptr) let_rest(*run);
    comparison_.now = 0;
    resume_first();
}

/// Goes on with the first run, where nobody else has said meanwhile what it is to do.
void Document::resume_first() {
    if (std::exchange(comparison_.resume, false) && !runs_.front().ended()) start(0);
}

double Document::comparison_progress() const {
    double done = 0;
    for (const DocumentRun& run : runs_)
        for (const auto& [method, number] : comparison_.begun)
            if (run.number == number) done += run.live() ? share_done(run) : 1;
    return comparison_.total > 0 ? done / static_cast<double>(comparison_.total) : 0;
}

std::vector<ComparisonRow> Document::comparison_rows() const {
    std::vector<ComparisonRow> rows;
    for (const auto& [method, number] : comparison_.begun)
        for (const DocumentRun& run : runs_) {
            if (run.number != number) continue;
            rows.push_back(comparison_row(method, run.history));
            if (run.ended()) rows.back().status = run.status.run;
        }
    return rows;
}

} // namespace gaspard
