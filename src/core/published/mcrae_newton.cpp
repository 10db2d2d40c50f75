// McRae, Cotter, Budd (2018), figures 10 and 11: the quasi-Newton method on the sphere, beside Newton's
// method with the full linearisation, which the paper leaves as future work.
#include "core/published/mcrae_runs.hpp"

namespace gaspard {

namespace {

constexpr double scenario_tolerance = 1e-8;
constexpr std::size_t failure_colour = 7; // of no other curve

/// Runs one method until it ends, converged or not; adds its rows, which say how it ended, and returns its
/// residual curve. `paper`: what the paper says of it.
Curve attempt(const Workshop& workshop, const std::string& scenario, const std::string& method,
              std::vector<std::string> settings, const std::string& label, std::vector<PublishedRow>& rows,
              const std::string& paper = {}) {
    // The scenario itself is set to the relaxation with the paper's step.
    if (method != "relaxation") settings.push_back("method.type=" + method);
    settings.push_back("method.diagnostics_every=1000");
    Run run = begin_run(workshop, scenario, settings, label);
    finish(run, workshop);
    const StepReport& last = run.history().back();
    std::string end(status_name(last.status));
    if (last.status != RunStatus::converged && !last.note.empty()) end += ": " + last.note;
    if (!paper.empty()) end += "; the paper: " + paper;
    rows.push_back({label, "iterations", static_cast<double>(last.iteration), std::nullopt, end});
    rows.push_back({label, "residual", last.residual});
    rows.push_back({label, "tangled cells", static_cast<double>(*last.tangled_cells)});
    rows.push_back({label, "CPU seconds", last.cpu_seconds});
    return history_curve(run, label, "residual");
}

Plot residual_plot(const std::string& title) {
    Plot plot{title, {.label = "iteration", .whole = true}, {"normalised residual", true}, {}};
    plot.y.low = 1e-10, plot.y.high = 100;
    return plot;
}

Reproduction figure10(const Workshop& workshop) {
    Reproduction result;
    Plot plot = residual_plot("X2, biquadratic");
    std::vector<double> iterations;
    for (const std::string method : {"relaxation", "quasi-newton", "accelerated", "newton", "auto"}) {
        plot.curves.push_back(attempt(workshop, "sphere-x2", method, {}, "X2, " + method, result.rows));
        iterations.push_back(plot.curves.back().x.back());
    }
    result.rows.push_back({"quasi-newton / relaxation", "ratio of iterations", iterations[1] / iterations[0],
                           printed(0.5, 1), "the paper: about half as many iterations"});
    result.figure = Figure{"Quasi-Newton and relaxation on the cubed sphere, X2", {{plot.title, plot}}};
    return result;
}

/// What the paper says of its quasi-Newton method.
std::string paper_of(const std::string& order, const std::string& ratio) {
    const bool converges = order == "1" ? ratio == "2" : ratio != "16";
    return converges ? "converges" : "fails";
}

/// Marks the ends of the curves that have not converged, as the paper does.
void mark_failures(Plot& plot, const std::vector<Curve>& failed) {
    for (const Curve& curve : failed)
        plot.curves.push_back({&curve == &failed.front() ? "failure of the nonlinear solver" : "",
                               {curve.x.back()},
                               {curve.y.back()},
                               true,
                               failure_colour});
}

Reproduction mcrae_figure11(const Workshop& workshop) {
    Reproduction result{{}, Figure{"Quasi-Newton on the cubed sphere for growing contrast", {}}};
    for (const std::string order : {"1", "2"}) {
        const std::string cells = order == "1" ? "bilinear" : "biquadratic";
        Plot plot = residual_plot(order == "1" ? "Bilinear" : "Biquadratic");
        std::vector<Curve> failed;
        for (const std::string ratio : {"2", "4", "8", "16"}) {
            const auto add = [&](const std::string& method, const std::string& paper) {
                std::vector<std::string> settings = {"domain.geometry_order=" + order};
                // On bilinear cells a failing run stagnates; each of its iterations takes most of a second.
                if (order == "1") settings.emplace_back("method.max_iterations=40");
                const std::string label = "X" + ratio + ", " + cells + ", " + method;
                plot.curves.push_back(
                    attempt(workshop, "sphere-x" + ratio, method, settings, label, result.rows, paper));
                if (plot.curves.back().y.back() > scenario_tolerance) failed.push_back(plot.curves.back());
            };
            add("quasi-newton", paper_of(order, ratio));
            if (order == "2") add("newton", "");
        }
        mark_failures(plot, failed);
        result.figure->panels.push_back({plot.title, std::move(plot)});
    }
    return result;
}

} // namespace

std::vector<Recipe> mcrae_newton_recipes() {
    return {make_recipe("mcrae-fig10", "quasi-Newton and relaxation on the cubed sphere, X2", figure10),
            make_recipe("mcrae-fig11", "quasi-Newton on the cubed sphere, X2 to X16", mcrae_figure11)};
}

} // namespace gaspard
