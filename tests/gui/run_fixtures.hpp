// Runs that are made up: nothing is solved.
#pragma once

#include "core/session/series_table.hpp"
#include "core/session/time_series.hpp"
#include "gui/document/document.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace gaspard {

/// A kept run whose residual falls by a factor of ten in ten iterations; measured every second iteration.
inline DocumentRun made_up_run(const std::string& name, int iterations) {
    DocumentRun run;
    run.name = run.title = name;
    for (int i = 0; i <= iterations; ++i) {
        StepReport report{.iteration = i,
                          .residual = std::pow(10, -0.1 * i) / 3,
                          .step_size = i > 0 ? 0.1 : 0.0,
                          .seconds = 0.01 * i};
        if (i % 2 == 0) {
            report.set("equidistribution", 1.0 / (1 + i));
            report.set("min_jacobian", 1 - 0.001 * i);
            report.set("max_jacobian", 1 + 0.1 * i);
            report.tangled_cells = 0;
        }
        run.history.push_back(report);
        run.curves.append(report);
    }
    return run;
}

/// The history of a run that moves in time, each of whose steps the method solves exactly: a start, then
/// time steps of 0.05.
inline std::vector<StepReport> made_up_time_steps(int steps) {
    static const auto table = std::make_shared<const SeriesTable>(
        SeriesInfo{.name = "residual", .label = "Residual", .scale = ParameterScale::logarithmic},
        time_series(), std::vector<SeriesInfo>{}, "residual");
    std::vector<StepReport> history;
    for (int i = 0; i <= steps; ++i) {
        StepReport report{.iteration = i, .residual = i > 0 ? 0.0 : 0.1, .series = table};
        report.values.assign(table->slots(), std::numeric_limits<double>::quiet_NaN());
        report.set(time_names::time, 0.05 * i);
        if (i > 0) report.set(time_names::iterations, 1), report.set(time_names::speed, 1.0 / i);
        history.push_back(report);
    }
    return history;
}

/// Adds such a run to a document.
inline DocumentRun& add_made_up_run(Document& document, const std::string& name, int iterations) {
    document.show({.scenario = {}, .history = made_up_run(name, iterations).history, .snapshot = nullptr});
    DocumentRun& run = document.runs()[document.runs().size() - 1];
    run.name = run.title = name;
    return run;
}

} // namespace gaspard
