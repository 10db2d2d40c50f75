// Integrals over the inside of a convex curve, and the affine map between moments.
#pragma once

#include "core/transport/convex_curve.hpp"

#include <vector>

namespace gaspard {

struct WeightedPoints {
    Points x;
    std::vector<double> weights; ///< their sum is the area
};

/// A rule in polar coordinates, x = centre + r (gamma(t) - centre): three Gauss points in each of 48 parts of
/// r, 384 values of t.
WeightedPoints points_within(const ConvexCurve& curve);

/// The symmetric positive definite A with A S A = T: the gradient of a quadratic polynomial that transports
/// the Gaussian density with second moments S to that with T (Knott, Smith, 1984),
///
///   A = S^(-1/2) (S^(1/2) T S^(1/2))^(1/2) S^(-1/2).
Covariance transport_of_covariances(const Covariance& from, const Covariance& to);

} // namespace gaspard
