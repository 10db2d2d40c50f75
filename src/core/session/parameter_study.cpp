#include "core/session/parameter_study.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/number_text.hpp"
#include "core/layer/layer_pde.hpp"
#include "core/method/interval_method.hpp"
#include "core/method/quadrilateral_mesh_pde.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/session/interpolation_study.hpp"
#include "core/session/run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t most_runs = 5000;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool is_resolution(const Scenario& scenario, std::string_view key) {
    return key.starts_with("domain.") && key == "domain." + resolution_key(scenario);
}

bool over_cells(const StudyPlan& plan) { return is_resolution(plan.scenario, plan.over.key); }

std::string setting(const StudyAxis& axis, std::size_t place) { return axis.key + "=" + axis.values[place]; }

double number_at(const StudyAxis& axis, std::size_t place) {
    return parse_number(axis.values[place]).value_or(nan);
}

std::optional<double> bound_of(const Scenario& scenario) {
    const Values& domain = scenario.domain.values;
    if (scenario.pde.type.empty() || !domain.has("cells")) return std::nullopt;
    const auto cells = static_cast<double>(domain.integer("cells"));
    const auto bound = energy_bound(scenario.pde.type, scenario.pde.values, cells);
    return bound ? std::optional(bound->value) : std::nullopt;
}

std::string label_of(const SeriesInfo& info) {
    return info.plot ? info.plot->label + ", " + info.plot->part : info.label;
}

std::vector<std::string> measures_of(const StepReport& report) {
    std::vector<std::string> names;
    for (const SeriesInfo& one : report.series->all()) names.push_back(one.name);
    for (const char* further : {"iterations", "seconds", "cpu_seconds", "tangled_cells"})
        names.emplace_back(further);
    return names;
}

/// The last report of a run that has ended, with the measure if it is one that has to be asked for.
StepReport last_report(Run& run, const std::string& measure, const std::stop_token& stop) {
    const bool unknown = !run.history().back().value(measure).has_value();
    const bool known_name = run.history().back().series->find(measure).has_value();
    if (unknown && known_name) run.interpolation({.stop = stop});
    return run.history().back();
}

/// Why there is no such error; empty if it is not an error of a solution, or the reason is not known.
std::string absence_of(const Scenario& scenario, const std::string& measure) {
    if (!measure.ends_with("energy_error")) return {};
    if (scenario.pde.values.rows().empty())
        return "without a problem to solve there are no errors; set pde.type";
    const Values& method = scenario.method.values;
    if (method.has("reference")) {
        const auto cells = static_cast<int>(scenario.domain.values.integer("cells"));
        if (std::string why = why_without_errors(method.text("reference"), cells); !why.empty()) return why;
    }
    return measure.ends_with("exact_energy_error") ? "no closed form of the solution is known" : "";
}

/// False if it was stopped.
bool solve_point(const std::shared_ptr<const Catalogue>& catalogue, const StudyPlan& plan, int threads,
                 StudyPoint& point, const std::stop_token& stop) {
    try {
        Scenario scenario = study_scenario(*catalogue, plan, point.line, point.place);
        scenario.method.values.set("diagnostics", std::string("full"));
        point.bound = bound_of(scenario);
        const std::string absence = absence_of(scenario, plan.measure);
        Run run(catalogue, std::move(scenario), {.threads = threads}, {}, stop);
        run.solve(stop);
        if (run.status() == RunStatus::interrupted) return false;
        point.report = last_report(run, plan.measure, stop);
        if (std::isnan(study_value(point, plan.measure))) point.absence = absence;
    } catch (const Interrupted&) {
        return false;
    } catch (const InputError& error) {
        point.complaint = error.what(), point.refused = true;
    } catch (const std::exception& error) {
        point.complaint = error.what();
    }
    return true;
}

/// The reports of the first run that can be made; throws what is wrong with the last if none can.
std::vector<std::string> available_measures(const std::shared_ptr<const Catalogue>& catalogue,
                                            const StudyPlan& plan) {
    for (std::size_t i = 0;; ++i) {
        try {
            const std::size_t lines = plan.line_count();
            const Run run(catalogue, study_scenario(*catalogue, plan, i % lines, i / lines));
            return measures_of(run.history().back());
        } catch (const InputError&) {
            if (i + 1 == plan.size()) throw;
        }
    }
}

/// Throws InputError if in no run it makes a difference which value the key has.
void check_effect(const Catalogue& catalogue, const StudyPlan& plan, const std::string& key) {
    std::string why;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        const std::size_t lines = plan.line_count();
        why = why_without_effect(study_scenario(catalogue, plan, i % lines, i / lines), key);
        if (why.empty()) return;
    }
    throw InputError(why);
}

} // namespace

bool same_study(const StudyPlan& a, const StudyPlan& b) {
    const Scenario &one = a.scenario, &other = b.scenario;
    return a.over == b.over && a.lines == b.lines && a.measure == b.measure && one.domain == other.domain &&
           one.monitor == other.monitor && one.source == other.source && one.pde == other.pde &&
           one.method == other.method && same_time(one.time, other.time) && one.folder == other.folder;
}

Scenario study_scenario(const Catalogue& catalogue, const StudyPlan& plan, std::size_t line,
                        std::size_t place) {
    Scenario scenario = plan.scenario;
    std::vector<std::string> settings{setting(plan.over, place)};
    if (!plan.lines.key.empty()) settings.push_back(setting(plan.lines, line));
    apply_settings(catalogue, scenario, settings);
    return scenario;
}

