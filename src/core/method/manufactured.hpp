// A problem with a known solution on the unit square or cube, Bahari et al. (2024), examples 5.1, 5.2, 7.1,
// 7.2, in d = 2 or 3 dimensions:
//
//   Phi         = exp(|xi|^2 / d)
//   det D^2 Phi = (2/d)^d (1 + 2/d |xi|^2) exp(|xi|^2)
//
// with the exact normal derivative as boundary data.
#pragma once

#include "core/method/patch_form.hpp"

#include <stop_token>

namespace gaspard {

struct ManufacturedResult {
    double error = 0;       ///< L2 norm of Psi - grad Phi
    int iterations = 0;     ///< on the finest mesh, from phi = 0 or from the coarser mesh
    double seconds = 0;     ///< wall time of these iterations
    double cpu_seconds = 0; ///< of the calling thread
};

struct ManufacturedChoice {
    Formulation formulation = Formulation::standard;
    int degree = 3;
    std::size_t cells = 8;
    bool multilevel = false; ///< start on 8 cells and refine
    double penalty = 0;      ///< epsilon of the paper
    int dimension = 2;
    std::size_t threads = 1; ///< used in three dimensions
    std::stop_token stop{};  ///< Interrupted is thrown between two iterations
};

/// Picard iteration until the L2 norm of the increment is below 1e-10; on coarser meshes below 1e-4.
ManufacturedResult solve_manufactured(const ManufacturedChoice& choice);

} // namespace gaspard
