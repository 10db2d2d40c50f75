// How convex the map is, and how far the linearised Monge-Ampere operator is from the Laplacian.
//
//   d/dphi  m det(I + sigma)  =  -div( m cof(I + sigma) grad . )        (cof is free of divergence)
//
// Relative to the Laplacian its spectrum lies between the smallest and the largest eigenvalue of m cof, which
// in two dimensions are those of I + sigma times m. They are taken at the vertices.
#pragma once

#include "core/fem/determinant_load.hpp"

#include <span>

namespace gaspard {

struct Ellipticity {
    double convexity = 0;            ///< smallest eigenvalue of I + sigma
    double slowest = 0, fastest = 0; ///< smallest and largest eigenvalue of m cof(I + sigma)
};

/// `monitor` at the mesh's nodes.
Ellipticity ellipticity(const LineGrid& grid, std::span<const double> monitor, const WeakHessian& sigma);

} // namespace gaspard
