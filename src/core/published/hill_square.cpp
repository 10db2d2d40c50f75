// Hill, Madden (2021), section 3: figures 10, 11, 13 and 14.
#include "core/base/error.hpp"
#include "core/published/hill.hpp"
#include "core/published/hill_problems.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace gaspard {

namespace {

constexpr std::array<double, 5> square_eps = {1, 1e-2, 1e-4, 1e-6, 1e-8};
constexpr std::array<int, 4> square_cells = {16, 32, 64, 128};

/// The triangles of a grid with right diagonals, where they started and where they stand.
std::shared_ptr<const Snapshot> triangles(const SquareMeshPdeOptions& options, int n, Points x) {
    Mesh mesh{.kind = {CellShape::triangle, 1}, .space_dimension = 2, .nodes = Points(x.size()), .cells = {}};
    const auto& c = options.corners;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
            mesh.nodes.set(static_cast<std::size_t>(j * (n + 1) + i),
                           (1 - t) * ((1 - s) * c[0] + s * c[1]) + t * ((1 - s) * c[2] + s * c[3]));
        }
    for (std::int32_t j = 0; j < n; ++j)
        for (std::int32_t i = 0; i < n; ++i) {
            const std::int32_t p = j * (n + 1) + i, q = p + n + 1; // lower and upper left corner
            mesh.cells.insert(mesh.cells.end(), {p, p + 1, q + 1, p, q + 1, q});
        }
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->mesh = std::make_shared<const Mesh>(std::move(mesh));
    snapshot->report.tangled_cells = inverted_triangles(x, n);
    snapshot->report.status = RunStatus::converged;
    snapshot->x = std::move(x);
    return snapshot;
}

/// A mesh of the paper, and its finest corner.
struct MeshFigure {
    std::string caption, title;
    double eps;
    std::function<HillSquare(double)> problem;
    std::string detail; ///< view.camera
};

Reproduction reproduce(const MeshFigure& figure, const Workshop& workshop) {
    constexpr int cells = 32;
    const std::string title = eps_title("ε", figure.eps) + ", N = " + std::to_string(cells);
    if (workshop.stop.stop_requested()) throw Interrupted();
    workshop.announce(title);
    const HillSquare problem = figure.problem(figure.eps);
    const SquareMeshPdeResult made = mesh_pde_square(problem.densities, cells, problem.options);
    const auto snapshot = triangles(problem.options, cells, made.x);
    Reproduction result{{}, Figure{figure.caption, {}}};
    result.figure->panels = {{figure.title, snapshot, ""},
                             {figure.title + ", detail", snapshot, figure.detail}};
    result.rows = {{title, "inverted triangles", static_cast<double>(*snapshot->report.tangled_cells)},
                   {title, "last update", made.updates.back(), std::nullopt,
                    "the largest change of a coordinate in the last solve"}};
    return result;
}

struct SquareError {
    double error = 0;
    std::size_t inverted = 0;
};
SquareError solved(const HillSquare& square, int cells) {
    const Points x = mesh_pde_square(square.densities, cells, square.options).x;
    const auto p1 = solve_triangles(square.problem, x, cells, 1),
               p2 = solve_triangles(square.problem, x, cells, 2);
    return {reference_error(square.problem, x, cells, p1, p2), inverted_triangles(x, cells)};
}

/// One plot of errors over N, and its rows.
struct ErrorPlot {
    std::string title, quantity;
    std::function<HillSquare(double)> problem;
    EnergyBound (*bound)(double eps, double n);
    std::string note{};
};

Plot errors(const ErrorPlot& plot, const Workshop& workshop, std::vector<PublishedRow>& rows) {
    HillErrors series(plot.title);
    for (const double eps : square_eps) {
        series.begin(eps_title("ε", eps));
        for (const int cells : square_cells) {
            if (workshop.stop.stop_requested()) throw Interrupted();
            const std::string title = eps_title("ε", eps) + ", N = " + std::to_string(cells);
            workshop.announce(title);
            const SquareError found = solved(plot.problem(eps), cells);
            series.add(cells, found.error, plot.bound(eps, cells).value);
            rows.push_back({title, plot.quantity, found.error, std::nullopt, plot.note});
            if (plot.note.empty())
                rows.push_back({title, "inverted triangles", static_cast<double>(found.inverted)});
        }
    }
    return series.plot(plot.bound(1, 1).formula);
}

Reproduction figure11(const Workshop& workshop) {
    const ErrorPlot plot{"Error to the P2 solution", "energy error", hill_irregular, one_layer_bound};
    Reproduction result;
    Plot drawn = errors(plot, workshop, result.rows);
    result.figure = Figure{"Errors on the irregular domain", {{plot.title, std::move(drawn)}}};
    return result;
}

Reproduction figure14(const Workshop& workshop) {
    const auto with = [](Diffusion diffusion) {
        return [diffusion](double eps) { return hill_varying(eps, diffusion); };
    };
    const ErrorPlot plots[] = {
        {"Squared diffusion", "energy error", with(Diffusion::squared), plane_layers_bound},
        {"Diffusion as printed", "energy error, as printed", with(Diffusion::as_printed), plane_layers_bound,
         "(35a) lacks the exponent 2 of (25a) on the diffusion: its layers are wider than those of the "
         "mesh"}};
    Reproduction result{{}, Figure{"Errors for varying diffusion", {}}};
    for (const ErrorPlot& plot : plots)
        result.figure->panels.push_back({plot.title, errors(plot, workshop, result.rows)});
    return result;
}

} // namespace

std::vector<Recipe> hill_square_recipes() {
    const auto mesh = [](MeshFigure figure) {
        return [figure = std::move(figure)](const Workshop& workshop) { return reproduce(figure, workshop); };
    };
    return {make_recipe("hill-fig10", "mesh of the irregular domain, N = 32",
                        mesh({"Mesh adapted to the layers of the irregular domain", "Irregular domain", 1e-2,
                              hill_irregular, "centre 0.95 0.95 height 0.1"})),
            make_recipe("hill-fig11", "energy errors on the irregular domain over N", figure11),
            make_recipe("hill-fig13", "mesh for varying diffusion, N = 32",
                        mesh({"Mesh adapted to varying diffusion", "Varying diffusion", 1e-3,
                              [](double eps) { return hill_varying(eps, Diffusion::squared); },
                              "centre 0.95 0.95 height 0.1"})),
            make_recipe("hill-fig14", "energy errors for varying diffusion over N", figure14)};
}

} // namespace gaspard
