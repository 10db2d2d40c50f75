// McRae, Cotter, Budd (2018), section 5.2: the figures of the sphere, solved by relaxation.
#include "core/base/error.hpp"
#include "core/published/mcrae_runs.hpp"

namespace gaspard {

namespace {

const std::string every_iteration = "method.diagnostics_every=1",
                  only_the_last = "method.diagnostics_every=1000";

void add_numbers(const Run& run, const std::string& title, std::vector<PublishedRow>& rows) {
    const StepReport& last = run.history().back();
    rows.push_back({title, "iterations", static_cast<double>(last.iteration)});
    rows.push_back({title, "residual", last.residual});
    rows.push_back({title, "equidistribution", *last.value("equidistribution")});
    if (last.value("exact_rms"))
        rows.push_back({title, "rms to the exact mesh, vertices", *last.value("exact_rms")});
    if (last.value("exact_rms_nodes"))
        rows.push_back({title, "rms to the exact mesh, all nodes", *last.value("exact_rms_nodes")});
    rows.push_back({title, "smallest Jacobian", *last.value("min_jacobian")});
    rows.push_back({title, "largest Jacobian", *last.value("max_jacobian")});
    rows.push_back({title, "tangled cells", static_cast<double>(*last.tangled_cells)});
}

/// A mesh from a direction: the title of the panel after that of the mesh, and view.camera.
struct Look {
    std::string title, camera;
};
// The fine region of (5.10) is around 30 degrees north, 0 degrees east: (sqrt(3), 0, 1) / 2.
const std::vector<Look> front_and_rear = {{", front", "right 0 1 0 up -0.5 0 0.8660254037844386"},
                                          {", rear", "right 0 -1 0 up -0.5 0 0.8660254037844386"}};
// The bands of (5.11) cross at (0, 1, 0) and (0, -1, 0).
const std::vector<Look> crossing = {{"", "right -1 0 0 up 0 0 1"}};

/// A figure of one mesh.
Reproduction one_mesh(const Workshop& workshop, const std::string& scenario, const std::string& title,
                      const std::string& caption, const std::vector<Look>& looks) {
    Run run = solve(workshop, scenario, {only_the_last}, title);
    const auto snapshot = run.snapshot();
    Reproduction result{{}, Figure{caption, {}}};
    for (const Look& look : looks)
        result.figure->panels.push_back({title + look.title, snapshot, look.camera});
    add_numbers(run, title, result.rows);
    return result;
}

Reproduction figure8(const Workshop& workshop) {
    Reproduction result{{}, Figure{"Convergence of the relaxation method on the cubed sphere", {}}};
    for (const std::string ratio : {"2", "16"}) {
        Plot plot{"X" + ratio,
                  {.label = "iteration", .whole = true},
                  {"residual, equidistribution, rms to exact", true},
                  {}};
        plot.y.low = 1e-9, plot.y.high = 10;
        for (const std::string order : {"1", "2"}) {
            const std::string cells = order == "1" ? "bilinear" : "biquadratic",
                              title = "X" + ratio + ", " + cells;
            Run run = begin_run(workshop, "sphere-x" + ratio,
                                {"domain.geometry_order=" + order, every_iteration}, title);
            finish(run, workshop);
            add_numbers(run, title, result.rows);
            plot.curves.push_back(history_curve(run, cells + ", residual", "residual"));
            plot.curves.push_back(history_curve(run, cells + ", equidistribution", "equidistribution"));
            plot.curves.push_back(history_curve(run, cells + ", rms to exact", "exact_rms"));
            if (run.status() != RunStatus::converged)
                result.rows.push_back({title, "iterations until divergence",
                                       static_cast<double>(run.history().back().iteration), printed(10, 1),
                                       "the paper: wildly diverges after just some 10 iterations"});
        }
        result.figure->panels.push_back({plot.title, std::move(plot)});
    }
    return result;
}

Reproduction figure9(const Workshop& workshop) {
    const std::string title = "X16, bilinear, tangled";
    Run run = begin_run(workshop, "sphere-x16", {"domain.geometry_order=1", every_iteration}, title);
    while (run.status() == RunStatus::running && *run.history().back().tangled_cells == 0) {
        if (workshop.stop.stop_requested()) throw Interrupted();
        run.step(workshop.stop);
    }
    Reproduction result{{}, Figure{"Failure of bilinear cells, X16, before divergence", {}}};
    result.figure->panels.push_back({title, run.snapshot()});
    const StepReport& last = run.history().back();
    result.rows = {{title, "iteration", static_cast<double>(last.iteration)},
                   {title, "residual", last.residual},
                   {title, "smallest Jacobian", *last.value("min_jacobian")},
                   {title, "tangled cells", static_cast<double>(*last.tangled_cells), std::nullopt,
                    "the paper: in a tangled state, shortly before complete blow-up"}};
    return result;
}

} // namespace

std::vector<Recipe> mcrae_sphere_recipes() {
    const auto mesh = [](const std::string& scenario, const std::string& title, const std::string& caption,
                         const std::vector<Look>& looks) {
        return [=](const Workshop& workshop) { return one_mesh(workshop, scenario, title, caption, looks); };
    };
    return {
        make_recipe("mcrae-fig5", "cubed-sphere X2 mesh, 6 x 16 x 16",
                    mesh("sphere-x2", "X2", "Cubed-sphere X2 mesh (5.10), γ = (1/2)⁴", front_and_rear)),
        make_recipe("mcrae-fig6", "cubed-sphere X16 mesh, 6 x 16 x 16",
                    mesh("sphere-x16", "X16", "Cubed-sphere X16 mesh (5.10), γ = (1/16)⁴", front_and_rear)),
        make_recipe(
            "mcrae-fig7", "icosahedral mesh adapted to crossing bands, 5120 triangles",
            mesh("sphere-cross", "Cross", "Icosahedral mesh adapted to crossing bands (5.11)", crossing)),
        make_recipe("mcrae-fig8", "convergence of the relaxation method on the cubed sphere, X2 and X16",
                    figure8),
        make_recipe("mcrae-fig9", "failure of bilinear cells, X16, with tangled cells", figure9)};
}

} // namespace gaspard
