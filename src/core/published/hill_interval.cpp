// Hill, Madden (2021), section 2: tables 1 to 4, figures 4 and 7.
#include "core/base/error.hpp"
#include "core/published/hill.hpp"
#include "core/published/hill_problems.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr std::array<double, 5> all_eps = {1, 1e-2, 1e-4, 1e-6, 1e-8};
constexpr std::array<int, 6> all_cells = {32, 64, 128, 256, 512, 1024};
constexpr double eps1_of_system = 1e-8;

/// Rows: eps; columns: N.
template <class T>
using PrintedTable = std::array<std::array<T, all_cells.size()>, all_eps.size()>;

constexpr PrintedTable<int> table1 = {{{1, 1, 1, 1, 1, 1},
                                       {15, 14, 15, 15, 14, 13},
                                       {21, 37, 69, 132, 256, 343},
                                       {21, 37, 69, 133, 261, 517},
                                       {21, 37, 69, 133, 261, 517}}};
constexpr PrintedTable<int> table2 = {
    {{1, 1, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1}, {3, 2, 2, 1, 1, 1}, {4, 4, 3, 3, 2, 1}, {4, 4, 4, 4, 3, 3}}};
constexpr PrintedTable<double> table3 = {
    {{4.895e-03, 2.448e-03, 1.224e-03, 6.119e-04, 3.060e-04, 1.530e-04},
     {3.887e-03, 1.949e-03, 9.749e-04, 4.875e-04, 2.438e-04, 1.219e-04},
     {4.114e-04, 2.053e-04, 1.031e-04, 5.163e-05, 2.586e-05, 1.294e-05},
     {4.139e-05, 2.071e-05, 1.035e-05, 5.179e-06, 2.590e-06, 1.296e-06},
     {4.141e-06, 2.071e-06, 1.036e-06, 5.181e-07, 2.590e-07, 1.295e-07}}};
constexpr PrintedTable<int> table4 = {
    {{1, 4, 1, 1, 1, 2}, {3, 2, 2, 1, 1, 1}, {3, 2, 1, 1, 1, 1}, {3, 3, 3, 2, 1, 1}, {4, 2, 2, 2, 2, 1}}};

std::string title_of(const std::string& symbol, double eps, int cells) {
    return eps_title(symbol, eps) + ", N = " + std::to_string(cells);
}

/// One place of a table.
struct Case {
    std::size_t row, column;
    double eps;
    int cells;
    std::string title;
};
/// All places, by rows. `symbol`: of the eps that varies.
template <class Visit>
void visit(const Workshop& workshop, const std::string& symbol, const Visit& one) {
    for (std::size_t row = 0; row < all_eps.size(); ++row)
        for (std::size_t column = 0; column < all_cells.size(); ++column) {
            if (workshop.stop.stop_requested()) throw Interrupted();
            const Case place{row, column, all_eps[row], all_cells[column],
                             title_of(symbol, all_eps[row], all_cells[column])};
            if (column == 0) workshop.announce(eps_title(symbol, place.eps));
            one(place);
        }
}

MeshPdeResult mesh(const HillInterval& problem, int cells) {
    return mesh_pde_interval(*problem.density, {}, cells, problem.options);
}

Printed count(int number) { return {static_cast<double>(number), 0}; }

Reproduction reproduce_table1(const Workshop& workshop) {
    Reproduction result;
    visit(workshop, "ε", [&](const Case& at) {
        const int cap = at.cells / 2 + 5;
        const auto density = hill_scalar(*workshop.catalogue, at.eps).density;
        const int iterations = mesh_pde_interval(*density, {}, at.cells, {at.cells, 0, 0.02, cap}).iterations;
        result.rows.push_back({at.title, "iterations", static_cast<double>(iterations),
                               count(table1[at.row][at.column]),
                               iterations == cap ? "stops at the limit N/2 + 5 of the paper" : ""});
    });
    return result;
}

Reproduction iterations_on_the_last_mesh(const Workshop& workshop, const std::string& symbol,
                                         const PrintedTable<int>& published,
                                         const std::function<HillInterval(double)>& problem) {
    Reproduction result;
    visit(workshop, symbol, [&](const Case& at) {
        const MeshPdeResult made = mesh(problem(at.eps), at.cells);
        result.rows.push_back({at.title, "iterations", static_cast<double>(made.iterations),
                               count(published[at.row][at.column])});
    });
    return result;
}

Reproduction reproduce_table2(const Workshop& workshop) {
    return iterations_on_the_last_mesh(workshop, "ε", table2,
                                       [&](double eps) { return hill_scalar(*workshop.catalogue, eps); });
}

