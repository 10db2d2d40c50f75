// Errors of a finite element solution of the transport equation, where the exact potential is known.
#pragma once

#include "core/transport/convex_curve.hpp"
#include "core/transport/transport_form.hpp"

#include <functional>

namespace gaspard {

struct ExactPotential {
    std::function<double(Vec3)> value;
    std::function<Vec3(Vec3)> gradient;
    std::function<Covariance(Vec3)> hessian;
};

/// The norms (102) to (106) of Kawecki, Lakkis, Pryer (2018), in L2 of the mesh, with its quadrature.
struct TransportErrors {
    double value = 0;              ///< U - u
    double gradient = 0;           ///< grad U - grad u, of each triangle: the seminorm of H1
    double recovered_gradient = 0; ///< G U - grad u
    double hessian = 0;            ///< H U - D^2 u in Frobenius's norm; H after recovery if the space has it
};

/// Of the unknowns last evaluated.
TransportErrors transport_errors(const TransportForm& form, const ExactPotential& exact);

} // namespace gaspard
