// McRae, Cotter, Budd (2018), section 5.4: relaxation under mesh refinement; ring on the plane, cross on the
// icosahedral sphere.
#include "core/published/mcrae_runs.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

const std::string last_diagnostics = "method.diagnostics_every=1000";

/// A sequence of meshes, each with half the cell width of the previous one.
struct Sequence {
    std::string name, scenario, key;
    std::vector<int> sizes;
    double paper_order;
    std::string paper_says;

    std::string title(int size) const {
        return name + (key == "domain.cells" ? ", n = " : ", refinements ") + std::to_string(size);
    }
    Run solved(const Workshop& workshop, int size) const {
        return solve(workshop, scenario, {key + "=" + std::to_string(size), last_diagnostics}, title(size));
    }
};

const Sequence plane{"ring",
                     "plane-ring",
                     "domain.cells",
                     {30, 60, 120, 240},
                     2,
                     "the paper: proportional to the square of the cell width"};
const Sequence sphere{"cross",
                      "sphere-cross",
                      "domain.refinements",
                      {3, 4, 5, 6},
                      1,
                      "the paper: proportional to the cell width"};

double width_of(const Run& run) {
    return 1 / std::sqrt(static_cast<double>(run.discretisation().mesh()->cell_count()));
}

Plot refinement(const Workshop& workshop, const Sequence& sequence, const std::string& title,
                std::vector<PublishedRow>& rows) {
    Plot plot{title, {"1 / sqrt(cells)", true}, {"equidistribution", true}, {}};
    Curve ours{sequence.name + ", relaxation", {}, {}, true};
    for (const int size : sequence.sizes) {
        const Run run = sequence.solved(workshop, size);
        const double measure = *run.history().back().value("equidistribution");
        rows.push_back({sequence.title(size), "equidistribution", measure});
        if (!ours.y.empty()) {
            const bool finest = size == sequence.sizes.back();
            rows.push_back({sequence.title(size), "order", std::log2(ours.y.back() / measure),
                            finest ? std::optional(printed(sequence.paper_order, 1)) : std::nullopt,
                            finest ? sequence.paper_says : "relative to the previous mesh"});
        }
        ours.x.push_back(width_of(run));
        ours.y.push_back(measure);
    }
    // The reference slope is drawn below the two finest meshes, where the order is nearly reached.
    Curve slope{"order " + std::to_string(static_cast<int>(sequence.paper_order)), {}, {}};
    for (const double x : {ours.x[ours.x.size() - 2], ours.x.back()}) {
        slope.x.push_back(x);
        slope.y.push_back(0.6 * ours.y.back() * std::pow(x / ours.x.back(), sequence.paper_order));
    }
    plot.curves = {std::move(ours), std::move(slope)};
    return plot;
}

Reproduction figure12(const Workshop& workshop) {
    Reproduction result{{}, Figure{"The finest meshes: 57600 squares, 81920 triangles", {}}};
    // The whole mesh, whose cells are too small to see, and a detail where it is finest: ring and crossing.
    const std::pair<const Sequence*, std::array<std::string, 2>> looks[] = {
        {&plane, {"", "centre 0.75 0.5 height 0.12"}},
        {&sphere, {"right -1 0 0 up 0 0 1", "centre 0 1 0 height 0.24 right -1 0 0 up 0 0 1"}}};
    for (const auto& [sequence, cameras] : looks) {
        const int finest = sequence->sizes.back();
        Run run = sequence->solved(workshop, finest);
        const StepReport& last = run.history().back();
        const std::string title = sequence->title(finest);
        result.rows.push_back({title, "iterations", static_cast<double>(last.iteration)});
        result.rows.push_back({title, "smallest Jacobian", *last.value("min_jacobian")});
        result.rows.push_back({title, "tangled cells", static_cast<double>(*last.tangled_cells),
                               Printed{0, 0}, "the paper: no evidence whatsoever of mesh tangling"});
        const auto snapshot = run.snapshot();
        result.figure->panels.push_back({title, snapshot, cameras[0]});
        result.figure->panels.push_back({title + ", detail", snapshot, cameras[1]});
    }
    return result;
}

Reproduction figure13(const Workshop& workshop) {
    Reproduction result{{}, Figure{"Equidistribution under refinement", {}}};
    result.figure->panels.push_back({"Plane", refinement(workshop, plane, "Ring on the plane", result.rows)});
    result.figure->panels.push_back(
        {"Sphere", refinement(workshop, sphere, "Cross on the sphere", result.rows)});
    return result;
}

Reproduction mcrae_figure14(const Workshop& workshop) {
    Plot plot{"Time to 1e-8", {"cells", true}, {"CPU seconds", true}, {}};
    Reproduction result;
    for (const Sequence* sequence : {&plane, &sphere}) {
        Curve curve{sequence->name + ", relaxation", {}, {}, true};
        double first = 0;
        for (const int size : sequence->sizes) {
            const Run run = sequence->solved(workshop, size);
            const StepReport& last = run.history().back();
            const auto cells = static_cast<double>(run.discretisation().mesh()->cell_count());
            const double per_cell = 1e6 * last.cpu_seconds / (last.iteration * cells);
            if (first == 0) first = per_cell;
            result.rows.push_back({sequence->title(size), "CPU seconds", last.cpu_seconds});
            result.rows.push_back({sequence->title(size), "microseconds per cell and iteration", per_cell});
            result.rows.push_back({sequence->title(size), "relative to the coarsest mesh", per_cell / first,
                                   std::nullopt, "the paper: O(N), that is 1"});
            curve.x.push_back(cells);
            curve.y.push_back(last.cpu_seconds);
        }
        plot.curves.push_back(std::move(curve));
    }
    result.figure = Figure{"Time over number of cells, relaxation", {{plot.title, std::move(plot)}}};
    return result;
}

} // namespace

std::vector<Recipe> mcrae_refinement_recipes() {
    return {make_recipe("mcrae-fig12",
                        "the finest meshes of ring and cross, 57600 squares and 81920 triangles", figure12),
            make_recipe("mcrae-fig13",
                        "equidistribution under refinement, ring on the plane and cross on the sphere",
                        figure13),
            make_recipe("mcrae-fig14", "time over number of cells, ring on the plane and cross on the sphere",
                        mcrae_figure14)};
}

} // namespace gaspard
