// McRae, Cotter, Budd (2018), figures 10 and 11: the quasi-Newton method on the sphere, beside Newton's
// method with the full linearisation, which the paper leaves as future work.
#include "core/published/mcrae_runs.hpp"

namespace gaspard {

namespace {

/// Runs one method until it ends, converged or not; adds its rows and returns its residual curve.
Curve attempt(const Workshop& workshop, const std::string& scenario, const std::string& method,
              std::vector<std::string> settings, const std::string& label, std::vector<PublishedRow>& rows) {
    // The scenario itself is set to the relaxation with the paper's step.
    if (method != "relaxation") settings.push_back("method.type=" + method);
    settings.push_back("method.diagnostics_every=1000");
    Run run = begin_run(workshop, scenario, settings, label);
    finish(run, workshop);
    const StepReport& last = run.history().back();
    const std::string status(status_name(last.status));
    rows.push_back({label, "iterations", static_cast<double>(last.iteration), std::nullopt, status});
    rows.push_back({label, "residual", last.residual, std::nullopt, status});
    return history_curve(run, label, "residual");
}

Plot residual_plot(const std::string& title) {
    Plot plot{title, {"iteration", false}, {"normalised residual", true}, {}};
    plot.y.low = 1e-10, plot.y.high = 100;
    return plot;
}

Reproduction figure10(const Workshop& workshop) {
    Reproduction result;
    Plot plot = residual_plot("X2, biquadratic");
    for (const std::string method : {"relaxation", "quasi-newton", "accelerated", "newton", "auto"})
        plot.curves.push_back(attempt(workshop, "sphere-x2", method, {}, "X2, " + method, result.rows));
    result.rows.push_back({"quasi-newton / relaxation", "ratio of iterations",
                           result.rows[2].ours / result.rows[0].ours, 0.5,
                           "the paper: about half as many iterations"});
    result.figure = Figure{"Quasi-Newton and relaxation on the cubed sphere, X2", {{plot.title, plot}}};
    return result;
}

Reproduction figure11(const Workshop& workshop) {
    Reproduction result{{}, Figure{"Quasi-Newton on the cubed sphere for growing contrast", {}}};
    for (const std::string order : {"1", "2"}) {
        Plot plot = residual_plot(order == "1" ? "Bilinear" : "Biquadratic");
        for (const std::string ratio : {"2", "4", "8", "16"}) {
            // Iterations of a failing run take more than a second each, so their number is limited.
            const std::vector<std::string> settings = {"domain.geometry_order=" + order,
                                                       std::string("method.max_iterations=") +
                                                           (order == "1" ? "30" : "130")};
            const std::string label = "X" + ratio + (order == "1" ? ", bilinear" : ", biquadratic");
            plot.curves.push_back(attempt(workshop, "sphere-x" + ratio, "quasi-newton", settings,
                                          label + ", quasi-newton", result.rows));
            if (order == "2")
                plot.curves.push_back(attempt(workshop, "sphere-x" + ratio, "newton", settings,
                                              label + ", newton", result.rows));
        }
        result.figure->panels.push_back({plot.title, std::move(plot)});
    }
    return result;
}

} // namespace

std::vector<Recipe> mcrae_newton_recipes() {
    return {make_recipe("mcrae-fig10", "quasi-Newton and relaxation on the cubed sphere, X2", figure10),
            make_recipe("mcrae-fig11", "quasi-Newton on the cubed sphere, X2 to X16", figure11)};
}

} // namespace gaspard
