// McRae, Cotter, Budd (2018), section 5: the figures of the plane by relaxation.
#include "core/base/check.hpp"
#include "core/published/published.hpp"
#include "core/scenario/toml.hpp"
#include "core/session/run.hpp"

#include <cmath>

namespace gaspard {

namespace {

struct Plane {
    std::string monitor; ///< "ring" or "bell"
    std::int64_t cells = 60;
    std::int64_t diagnostics_every = 1;
    std::string title() const { return monitor + ", n = " + std::to_string(cells); }
};

Run solve(const std::shared_ptr<const Catalogue>& catalogue, const Plane& plane, const Announce& announce,
          std::stop_token stop) {
    announce("relaxation, " + plane.title());
    Scenario scenario = find_scenario(*catalogue, "plane-" + plane.monitor);
    scenario.domain.values.set("cells", plane.cells);
    scenario.method.values.set("diagnostics_every", plane.diagnostics_every);
    Run run(catalogue, scenario);
    while (run.status() == RunStatus::running) {
        if (stop.stop_requested()) throw Interrupted();
        run.step(stop);
    }
    GASPARD_CHECK(run.status() == RunStatus::converged);
    return run;
}

Reproduction figure2(const std::shared_ptr<const Catalogue>& catalogue, const Announce& announce,
                     std::stop_token stop) {
    Reproduction result{{}, Figure{"Meshes adapted to the ring and the bell, 30 x 30", {}}};
    for (const std::string monitor : {"ring", "bell"}) {
        const Plane plane{.monitor = monitor, .cells = 30};
        Run run = solve(catalogue, plane, announce, stop);
        const StepReport& last = run.history().back();
        result.rows.push_back({plane.title(), "iterations", static_cast<double>(last.iteration)});
        result.rows.push_back({plane.title(), "residual", last.residual});
        result.rows.push_back({plane.title(), "equidistribution", *last.equidistribution});
        result.rows.push_back({plane.title(), "smallest Jacobian", *last.min_jacobian});
        result.rows.push_back({plane.title(), "largest Jacobian", *last.max_jacobian});
        result.rows.push_back({plane.title(), "tangled cells", static_cast<double>(*last.tangled_cells),
                               std::nullopt, "the paper calls the meshes notably well-behaved"});
        result.figure->panels.push_back({monitor == "ring" ? "Ring (5.3)" : "Bell (5.4)", run.snapshot()});
    }
    return result;
}

Reproduction figure3(const std::shared_ptr<const Catalogue>& catalogue, const Announce& announce,
                     std::stop_token stop) {
    Plot residual{"Residual (5.1)", {"iteration", false}, {"normalised residual", true}, {}};
    Plot spread{"Equidistribution (5.2)", {"iteration", false}, {"coefficient of variation of M", true}, {}};
    Reproduction result;
    double iterations[2] = {};
    int which = 0;
    for (const std::string monitor : {"ring", "bell"}) {
        const Plane plane{.monitor = monitor};
        const Run run = solve(catalogue, plane, announce, stop);
        Curve r{monitor + ", relaxation", {}, {}}, e{monitor + ", relaxation", {}, {}};
        for (const auto& report : run.history()) {
            r.x.push_back(report.iteration), r.y.push_back(report.residual);
            e.x.push_back(report.iteration), e.y.push_back(*report.equidistribution);
        }
        residual.curves.push_back(std::move(r));
        spread.curves.push_back(std::move(e));
        iterations[which++] = run.history().back().iteration;
        result.rows.push_back({plane.title(), "iterations to 1e-8", iterations[which - 1]});
        result.rows.push_back({plane.title(), "equidistribution", *run.history().back().equidistribution});
    }
    result.rows.push_back({"bell / ring", "ratio of iterations", iterations[1] / iterations[0], 4.5,
                           "section 5.1.1: far more iterations (4.5x)"});
    result.figure = Figure{"Convergence of the relaxation method, n = 60",
                           {{"Residual", std::move(residual)}, {"Equidistribution", std::move(spread)}}};
    return result;
}

Reproduction figure13(const std::shared_ptr<const Catalogue>& catalogue, const Announce& announce,
                      std::stop_token stop) {
    Plot plot{"Ring on the plane", {"1 / n", true}, {"equidistribution", true}, {}};
    Curve ours{"ring, relaxation", {}, {}, true}, slope{"order 2", {}, {}};
    Reproduction result;
    for (const std::int64_t n : {30, 60, 120, 240}) {
        const Plane plane{
            .monitor = "ring", .cells = n, .diagnostics_every = 1000}; // only the last one is shown
        const Run run = solve(catalogue, plane, announce, stop);
        const double measure = *run.history().back().equidistribution;
        result.rows.push_back({plane.title(), "equidistribution", measure});
        if (!ours.y.empty()) {
            const bool finest = n == 240;
            result.rows.push_back({"n = " + std::to_string(n / 2) + " to " + std::to_string(n), "order",
                                   std::log2(ours.y.back() / measure),
                                   finest ? std::optional<double>(2) : std::nullopt,
                                   finest ? "the paper: proportional to the square of the cell width" : ""});
        }
        ours.x.push_back(1 / static_cast<double>(n));
        ours.y.push_back(measure);
    }
    // The slope stands below the two finest meshes, where the order is nearly reached.
    for (const double x : {ours.x[ours.x.size() - 2], ours.x.back()}) {
        slope.x.push_back(x);
        slope.y.push_back(0.6 * ours.y.back() * std::pow(x / ours.x.back(), 2));
    }
    plot.curves = {std::move(ours), std::move(slope)};
    result.figure = Figure{"Equidistribution under refinement", {{"Plane", std::move(plot)}}};
    return result;
}

} // namespace

std::vector<Recipe> mcrae_recipes() {
    return {{"mcrae-fig2", "meshes adapted to the ring and the bell, 30 x 30", figure2},
            {"mcrae-fig3", "convergence of the relaxation method for ring and bell, n = 60", figure3},
            {"mcrae-fig13", "equidistribution under refinement, ring on the plane, n = 30 to 240", figure13}};
}

} // namespace gaspard
