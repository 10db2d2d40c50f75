// The second experiment of Kawecki, Lakkis, Pryer, "A finite element method for the Monge-Ampère equation
// with transport boundary conditions" (2018), section 6: uniform densities from the unit disk to the ellipse
//
//   x^2 / 4 + y^2 / 9 <= 1,   u = x^2 + 3 y^2 / 2 - 5/8
//
// The paper prints u = x^2 + 3 y^2 / 3 - 7/6, whose gradient (2x, 2y) does not map the disk to the ellipse.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/transport/transport_domain.hpp"
#include "core/transport/transport_errors.hpp"
#include "core/transport/transport_newton.hpp"

#include <stop_token>

namespace gaspard {

ExactPotential kawecki_potential();

struct KaweckiMesh {
    int rings = 16, degree = 1;
    Recovery recovery = Recovery::gradient;
    bool curved = false; ///< isoparametric; else straight triangles, as in the paper
};
std::shared_ptr<const TransportDomain> kawecki_domain(const KaweckiMesh& mesh);

struct KaweckiSolve {
    double h = 0; ///< the longest edge
    TransportNewton newton;
    TransportErrors errors;
    double convexity = 0; ///< TransportForm::convexity()
};
/// Newton's method from u = |x|^2 / 2. Throws Interrupted.
KaweckiSolve solve_kawecki(const KaweckiMesh& mesh, std::stop_token stop = {});

/// How well a mesh shows its monitor: the correlation of 1 / (area of a cell) with the monitor's mean over
/// the cell, each cell weighted by its area; and of (area before) / (area). Folded cells are left out.
struct DensityCorrelation {
    double of_density = 0, of_compression = 0;
    std::size_t folded = 0;
};
/// Of triangles of order 1, with full diagnostics.
DensityCorrelation density_correlation(const Snapshot& snapshot);

} // namespace gaspard
