// McRae, Cotter, Budd (2018), section 5.1.3: a mesh adapted to a quasi-geostrophic flow.
#include "core/published/mcrae_flow.hpp"

#include "core/mesh/mesh.hpp"
#include "core/published/mcrae_runs.hpp"

#include <algorithm>
#include <utility>

namespace gaspard {

namespace {

/// Values at n x n periodic nodes as a field on a mesh of n x n squares.
std::shared_ptr<const Snapshot> as_snapshot(std::size_t n, const std::vector<double>& nodal) {
    const auto mesh = std::make_shared<const Mesh>(unit_square_mesh(static_cast<int>(n)));
    Field q{{.name = "q", .label = "potential vorticity", .symbol = "q", .centre = 0.0}};
    for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i) q.values.push_back(nodal[j % n * n + i % n]);
    Snapshot snapshot;
    snapshot.mesh = mesh, snapshot.x = mesh->nodes;
    snapshot.fields.push_back(std::move(q));
    return std::make_shared<const Snapshot>(std::move(snapshot));
}

QuasiGeostrophicFlow flow_at_its_end(const Workshop& workshop, const VortexFlow& which) {
    workshop.announce("quasi-geostrophic flow to time 500");
    QuasiGeostrophicFlow flow = vortex_flow(which);
    for (int step = 0; step < which.steps; ++step) {
        if (workshop.stop.stop_requested()) throw Interrupted();
        flow.step(which.step);
    }
    return flow;
}

void add_flow(const FlowDiagnostics& start, const FlowDiagnostics& end, std::vector<PublishedRow>& rows) {
    const std::string row = "flow, T = 500", reason = "the noise at the start is another one";
    rows.push_back({row, "least q", end.low, printed(-0.4, 1), "", reason});
    rows.push_back({row, "largest q", end.high, printed(0.38, 2), "", reason});
    rows.push_back({row, "change of the mean", end.mean - start.mean});
    rows.push_back({row, "enstrophy / at T = 0", end.enstrophy / start.enstrophy});
    rows.push_back({row, "energy / at T = 0", end.energy / start.energy});
}

/// The mesh for max(q^2, 0.005).
std::shared_ptr<const Snapshot> add_mesh(const Workshop& workshop, const std::string& method,
                                         std::vector<PublishedRow>& rows) {
    const std::string row = "mesh, " + method;
    Run run = solve(workshop, "flow-vortices", {"method.type=" + method}, "vortices, n = 60");
    const StepReport& last = run.history().back();
    rows.push_back({row, "iterations", static_cast<double>(last.iteration)});
    rows.push_back({row, "residual", last.residual});
    rows.push_back({row, "equidistribution", *last.value("equidistribution")});
    rows.push_back({row, "smallest Jacobian", *last.value("min_jacobian")});
    rows.push_back({row, "largest Jacobian", *last.value("max_jacobian")});
    rows.push_back({row, "tangled cells", static_cast<double>(*last.tangled_cells)});
    return run.snapshot();
}

Reproduction mcrae_figure4(const Workshop& workshop) {
    Reproduction result{{}, Figure{"A mesh adapted to a quasi-geostrophic flow", {}}};
    const VortexFlow which;
    QuasiGeostrophicFlow flow = flow_at_its_end(workshop, which);
    add_flow(vortex_flow(which).diagnostics(), flow.diagnostics(), result.rows);
    std::vector<double> nodal(which.cells * which.cells);
    flow.project(nodal);
    result.figure->panels.push_back(
        {.title = "q at T = 500", .content = as_snapshot(which.cells, nodal), .colour = "q", .lines = false});
    result.figure->panels.push_back({"Adapted mesh", add_mesh(workshop, "quasi-newton", result.rows)});
    add_mesh(workshop, "auto", result.rows);
    return result;
}

} // namespace

QuasiGeostrophicFlow vortex_flow(const VortexFlow& which) {
    QuasiGeostrophicFlow flow({.cells = which.cells});
    flow.set_state(continuous_state(which.cells, noise_values(which.cells, which.seed)));
    return flow;
}

std::vector<Recipe> mcrae_flow_recipes() {
    return {
        make_recipe("mcrae-fig4", "a mesh adapted to vortices of a quasi-geostrophic flow", mcrae_figure4)};
}

} // namespace gaspard
