// Meshes of an interval [a, b] that are adapted to layers: x_i = x(i/N), i = 0..N.
//
// Mesh PDE (Hill, Madden 2021, (13)), for a density rho(x) > 0:
//
//   (rho(x) x')' = 0 on (0, 1),   x(0) = a,   x(1) = b
//
// It is solved in P1 by the iteration (15): rho is taken at the last iterate, at the ends and the middle of
// every cell (Simpson's rule), so that it is seen where layers are thinnest. With the mean density r_i of
// cell i, the solution of (15) is
//
//   x_i - x_(i-1) = (b - a) (1 / r_i) / sum_j (1 / r_j),
//
// a sum instead of a linear system.
#pragma once

#include "core/monitor/monitor.hpp"

#include <span>
#include <vector>

namespace gaspard {

struct Interval {
    double a = 0, b = 1;
};

/// Nodes a + (b - a) i / N.
std::vector<double> uniform_interval(Interval interval, int cells);
/// The same mesh with a node more in the middle of every cell (uniform h-refinement).
std::vector<double> refined_interval(std::span<const double> x);

/// Density of the cells of a mesh: of cell i the mean by Simpson's rule, of `rho` at its ends and its middle.
/// Throws InputError where rho is not positive and finite.
std::vector<double> cell_densities(const Monitor& rho, std::span<const double> x);

/// The next iterate of (15), given the densities of the cells of the last one.
std::vector<double> next_interval_mesh(std::span<const double> densities, Interval interval);

/// The L2 norm of the residual (16) on the uniform mesh of [0, 1], for a mesh and the densities of its cells.
double interval_residual(std::span<const double> densities, std::span<const double> x);

/// max_i / mean_i of the integral of rho over cell i, by Simpson's rule: 1 when it is equidistributed.
double worst_share(std::span<const double> densities, std::span<const double> x);

/// How mesh_pde_interval() goes on: Algorithm 1 is start_cells = N, Algorithm 2 start_cells = 4, inner = 3.
struct MeshPdeOptions {
    int start_cells = 4;       ///< N is start_cells times a power of two
    int inner = 3;             ///< solves on each coarser mesh
    double tolerance = 0.4;    ///< of the residual on the last mesh, where at least one solve is made
    int max_iterations = 1000; ///< on the last mesh
};

struct MeshPdeResult {
    std::vector<double> x;
    int iterations = 0; ///< on the last mesh
    double residual = 0;
    bool converged = false;
};

/// Algorithms 1 and 2 of Hill, Madden. Throws InputError if `cells` is not start_cells times a power of two.
MeshPdeResult mesh_pde_interval(const Monitor& rho, Interval interval, int cells,
                                const MeshPdeOptions& options);

/// A boundary layer exp(-beta d / eps), d the distance from the end, as the constructions of Bakhvalov and of
/// Shishkin take it.
struct LayerShape {
    double eps = 1e-4;  ///< > 0
    double beta = 0.99; ///< > 0
    double sigma = 2.5; ///< > 0; about the order of the method
    double q = 0.5;     ///< share of the cells in the layer, 0 < q < 1
};

/// Bakhvalov's mesh (8) with a layer at a: x = chi(t) = -(sigma eps / beta) ln(1 - t / q) up to t = tau,
/// beyond its tangent, which ends at b. `tau` is the root of chi(tau) + (1 - tau) chi'(tau) = b - a, to
/// rounding; the mesh is uniform if there is none in (0, q).
struct BakhvalovMesh {
    std::vector<double> x;
    double tau = 0;        ///< 0: uniform
    double transition = 0; ///< x(tau)
};
BakhvalovMesh bakhvalov_mesh(const LayerShape& layer, Interval interval, int cells);

/// Shishkin's mesh with a layer at a: q N cells in [a, a + min(q (b - a), (sigma eps / beta) ln N)], the
/// others beyond, uniform each. Throws InputError if neither part has a cell.
std::vector<double> shishkin_mesh(const LayerShape& layer, Interval interval, int cells);

/// Nodes that equidistribute rho: the integral of rho from a to x_i is i/N of that to b. The integral is
/// adaptive (relative error below 1e-12 unless rho is not smooth), its inversion exact to rounding.
std::vector<double> equidistributed_interval(const Monitor& rho, Interval interval, int cells);

} // namespace gaspard
