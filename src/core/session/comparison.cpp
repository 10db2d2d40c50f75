#include "core/session/comparison.hpp"

#include "core/method/method.hpp"
#include "core/scenario/time_rows.hpp"
#include "core/session/time_series.hpp"

#include <algorithm>
#include <cstdio>

namespace gaspard {

namespace {

std::string fixed(double number, int decimals) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", decimals, number);
    return text;
}

std::string two_digits(double number) {
    char text[40];
    std::snprintf(text, sizeof text, "%.1e", number);
    return text;
}

} // namespace

std::vector<std::string> methods_for(const Catalogue& catalogue, const Scenario& scenario) {
    std::vector<std::string> names;
    for (const MethodType& type : catalogue.methods)
        if (find_capability(catalogue, with_method(catalogue, scenario, type.name)))
            names.push_back(type.name);
    return names;
}

Scenario with_method(const Catalogue& catalogue, const Scenario& scenario, const std::string& method) {
    Scenario changed = scenario;
    if (method == scenario.method.type) return changed;
    set_method(catalogue, changed, method_section(catalogue, method));
    for (const ParameterRow& row : common_method_rows())
        if (scenario.method.values.has(row.key))
            changed.method.values.set(row.key, scenario.method.values.at(row.key));
    return changed;
}

ComparisonRow comparison_row(const std::string& method, const std::vector<StepReport>& history) {
    ComparisonRow row{.method = method};
    if (history.empty()) return row;
    for (const StepReport& report : history) row.inner_iterations += report.inner_iterations;
    const StepReport& last = history.back();
    const auto reports = finest_reports(history);
    const FinestReport finest = reports.empty() ? FinestReport{0, &last} : reports.back();
    row.iterations = last.all_iterations;
    row.coarse_iterations = last.iteration - finest.iteration;
    row.cpu_seconds = last.cpu_seconds;
    row.residual = finest.report->residual;
    row.criterion = last.series->all()[last.series->criterion()].name;
    row.criterion_value = last.value(last.series->criterion()).value_or(0);
    row.status = last.status;
    const auto measured = std::find_if(history.rbegin(), history.rend(),
                                       [](const StepReport& report) { return report.measured(); });
    if (measured != history.rend())
        row.equidistribution = measured->value("equidistribution"),
        row.tangled_cells = measured->tangled_cells;
    return row;
}

std::vector<FinestReport> finest_reports(const std::vector<StepReport>& history) {
    std::vector<FinestReport> finest;
    int iteration = history.empty() ? 0 : history.front().iteration, before = iteration;
    for (const StepReport& report : history) {
        if (report.value(level_series().name).value_or(0) == 0) {
            iteration += report.iteration - before;
            finest.push_back({iteration, &report});
        }
        before = report.iteration;
    }
    return finest;
}

std::vector<ComparisonPoint> comparison_points(const Scenario& scenario,
                                               const std::vector<StepReport>& history) {
    std::vector<ComparisonPoint> points;
    if (!has_time(scenario.time)) {
        for (const FinestReport& one : finest_reports(history))
            points.push_back({static_cast<double>(one.iteration), one.report});
        return points;
    }
    auto first = std::ranges::find_if(history, is_time_step);
    if (first == history.end()) return points;
    if (first != history.begin()) --first; // the solved start
    for (; first != history.end(); ++first) points.push_back({time_of(*first).value(), &*first});
    return points;
}

std::string comparison_axis(const Scenario& scenario) {
    return has_time(scenario.time) ? "time t" : "iteration on the finest mesh";
}

std::vector<std::string> comparison_heads() {
    return {"method",   "iterations", "on coarser meshes", "inner iterations", "CPU seconds",
            "residual", "criterion",  "equidistribution",  "tangled cells",    "status"};
}

std::vector<std::string> comparison_cells(const ComparisonRow& row) {
    if (row.status == RunStatus::preparing)
        return {row.method, "", "", "", "", "", "", "", "", std::string(status_name(row.status))};
    return {row.method,
            std::to_string(row.iterations),
            std::to_string(row.coarse_iterations),
            std::to_string(row.inner_iterations),
            fixed(row.cpu_seconds, 3),
            two_digits(row.residual),
            row.criterion + " " + two_digits(row.criterion_value),
            row.equidistribution ? fixed(*row.equidistribution, 6) : "",
            row.tangled_cells ? std::to_string(*row.tangled_cells) : "",
            std::string(status_name(row.status))};
}

std::string comparison_csv(const std::vector<ComparisonRow>& rows) {
    std::string text =
        "method,iterations,inner_iterations,cpu_seconds,residual,equidistribution,tangled_cells,"
        "coarse_iterations,criterion,criterion_value,status\n";
    for (const ComparisonRow& row : rows)
        text += row.method + ',' + std::to_string(row.iterations) + ',' +
                std::to_string(row.inner_iterations) + ',' + format_number(row.cpu_seconds) + ',' +
                format_number(row.residual) + ',' +
                (row.equidistribution ? format_number(*row.equidistribution) : "") + ',' +
                (row.tangled_cells ? std::to_string(*row.tangled_cells) : "") + ',' +
                std::to_string(row.coarse_iterations) + ',' + row.criterion + ',' +
                format_number(row.criterion_value) + ',' + std::string(status_name(row.status)) + '\n';
    return text;
}

} // namespace gaspard
