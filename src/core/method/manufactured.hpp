// A problem with a known solution on the unit square, Bahari et al. (2024), examples 5.1 and 7.1:
//
//   Phi         = exp((x^2 + y^2) / 2)
//   det D^2 Phi = (1 + x^2 + y^2) exp(x^2 + y^2)
//
// with the exact normal derivative as boundary data.
#pragma once

#include "core/method/patch_form.hpp"

namespace gaspard {

struct ManufacturedResult {
    double error = 0;   ///< L2 norm of Psi - grad Phi
    int iterations = 0; ///< on the finest mesh, from phi = 0 or from the coarser mesh
};

struct ManufacturedChoice {
    Formulation formulation = Formulation::standard;
    int degree = 3;
    std::size_t cells = 8;
    bool multilevel = false; ///< start on 8 cells and refine
    double penalty = 0;      ///< epsilon of the paper
};

/// Picard iteration until the L2 norm of the increment is below 1e-10; on coarser meshes below 1e-4.
ManufacturedResult solve_manufactured(const ManufacturedChoice& choice);

} // namespace gaspard
