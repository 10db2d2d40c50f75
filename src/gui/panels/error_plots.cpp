#include "gui/panels/error_plots.hpp"

#include "core/io/study_files.hpp"
#include "gui/panels/slider_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace gaspard {

namespace {

/// What the plot varies, if it is an error study of this problem.
std::optional<StudyVariable> variable_shown(const DocumentRun& run, const PlotChoice& choice) {
    if (choice.plot != error_study_plot || !run.live() || study_variables(run.scenario).empty())
        return std::nullopt;
    if (study_key(run.scenario, choice.abscissa).empty()) return std::nullopt;
    return choice.abscissa;
}

double last_error(const DocumentRun& run, const std::string& measure) {
    for (auto report = run.history.rbegin(); report != run.history.rend(); ++report)
        if (const auto error = report->value(measure)) return *error;
    return std::numeric_limits<double>::quiet_NaN();
}

std::string state_text(const ErrorStudy& study, const ErrorStudy::Result& result) {
    if (!study.current()) return "Of earlier values";
    if (!result.complaint.empty()) return result.complaint;
    const std::size_t all = study.plan()->size(), done = result.points.size();
    if (!result.done) return std::to_string(done) + " of " + std::to_string(all) + " runs";
    const auto failed = std::count_if(result.points.begin(), result.points.end(),
                                      [](const StudyPoint& point) { return !point.complaint.empty(); });
    if (failed > 0) return std::to_string(failed) + " of " + std::to_string(all) + " runs failed";
    const std::vector<std::string> absences = study_absences(result.points);
    return absences.empty() ? std::string() : absences.front();
}

Plot with_axes(Plot plot, const PlotChoice& choice) {
    plot.x.logarithmic = choice.log_x, plot.y.logarithmic = choice.log_y;
    return plot;
}

Plot plot_of(const ErrorStudy& study, const DocumentRun& run, const PlotChoice& choice) {
    Plot plot;
    const auto variable = variable_shown(run, choice);
    if (!variable) {
        plot.title = "No error study for this problem";
        return plot;
    }
    const std::string key = study_key(run.scenario, *variable);
    if (!study.plan() || study.plan()->over.key != key) {
        plot.title = "Waits until the run rests";
        return plot;
    }
    const ErrorStudy::Result result = study.result();
    plot = with_axes(study_plot(*study.plan(), result.points), choice);
    plot.title = state_text(study, result);
    if (const auto x = study_number(run.scenario, key)) {
        plot.curves.push_back({"now", {*x}, {last_error(run, study.plan()->measure)}, true, neutral_colour});
        plot.marks.push_back({*x, "the present values", *variable != "cells"});
    }
    return plot;
}

} // namespace

ErrorPlots::ErrorPlots(const std::shared_ptr<const Catalogue>& catalogue, const std::function<void()>& wake)
    : studies_{{{catalogue, wake}, {catalogue, wake}}}, table_(catalogue, wake) {}

void ErrorPlots::follow(const DocumentRun& run, const Choices& choices, bool plots, bool table) {
    const bool rests = run.changes.settled() && !run.opening && (run.ended() || !run.wants_to_run);
    const auto serve = [&](ErrorStudy& study, std::optional<StudyVariable> variable) {
        if (variable)
            study.follow(run.scenario, *variable, rests);
        else
            study.leave();
    };
    for (std::size_t place = 0; place < studies_.size(); ++place)
        serve(studies_[place], plots ? variable_shown(run, choices[place]) : std::nullopt);
    const bool layers = run.live() && !study_variables(run.scenario).empty();
    serve(table_, table && layers ? std::optional<StudyVariable>("cells") : std::nullopt);
}

std::array<Plot, 2> ErrorPlots::plots(const DocumentRun& run, const Choices& choices) const {
    std::array<Plot, 2> all;
    for (std::size_t place = 0; place < all.size(); ++place)
        if (choices[place].plot == error_study_plot)
            all[place] = plot_of(studies_[place], run, choices[place]);
    return all;
}

Plot ErrorPlots::for_file(std::size_t place, const PlotChoice& choice) const {
    const ErrorStudy& study = studies_[place];
    if (!study.plan()) return {};
    return with_axes(study_plot(*study.plan(), study.result().points), choice);
}

std::string ErrorPlots::csv(std::size_t place) const {
    const ErrorStudy& study = studies_[place];
    return study.plan() ? study_csv(*study.plan(), study.result().points) : std::string();
}

Scenario with_sweep(const Catalogue& catalogue, const Scenario& scenario, const PlotSweep& sweep) {
    const std::string key = study_key(scenario, sweep.variable);
    const ParameterRow* row = study_row(scenario, key);
    if (!row) return scenario;
    const double allowed = std::clamp(sweep.value, row->minimum, row->maximum);
    const double value = std::clamp(rounded(*row, slider_ends(*row), allowed), row->minimum, row->maximum);
    const bool whole = row->kind == ParameterKind::integer;
    Scenario changed = scenario;
    set_value_unlocated(catalogue, changed, key,
                        whole ? Value(std::int64_t{std::llround(value)}) : Value(value));
    return changed;
}

} // namespace gaspard
