// Runs that are made up: nothing is solved.
#pragma once

#include "gui/document/document.hpp"

#include <cmath>
#include <string>

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

/// Adds such a run to a document.
inline DocumentRun& add_made_up_run(Document& document, const std::string& name, int iterations) {
    document.show({.scenario = {}, .history = made_up_run(name, iterations).history, .snapshot = nullptr});
    DocumentRun& run = document.runs()[document.runs().size() - 1];
    run.name = run.title = name;
    return run;
}

} // namespace gaspard