void check_study(std::shared_ptr<const Catalogue> catalogue, const StudyPlan& plan) {
    if (plan.over.key == plan.lines.key) throw InputError("a study cannot vary " + plan.over.key + " twice");
    if (plan.size() > most_runs)
        throw InputError("the study has " + std::to_string(plan.size()) + " runs; at most " +
                         std::to_string(most_runs) + " are allowed");
    for (std::size_t line = 0; line < plan.line_count(); ++line)
        for (std::size_t place = 0; place < plan.over.values.size(); ++place)
            check(*catalogue, study_scenario(*catalogue, plan, line, place));
    for (const std::string& key : {plan.over.key, plan.lines.key}) check_effect(*catalogue, plan, key);
    const std::vector<std::string> names = available_measures(catalogue, plan);
    if (std::find(names.begin(), names.end(), plan.measure) == names.end())
        throw InputError("there is no measure '" + plan.measure + "'" + did_you_mean(plan.measure, names) +
                         "; available: " + join(names, ", "));
}

double study_value(const StudyPoint& point, std::string_view measure) {
    if (!point.report) return nan;
    const StepReport& report = *point.report;
    if (measure == "iterations") return report.all_iterations;
    if (measure == "seconds") return report.seconds;
    if (measure == "cpu_seconds") return report.cpu_seconds;
    if (measure == "tangled_cells")
        return report.tangled_cells ? static_cast<double>(*report.tangled_cells) : nan;
    return report.value(measure).value_or(nan);
}

std::string measure_label(std::span<const StudyPoint> points, std::string_view measure) {
    for (const StudyPoint& point : points) {
        if (!point.report) continue;
        const SeriesTable& table = *point.report->series;
        const auto place = table.find(measure);
        if (!place) continue;
        return label_of(table.all()[*place]);
    }
    for (const SeriesInfo& info : energy_error_series()) // before the first run, or if all fail
        if (info.name == measure) return label_of(info);
    if (const auto place = common_series()->find(measure)) return label_of(common_series()->all()[*place]);
    static constexpr std::array<std::pair<std::string_view, const char*>, 4> others{
        {{"iterations", "Iterations"},
         {"seconds", "Time in seconds"},
         {"cpu_seconds", "CPU time in seconds"},
         {"tangled_cells", "Tangled cells"}}};
    for (const auto& [name, label] : others)
        if (name == measure) return label;
    return std::string(measure);
}

std::string study_note(const StudyPoint& point) {
    if (!point.report) return point.complaint;
    if (point.report->status == RunStatus::converged) return point.absence;
    const std::string after = std::string(status_name(point.report->status)) + " after " +
                              std::to_string(point.report->all_iterations) + " iterations";
    return point.report->status == RunStatus::invalid_input ? after + ": " + point.report->note : after;
}

std::vector<std::string> study_absences(std::span<const StudyPoint> points) {
    std::vector<std::string> all;
    for (const StudyPoint& point : points)
        if (!point.absence.empty() && study_note(point) == point.absence &&
            std::find(all.begin(), all.end(), point.absence) == all.end())
            all.push_back(point.absence);
    return all;
}

bool has_factors(const Scenario& scenario, std::string_view key) {
    const ParameterRow* row = study_row(scenario, key);
    if (!row || row->kind == ParameterKind::choice || !(row->minimum > 0)) return false;
    return row->scale == ParameterScale::logarithmic || is_resolution(scenario, key);
}

bool has_orders(const StudyPlan& plan) {
    if (over_cells(plan)) return true;
    const ParameterRow* row = study_row(plan.scenario, plan.over.key);
    return row && row->scale == ParameterScale::logarithmic && row->minimum > 0;
}

std::string order_name(const StudyPlan& plan) { return over_cells(plan) ? "order" : "exponent"; }

double study_order(const StudyPlan& plan, const StudyPoint& before, const StudyPoint& now) {
    const double one = study_value(before, plan.measure), other = study_value(now, plan.measure);
    if (!(one > 0) || !(other > 0)) return nan;
    if (plan.over.key == "domain.refinements") return std::log2(one / other) / (now.x - before.x);
    if (!(before.x > 0) || !(now.x > 0)) return nan;
    return (over_cells(plan) ? -1 : 1) * std::log(other / one) / std::log(now.x / before.x);
}

const StudyPoint* find_point(std::span<const StudyPoint> points, std::size_t line, std::size_t place) {
    const auto at = std::find_if(points.begin(), points.end(), [&](const StudyPoint& point) {
        return point.line == line && point.place == place;
    });
    return at == points.end() ? nullptr : &*at;
}

void run_study(std::shared_ptr<const Catalogue> catalogue, const StudyPlan& plan, int threads,
               const std::function<void(StudyPoint)>& done, std::stop_token stop) {
    for (std::size_t place = 0; place < plan.over.values.size(); ++place)
        for (std::size_t line = 0; line < plan.line_count(); ++line) {
            if (stop.stop_requested()) return;
            StudyPoint point{.line = line, .place = place, .x = number_at(plan.over, place)};
            if (!solve_point(catalogue, plan, threads, point, stop)) return;
            done(std::move(point));
        }
}

} // namespace gaspard
