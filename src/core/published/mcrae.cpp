// McRae, Cotter, Budd (2018), section 5: the figures of the plane, solved by relaxation.
#include "core/published/mcrae_runs.hpp"

namespace gaspard {

namespace {

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

Reproduction figure3(const Workshop& workshop) {
    Plot residual{"Residual (5.1)", {"iteration", false}, {"normalised residual", true}, {}};
    Plot spread{"Equidistribution (5.2)", {"iteration", false}, {"coefficient of variation of M", true}, {}};
    Plot compared{"Relaxation and Newton's methods", {"iteration", false}, {"normalised residual", true}, {}};
    Reproduction result;
    double iterations[2] = {};
    int which = 0;
    for (const std::string monitor : {"ring", "bell"}) {
        const std::string title = title_of(monitor, 60);
        const Run run = solve_plane(workshop, monitor, 60);
        const std::string label = monitor + ", relaxation";
        residual.curves.push_back(history_curve(run, label, "residual"));
        compared.curves.push_back(residual.curves.back());
        for (const std::string method : {"quasi-newton", "newton", "auto"}) {
            const Run other =
                solve(workshop, "plane-" + monitor,
                      {"method.type=" + method, "method.diagnostics_every=1000"}, title + ", " + method);
            compared.curves.push_back(history_curve(other, monitor + ", " + method, "residual"));
            result.rows.push_back({title + ", " + method, "iterations to 1e-8",
                                   static_cast<double>(other.history().back().iteration)});
        }
        spread.curves.push_back(history_curve(run, label, "equidistribution"));
        iterations[which++] = run.history().back().iteration;
        result.rows.push_back({title, "iterations to 1e-8", iterations[which - 1]});
        result.rows.push_back({title, "equidistribution", *run.history().back().value("equidistribution")});
    }
    result.rows.push_back({"bell / ring", "ratio of iterations", iterations[1] / iterations[0], 4.5,
                           "section 5.1.1: far more iterations (4.5x)"});
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
    for (auto& one : mcrae_sphere_recipes()) all.push_back(std::move(one));
    for (auto& one : mcrae_newton_recipes()) all.push_back(std::move(one));
    for (auto& one : mcrae_refinement_recipes()) all.push_back(std::move(one));
    return all;
}

} // namespace gaspard
