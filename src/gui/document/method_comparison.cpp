#include "gui/document/method_comparison.hpp"

#include "core/base/check.hpp"
#include "gui/document/document.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

/// Progress of a run, by the logarithm of the series that ends it.
double share_done(const DocumentRun& run) {
    if (!run.live() || run.ended()) return 1;
    if (run.history.empty()) return 0;
    const double tolerance = run.scenario.method.values.real("tolerance");
    const auto criterion = [](const StepReport& report) {
        return report.value(report.series->criterion()).value_or(0);
    };
    const double first = criterion(run.history.front()), now = criterion(run.history.back());
    if (!(first > tolerance) || !(now > 0)) return 0;
    return std::clamp(std::log(first / now) / std::log(first / tolerance), 0.0, 1.0);
}

} // namespace

void MethodComparison::begin(const std::vector<std::string>& methods) {
    DocumentRun& active = document_.active();
    GASPARD_CHECK(active.live());
    cancel();
    for (const auto& [method, run] : started_) document_.discard(run);
    started_.clear();
    scenario_ = active.scenario;
    waiting_.assign(methods.begin(), methods.end());
    total_ = methods.size();
    const bool solving = active.solving();
    if (solving) document_.pause(active.id); // so that the methods have all cores
    resume_ = solving;
    begin_next();
}

void MethodComparison::begin_next() {
    if (waiting_.empty()) {
        resume_active_run();
        return;
    }
    const std::string method = waiting_.front();
    waiting_.pop_front();
    now_ = document_.open_for_comparison(scenario_, method).id;
    started_.emplace_back(method, now_);
}

void MethodComparison::collect() {
    DocumentRun* run = document_.runs().find(now_);
    if (!run || !run->ended()) return;
    const bool told = !run->history.empty() && is_final(run->history.back().status);
    const bool gave_up = run->status.run == RunStatus::failed || run->status.run == RunStatus::interrupted;
    if (!told && !(gave_up && run->status.messages > 0)) return; // the message follows the status
    end_solver(*run);
    now_ = no_run;
    begin_next();
}

void MethodComparison::end_solver(DocumentRun& run) {
    // The step at work may take long: the window does not wait for it.
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

void MethodComparison::cancel() {
    waiting_.clear();
    if (DocumentRun* run = document_.runs().find(now_)) end_solver(*run);
    now_ = no_run;
    resume_active_run();
}

void MethodComparison::resume_active_run() {
    if (!std::exchange(resume_, false)) return;
    const DocumentRun& active = document_.active();
    if (!active.ended()) document_.start(active.id);
}

double MethodComparison::progress() const {
    double done = 0;
    for (const auto& [method, id] : started_)
        if (const DocumentRun* run = document_.runs().find(id)) done += share_done(*run);
    return total_ > 0 ? done / static_cast<double>(total_) : 0;
}

std::vector<ComparisonRow> MethodComparison::rows() const {
    std::vector<ComparisonRow> rows;
    for (const auto& [method, id] : started_)
        if (const DocumentRun* run = document_.runs().find(id)) {
            rows.push_back(comparison_row(method, run->history));
            if (run->ended()) rows.back().status = run->status.run;
        }
    return rows;
}

} // namespace gaspard
