// Bahari, Habbal, Ratnani, Sonnendruecker (2024), figures 20 to 23: adapted meshes of solids, cut open.
#include "core/published/mcrae_runs.hpp"

namespace gaspard {

namespace {

/// A picture of a solid: the title of the panel, view.cut and view.camera.
struct Opened {
    std::string title, cut, camera;
};

struct SolidFigure {
    int figure;
    std::string scenario, title;
    std::vector<Opened> pictures;
};

std::vector<SolidFigure> solid_figures() {
    const std::string from_right = "right -0.5 0.8660254037844386 0 up -0.35 -0.2 0.9";
    return {{20,
             "spline-cube",
             "Cosine waves in the cube, cut at x = 0.1, 0.6, 0.9",
             {{"x = 0.1", "x 0.1", from_right},
              {"x = 0.6", "x 0.6", from_right},
              {"x = 0.9", "x 0.9", from_right}}},
            {21,
             "spline-ball",
             "Cosine waves in the ball",
             {{"one eighth taken out", "x 0.05 and y 0.05 and z 0.05", {}},
              {"cut beside the middle", "x 0.05", from_right}}},
            {22,
             "spline-cylinder",
             "Cosine waves in a cylinder",
             {{"the whole", {}, {}}, {"cut beside the axis", "x 0.05", from_right}}},
            {23,
             "spline-half-torus",
             "Cosine waves in half a torus",
             {{"the whole", {}, {}}, {"cut beside the middle", "z 0.05", {}}}}};
}

Reproduction reproduce(const SolidFigure& one, const Workshop& workshop) {
    Run run = solve(workshop, one.scenario, {"method.diagnostics_every=1000", "domain.cells=24"}, one.title);
    Reproduction result{{}, Figure{one.title, {}}};
    for (const Opened& picture : one.pictures)
        result.figure->panels.push_back(
            {picture.title, run.snapshot(), picture.camera, "monitor", picture.cut});
    const StepReport& last = run.history().back();
    const std::string row = "p = 3, n = 24";
    result.rows.push_back({row, "iterations", static_cast<double>(last.iteration)});
    for (const char* series : {"equidistribution", "min_jacobian_psi", "max_jacobian_psi"})
        result.rows.push_back({row, series, *last.value(series)});
    return result;
}

} // namespace

std::vector<Recipe> bahari_solid_recipes() {
    std::vector<Recipe> all;
    for (const SolidFigure& one : solid_figures())
        all.push_back(make_recipe("bahari-fig" + std::to_string(one.figure), one.title,
                                  [one](const Workshop& workshop) { return reproduce(one, workshop); }));
    return all;
}

} // namespace gaspard