Reproduction reproduce_table4(const Workshop& workshop) {
    return iterations_on_the_last_mesh(workshop, "ε2", table4, [&](double eps2) {
        return hill_coupled(*workshop.catalogue, eps1_of_system, eps2);
    });
}

struct Errors {
    double to_reference;
    double derivative; ///< its part from the derivative: eps ||e'||
    double to_exact;   ///< 0: no exact solution is known
};
Errors errors(const HillInterval& problem, int cells) {
    const auto x = mesh(problem, cells).x;
    const auto& pde = problem.pde;
    const auto p1 = solve_interval(pde.problem, x, 1), p2 = solve_interval(pde.problem, x, 2);
    const double error = reference_error(pde.problem, x, p1, p2);
    // ||v||_E^2 is linear in the diffusion: its growth for twice the diffusion is the part of the derivative.
    IntervalProblem doubled = pde.problem;
    for (double& diffusion : doubled.diffusion) diffusion *= 2;
    const double more = reference_error(doubled, x, p1, p2);
    return {error, std::sqrt((more - error) * (more + error)),
            pde.exact ? exact_error(pde.problem, x, p1, *pde.exact) : 0.0};
}

Reproduction reproduce_table3(const Workshop& workshop) {
    Reproduction result;
    visit(workshop, "ε", [&](const Case& at) {
        const Errors found = errors(hill_scalar(*workshop.catalogue, at.eps), at.cells);
        const Printed published = printed(table3[at.row][at.column], 4);
        result.rows.push_back({at.title, "energy error", found.to_reference, published, "",
                               "cause unknown; the printed number is between ours and the part of ours that "
                               "comes from the derivative"});
        result.rows.push_back({at.title, "from the derivative", found.derivative, std::nullopt, "ε ||e'||"});
    });
    return result;
}

Reproduction figure4(const Workshop& workshop) {
    HillErrors reference("Error to the P2 solution"), exact("Error to the exact solution");
    Reproduction result;
    visit(workshop, "ε", [&](const Case& at) {
        const Errors found = errors(hill_scalar(*workshop.catalogue, at.eps), at.cells);
        const double bound = one_layer_bound(at.eps, at.cells).value;
        if (at.column == 0) reference.begin(eps_title("ε", at.eps)), exact.begin(eps_title("ε", at.eps));
        reference.add(at.cells, found.to_reference, bound), exact.add(at.cells, found.to_exact, bound);
        result.rows.push_back({at.title, "energy error", found.to_reference});
        result.rows.push_back({at.title, "exact energy error", found.to_exact});
        result.rows.push_back({at.title, "ε^(1/2) / N", bound});
    });
    const std::string bound = one_layer_bound(1, 1).formula;
    result.figure = Figure{"Errors of the scalar problem",
                           {{"P2 reference", reference.plot(bound)}, {"Exact solution", exact.plot(bound)}}};
    return result;
}

Reproduction figure7(const Workshop& workshop) {
    HillErrors series("Error to the P2 solution, ε1 = 1e-8");
    Reproduction result;
    visit(workshop, "ε2", [&](const Case& at) {
        const double error =
            errors(hill_coupled(*workshop.catalogue, eps1_of_system, at.eps), at.cells).to_reference;
        const double bound = two_layers_bound(eps1_of_system, at.eps, at.cells).value;
        if (at.column == 0) series.begin(eps_title("ε2", at.eps));
        series.add(at.cells, error, bound);
        result.rows.push_back({at.title, "energy error", error});
        result.rows.push_back({at.title, "bound (26), C = 1", bound});
    });
    result.figure =
        Figure{"Errors of the coupled system", {{"System", series.plot(two_layers_bound(1, 1, 1).formula)}}};
    return result;
}

} // namespace

std::vector<Recipe> hill_interval_recipes() {
    return {
        make_recipe("hill-table1", "iterations of algorithm 1, one layer", reproduce_table1),
        make_recipe("hill-table2", "iterations of algorithm 2 on the last mesh, one layer", reproduce_table2),
        make_recipe("hill-table3", "energy errors for one layer, algorithm 2", reproduce_table3),
        make_recipe("hill-table4", "iterations of algorithm 2 on the last mesh, a coupled system",
                    reproduce_table4),
        make_recipe("hill-fig4", "energy errors for one layer over N", figure4),
        make_recipe("hill-fig7", "energy errors of a coupled system over N", figure7)};
}

} // namespace gaspard
