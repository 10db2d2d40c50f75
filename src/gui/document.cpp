#include "gui/document.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>

namespace gaspard {

namespace {

Plot against_iteration(std::string title) {
    return {.title = std::move(title), .x = {"iteration", false}, .y = {"", true}, .curves = {}};
}

/// On a logarithmic axis only positive numbers have a place; others leave a gap.
double positive_or_gap(double value) {
    return std::isfinite(value) && value > 0 ? value : std::numeric_limits<double>::quiet_NaN();
}

std::string title_of(const Scenario& scenario) {
    return scenario.title.empty() ? scenario.name : scenario.title;
}

bool same(const SolverStatus& a, const SolverStatus& b) {
    return a.run == b.run && a.paused == b.paused && a.progress == b.progress && a.activity == b.activity &&
           a.messages == b.messages && a.answered == b.answered;
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

Document::Document(std::shared_ptr<const Catalogue> catalogue, std::function<void()> notify)
    : catalogue_(std::move(catalogue)), notify_(std::move(notify)), residual_(against_iteration("Residual")),
      equidistribution_(against_iteration("Equidistribution")) {}

void Document::open(const Scenario& scenario) {
    DocumentRun run;
    run.title = title_of(scenario);
    run.opened = run.scenario = scenario;
    SolverThread::Options options;
    options.notify = notify_;
    const unsigned cores = std::thread::hardware_concurrency(); // one of them is left to the window
    options.run.threads = cores > 2 ? static_cast<int>(cores) - 1 : 1;
    run.solver = std::make_unique<SolverThread>(catalogue_, scenario, std::move(options));
    residual_.curves.push_back({.label = run.title, .x = {}, .y = {}});
    equidistribution_.curves.push_back({.label = run.title, .x = {}, .y = {}});
    viewports_.push_back({.run = runs_.size(), .view = scenario.view});
    runs_.push_back(std::move(run));
}

void Document::change(std::size_t run, const Scenario& scenario) {
    runs_[run].scenario = scenario;
    runs_[run].solver->post(ChangeCommand{scenario, ++runs_[run].asked});
}

void Document::replace(std::size_t run, const Scenario& scenario) {
    DocumentRun& entry = runs_[run];
    entry.opened = scenario;
    entry.title = title_of(scenario);
    residual_.curves[run].label = equidistribution_.curves[run].label = entry.title;
    for (DocumentViewport& viewport : viewports_)
        if (viewport.run == run) viewport.view = scenario.view;
    change(run, scenario);
    entry.solver->post(ResetCommand{});
    entry.solver->post(StartCommand{});
    entry.wants_to_run = true;
}

void Document::start(std::size_t run) {
    if (runs_[run].ended()) runs_[run].solver->post(ResetCommand{});
    runs_[run].solver->post(StartCommand{});
    runs_[run].wants_to_run = true;
}

void Document::pause(std::size_t run) {
    runs_[run].solver->post(PauseCommand{});
    runs_[run].wants_to_run = false;
}

void Document::step(std::size_t run) {
    runs_[run].solver->post(StepCommand{});
    runs_[run].wants_to_run = false;
}

void Document::reset(std::size_t run) {
    if (runs_[run].ended()) pause(run);
    runs_[run].solver->post(ResetCommand{});
}

bool Document::collect() {
    bool news = false;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        DocumentRun& run = runs_[i];
        SolverStatus status = run.solver->status(); // first: a run that has ended has told all it has to tell
        for (const SolverEvent& event : run.solver->drain()) append(i, event), news = true;
        if (auto snapshot = run.solver->latest(); snapshot != run.snapshot)
            run.snapshot = std::move(snapshot), news = true;
        news = news || !same(status, run.status);
        run.status = std::move(status);
        const bool news_of_change = run.status.answered != run.answered;
        run.answered = run.status.answered;
        // What was refused, or cancelled, is no longer shown as if it were so.
        if (news_of_change && run.answered == run.asked && run.status.refused && run.status.scenario)
            run.scenario = *run.status.scenario;
    }
    return news;
}

void Document::append(std::size_t run, const SolverEvent& event) {
    Curve& residual = residual_.curves[run];
    Curve& equidistribution = equidistribution_.curves[run];
    if (event.restarted) {
        runs_[run].history.clear();
        for (Curve* curve : {&residual, &equidistribution}) curve->x.clear(), curve->y.clear();
    }
    const StepReport& report = event.report;
    runs_[run].history.push_back(report);
    residual.x.push_back(report.iteration);
    residual.y.push_back(positive_or_gap(report.residual));
    if (report.equidistribution) {
        equidistribution.x.push_back(report.iteration);
        equidistribution.y.push_back(positive_or_gap(*report.equidistribution));
    }
}

} // namespace gaspard
