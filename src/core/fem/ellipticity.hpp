// Convexity of the map and ellipticity of the linearised Monge-Ampere operator,
//
//   d/dphi  m det(I + sigma)  =  -div( m cof(I + sigma) grad . )        (cof is divergence-free)
//
// Relative to the Laplacian its spectrum lies in [lambda_min, lambda_max], the extreme eigenvalues of
// m cof(I + sigma). In two dimensions these are m times the eigenvalues of I + sigma. They are evaluated at
// the vertices.
#pragma once

#include "core/fem/determinant_load.hpp"

#include <span>

namespace gaspard {

struct Ellipticity {
    double convexity = 0;            ///< smallest eigenvalue of I + sigma
    double slowest = 0, fastest = 0; ///< lambda_min and lambda_max of m cof(I + sigma)
    double theta = 1;                ///< mean of m det(I + sigma): the unit of the eigenvalues
};

/// `monitor`: values at the nodes of the mesh.
Ellipticity ellipticity(const LineGrid& grid, std::span<const double> monitor, const WeakHessian& sigma);

} // namespace gaspard
