// The test problems of Hill, Madden, "Generating layer-adapted meshes using mesh partial differential
// equations" (2021), and the densities of their meshes, with the constants of the paper: beta = 0.99,
// sigma = 2.5 and, on the irregular domain, K = 0.28, for two layers K = 0.1, otherwise K = 0.4.
#pragma once

#include "core/layer/layer_pde.hpp"
#include "core/layer/square_mesh_pde.hpp"
#include "core/layer/triangle_problem.hpp"
#include "core/monitor/monitor.hpp"
#include "core/scenario/catalogue.hpp"

#include <memory>

namespace gaspard {

/// A problem on [0, 1], the density of its meshes and how the mesh PDE is solved.
struct HillInterval {
    std::shared_ptr<const Monitor> density;
    IntervalPde pde;
    MeshPdeOptions options;
};
/// Reaction and diffusion (6) with the density (18).
HillInterval hill_scalar(const Catalogue& catalogue, double eps);
/// The coupled system (25) with the density (27).
HillInterval hill_coupled(const Catalogue& catalogue, double eps1, double eps2);

/// A problem on a quadrilateral, the densities of its meshes and how the mesh PDE is solved.
struct HillSquare {
    LayerDensities densities;
    SquareMeshPdeOptions options;
    TriangleProblem problem;
};
/// On the irregular domain: (32) with the density (34).
HillSquare hill_irregular(double eps);
/// The matrix of (35a): as the paper prints it, or its square, which corresponds to (25a), to the densities
/// (37) and to the errors that the paper reports.
enum class Diffusion { squared, as_printed };
/// Diffusion that varies on the unit square: (35) with the densities (37).
HillSquare hill_varying(double eps, Diffusion diffusion);

} // namespace gaspard
