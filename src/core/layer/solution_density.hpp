// Densities of an interval's mesh from a computed solution of order 1, in place of one that knows eps. With
// the slopes s_i of u on cells of width h_i, and u'' from differences of slopes:
//
//   arc length   sqrt(1 + (s_i / scale)^2),          scale: the mean of |u'|
//   curvature    (1 + |u''|^2 / alpha)^(1/k),        alpha^(1/k): the mean of |u''|^(2/k)
//   estimate     eta_i^(2/3) / h_i + their mean,     eta_i^2 = e h^3 |u''|^2 / 12 + h^5 |u''|^2 / 120
//
// Scales are means over the interval, so that about half of the cells are where u changes fast, without any
// constant. eta_i is the energy norm of the interpolation error of cell i, e the diffusion
// (interval_problem.hpp); k = 3 is right for it in layers, and 5 for its part in L2. Components are summed,
// each with its own scale.
#pragma once

#include "core/layer/interval_mesh.hpp"
#include "core/layer/interval_problem.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// Densities of cells. Throw InputError if the solution has not a value per node of a mesh of three nodes or
/// more; 1 for a solution that does not change.
std::vector<double> arc_length_densities(std::span<const double> x, const IntervalSolution& solution);
std::vector<double> curvature_densities(std::span<const double> x, const IntervalSolution& solution,
                                        double k = 3);
std::vector<double> estimate_densities(const IntervalProblem& problem, std::span<const double> x,
                                       const IntervalSolution& solution);

/// sqrt(sum of eta_i^2): an estimate of the energy norm of the error; right to 1 % where layers are resolved,
/// and without meaning where they are not.
double estimated_error(const IntervalProblem& problem, std::span<const double> x,
                       const IntervalSolution& solution);

/// Means (1, 2, 1) / 4 over neighbouring cells, whatever their widths, `times` times.
std::vector<double> smoothed_densities(std::vector<double> densities, int times);

/// The densities of cells as a function of x, constant on each cell.
std::shared_ptr<const Monitor> cell_monitor(std::vector<double> x, std::vector<double> densities);

enum class SolutionDensity { arc_length, curvature, estimate };
struct SolutionMeshOptions {
    SolutionDensity density = SolutionDensity::arc_length;
    int start_cells = 8; ///< N, N/2, ... as long as they are even and not less
    int steps = 10;      ///< solutions on each mesh, each before one step of (15)
    int smoothing = 2;   ///< of densities, by smoothed_densities()
};

/// The densities of these options for a solution of order 1.
std::vector<double> solution_densities(const SolutionMeshOptions& options, const IntervalProblem& problem,
                                       std::span<const double> x, const IntervalSolution& solution);

/// Alternates solutions of order 1 with steps of (15), from a uniform mesh of few cells, which is refined:
/// boundary layers of reaction-diffusion are found by coefficients alone. For (6), eps = 1e-2 to 1e-8 and N =
/// 32 to 256, the energy error is 0.8 to 1.1 times that of (18) by curvature or estimate, 1.3 to 1.7 times by
/// arc length. Layers at both ends: arc length finds them (the coupled system (25) with 0.4 to 0.9 times the
/// error of (27)), estimate for N >= 128; by curvature one layer takes all cells for small eps. Layers of
/// convection are found, too (-eps u'' + u' = 1 with 0.8 to 0.9 times the error of a density that knows eps,
/// by arc length 1.3 to 1.6 times), since these solutions are fitted (solve_fitted()): Galerkin's oscillate
/// on coarse meshes. Not found: layers inside the interval for eps <= 1e-4.
///
/// (15) moves cells as such. Equidistribution of the densities as functions of x would bring nodes to a layer
/// at once, but takes them away from its edge as fast, where one wide cell knows nothing of it: it cycles for
/// eps <= 1e-6. Steps of other densities on the last mesh lose the layer for N >= 128. Throws InputError if
/// cells < start_cells or start_cells < 4, and as solve_interval().
std::vector<double> mesh_from_solution(const IntervalProblem& problem, Interval interval, int cells,
                                       const SolutionMeshOptions& options);

} // namespace gaspard
