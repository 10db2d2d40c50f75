// McRae, Cotter, Budd (2018), section 5: the figures of the plane, solved by relaxation.
#include "core/base/check.hpp"
#include "core/published/mcrae_runs.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

constexpr double tolerance = 1e-8;

std::string title_of(const std::string& monitor, int n) { return monitor + ", n = " + std::to_string(n); }

Run solve_plane(const Workshop& workshop, const std::string& monitor, int n) {
    return solve(workshop, "plane-" + monitor,
                 {"domain.cells=" + std::to_string(n), "method.diagnostics_every=1"}, title_of(monitor, n));
}

Reproduction figure2(const Workshop& workshop) {
    Reproduction result{{}, Figure{"Meshes adapted to the ring and the bell, 30 x 30", {}}};
    for (const std::string monitor : {"ring", "bell"}) {
        const std::string title = title_of(monitor, 30);
        Run run = solve_plane(workshop, monitor, 30);
        const StepReport& last = run.history().back();
        result.rows.push_back({title, "iterations", static_cast<double>(last.iteration)});
        result.rows.push_back({title, "residual", last.residual});
        result.rows.push_back({title, "equidistribution", *last.value("equidistribution")});
        result.rows.push_back({title, "smallest Jacobian", *last.value("min_jacobian")});
        result.rows.push_back({title, "largest Jacobian", *last.value("max_jacobian")});
        result.rows.push_back({title, "tangled cells", static_cast<double>(*last.tangled_cells), std::nullopt,
                               "the paper: the meshes are notably well-behaved"});
        result.figure->panels.push_back({monitor == "ring" ? "Ring (5.3)" : "Bell (5.4)", run.snapshot()});
    }
    return result;
}

int iterations_to(const Run& run, double residual) {
    for (const StepReport& report : run.history())
        if (report.residual < residual) return report.iteration;
    check_failed("the run reaches this residual");
}

/// A run of figure 3 and its iterations by two stopping rules: the normalised residual is below 1e-8, and, as
/// section 5.1.2 states it, the residual is below 1e-8 of its first value.
struct Solved {
    Run run;
    double iterations, iterations_of_paper;
};

Solved solve_by_both_rules(const Workshop& workshop, const std::string& monitor, const std::string& method,
                           const std::string& title, std::vector<PublishedRow>& rows) {
    const bool relaxation = method == "relaxation";
    std::vector<std::string> settings = {std::string("method.diagnostics_every=") +
                                         (relaxation ? "1" : "1000")};
    if (!relaxation) settings.push_back("method.type=" + method);
    const Announce silent = [](const std::string&) {};
    const double first =
        begin_run({workshop.catalogue, silent, workshop.stop}, "plane-" + monitor, settings, title)
            .history()
            .front()
            .residual;
    settings.push_back("method.tolerance=" + format_number(tolerance * std::min(first, 1.0)));
    Run run = solve(workshop, "plane-" + monitor, settings, title);
    const double iterations = iterations_to(run, tolerance), of_paper = iterations_to(run, tolerance * first);
    rows.push_back({title, "iterations to 1e-8", iterations});
    rows.push_back({title, "to 1e-8 of the first", of_paper, std::nullopt, "the stopping rule of the paper"});
    return {std::move(run), iterations, of_paper};
}

Reproduction figure3(const Workshop& workshop) {
    Plot residual{"Residual (5.1)", {.label = "iteration", .whole = true}, {"normalised residual", true}, {}};
    Plot spread{"Equidistribution (5.2)",
                {.label = "iteration", .whole = true},
                {"coefficient of variation of M", true},
                {}};
    Plot compared{"Relaxation and Newton's methods",
                  {.label = "iteration", .whole = true},
                  {"normalised residual", true},
                  {}};
    Reproduction result;
    std::vector<Solved> relaxed;
    for (const std::string monitor : {"ring", "bell"}) {
        const std::string title = title_of(monitor, 60), label = monitor + ", relaxation";
        relaxed.push_back(solve_by_both_rules(workshop, monitor, "relaxation", title, result.rows));
        const Run& run = relaxed.back().run;
        residual.curves.push_back(history_curve(run, label, "residual"));
        compared.curves.push_back(residual.curves.back());
        spread.curves.push_back(history_curve(run, label, "equidistribution"));
        result.rows.push_back({title, "equidistribution", *run.history().back().value("equidistribution")});
        for (const std::string method : {"quasi-newton", "newton", "auto"}) {
            const Solved other =
                solve_by_both_rules(workshop, monitor, method, title + ", " + method, result.rows);
            compared.curves.push_back(history_curve(other.run, monitor + ", " + method, "residual"));
        }
    }
    result.rows.push_back({"bell / ring", "ratio of iterations",
                           relaxed[1].iterations / relaxed[0].iterations, printed(4.5, 2),
                           "section 5.1.1: far more iterations (4.5x)"});
    result.rows.push_back({"bell / ring", "to 1e-8 of the first",
                           relaxed[1].iterations_of_paper / relaxed[0].iterations_of_paper});
    result.figure = Figure{"Convergence of the methods, n = 60",
                           {{"Residual", std::move(residual)},
                            {"Equidistribution", std::move(spread)},
                            {"Comparison", std::move(compared)}}};
    return result;
}

} // namespace

std::vector<Recipe> mcrae_recipes() {
    std::vector<Recipe> all = {
        make_recipe("mcrae-fig2", "meshes adapted to the ring and the bell, 30 x 30", figure2),
        make_recipe("mcrae-fig3", "convergence of relaxation and quasi-Newton for ring and bell, n = 60",
                    figure3)};
    for (auto& one : mcrae_flow_recipes()) all.push_back(std::move(one));
    for (auto& one : mcrae_sphere_recipes()) all.push_back(std::move(one));
    for (auto& one : mcrae_newton_recipes()) all.push_back(std::move(one));
    for (auto& one : mcrae_refinement_recipes()) all.push_back(std::move(one));
    return all;
}

} // namespace gaspard
