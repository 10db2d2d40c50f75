// Newton's method for the transport equation, undamped, as in Kawecki, Lakkis, Pryer (2018), section 5.10:
//
//   (dr/du) w = -r,   u := u + w
//
// with GMRES for w. From a bad start it may diverge; core/method/nvfem.cpp has the damped method of runs.
#pragma once

#include "core/transport/recovery_preconditioner.hpp"
#include "core/transport/transport_form.hpp"

#include <stop_token>
#include <vector>

namespace gaspard {

struct TransportNewtonLimits {
    double tolerance = 1e-10;      ///< of TransportForm::normalised_residual()
    double inner_tolerance = 1e-8; ///< of the linear systems
    int steps = 20, inner = 200;
};

struct TransportNewton {
    std::vector<int> inner; ///< iterations of GMRES, one number per step
    bool converged = false;
};

/// Changes `unknowns` until the residual is small, it is not finite, or the limits are reached. The form has
/// then evaluated them. Throws InputError as TransportForm::evaluate() does, and Interrupted.
TransportNewton transport_newton(TransportForm& form, RecoveryPreconditioner& preconditioner,
                                 const TransportDensities& densities, std::vector<double>& unknowns,
                                 const TransportNewtonLimits& limits = {}, std::stop_token stop = {});

} // namespace gaspard
