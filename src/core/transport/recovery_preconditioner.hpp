// Preconditioner of the linearised equation (78) with coefficients A = cof H:
//
//   S w = r,   S = sum_i d_i D_i^T (A_i + t I) D_i        with gradient recovery
//   S = (A grad u, grad v)                                without
//
// D_i u is the mean of grad u at node i over the triangles around it, weighted by their areas: the recovered
// gradient with the mass matrix lumped. The rows of A are free of divergence, and the oblique condition with
// the right scale is the conormal one, so that S is the equation integrated by parts. The exact mass matrix
// and the lumped one are spectrally equivalent; the condition number of S^-1 J is therefore bounded over all
// meshes, also for the oscillations that a recovered gradient does not see. Sparse Cholesky factorisation.
#pragma once

#include "core/transport/nonvariational_space.hpp"

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace gaspard {

class RecoveryPreconditioner {
  public:
    /// Throws Interrupted if asked to stop.
    explicit RecoveryPreconditioner(std::shared_ptr<const NonvariationalSpace> space,
                                    const std::stop_token& stop = {});

    /// Factorises S. `hessians`: as NonvariationalSpace::differentiate gives them; where H is not positive
    /// definite, its eigenvalues are raised. Throws Interrupted.
    void factorise(std::span<const double> hessians, std::stop_token stop);
    /// Of u at the nodes and c (TransportForm): S w - c (1, v) = r_v and -(w, 1) = r_c. S has the kernel of
    /// the constants, nearly; c and the mean of w follow from the rows for them.
    void solve(std::span<const double> r, std::span<double> w);

  private:
    void make_rings();

    std::shared_ptr<const NonvariationalSpace> space_;
    // With recovery, the "cells" of the factorisation are the nodes:
    CellUnknowns rings_;
    std::vector<double> means_; ///< D_i: two numbers per unknown of a ring
    std::vector<double> weights_, masses_;
    std::shared_ptr<const Dissection> dissection_;
    std::optional<CellCholesky> factor_;
    std::vector<double> ordered_;
};

} // namespace gaspard
