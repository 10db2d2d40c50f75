#include "gui/document/narrow_feature.hpp"

#include "core/diagnostics/feature_width.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

namespace {

constexpr double most = 0.9; // of the range within one cell

/// Whether the monitor is a function that a formula gives.
bool is_analytic(const Catalogue& catalogue, const Scenario& scenario) {
    return std::any_of(catalogue.monitors.begin(), catalogue.monitors.end(), [&](const MonitorType& type) {
        return type.name == scenario.monitor.type && (type.formula || type.name == "formula");
    });
}

/// The label of the first row whose key ends like this; empty if there is none.
std::string label_of(const Values& values, std::string_view ending) {
    for (const ParameterRow& row : values.rows())
        if (row.key.ends_with(ending)) return row.label;
    return {};
}

/// The warning: what is too narrow, and what helps.
std::string narrow_text(const Scenario& scenario, double share) {
    const std::string cells = label_of(scenario.domain.values, "cells"),
                      sharpness = label_of(scenario.monitor.values, "sharpness");
    std::string help = cells.empty() ? "Finer cells help" : "A larger value of \"" + cells + "\" helps";
    if (!sharpness.empty()) help += ", or a smaller \"" + sharpness + "\"";
    return "Narrower than the cells: within single cells, m changes by " +
           std::to_string(std::lround(100 * share)) +
           " % of its range, and the mesh may depend on where it started. " + help + ".";
}

} // namespace

std::string NarrowFeature::warning(const Catalogue& catalogue, const DocumentRun& run) {
    if (!run.snapshot || !is_analytic(catalogue, run.scenario)) return {};
    const Scenario& scenario = run.scenario;
    const bool adapted = !run.history.empty() && run.snapshot->report.residual <= 0.3;
    if (!adapted) {
        const bool known = verdict_ && verdict_->domain == scenario.domain &&
                           verdict_->monitor == scenario.monitor && verdict_->source == scenario.source;
        return known && verdict_->share >= most ? narrow_text(scenario, verdict_->share) : std::string();
    }
    if (mesh_ != run.snapshot->mesh || version_ != run.snapshot->version) {
        mesh_ = run.snapshot->mesh, version_ = run.snapshot->version;
        const Field* monitor = run.snapshot->field("monitor");
        share_ = monitor ? share_within_cell(*mesh_, monitor->values) : 0;
    }
    if (run.changes.settled()) verdict_ = {scenario.domain, scenario.monitor, scenario.source, share_};
    return share_ < most ? std::string() : narrow_text(scenario, share_);
}

} // namespace gaspard
