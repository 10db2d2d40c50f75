// Tensor products of splines in one to three directions, and the discrete de Rham spaces of Bahari et al.
// (2.13), (2.14). Slow and general; what iterations need is in spline_forms.hpp.
#pragma once

#include "core/base/points.hpp"
#include "core/spline/knots.hpp"

#include <array>
#include <span>
#include <vector>

namespace gaspard {

/// Functions B_i(x) B_j(y) B_k(z); coefficients run fastest in the first direction.
struct TensorSpace {
    std::vector<KnotVector> directions; ///< one to three

    std::size_t size() const;
    friend bool operator==(const TensorSpace&, const TensorSpace&) = default;
};

/// The derivative of given order in each direction, at a point.
double evaluate(const TensorSpace& space, std::span<const double> coefficients, Vec3 point,
                std::array<int, 3> orders = {0, 0, 0});
/// Coefficients in `fine`, which refines `coarse` in every direction, of the same function: exact.
std::vector<double> insert_knots(const TensorSpace& coarse, std::span<const double> coefficients,
                                 const TensorSpace& fine);

/// grad (H1) -> [curl (3D only)] -> div -> L2, each derivative of a member of one space being a member of the
/// next; in 2D the first arrow is the rotated gradient.
struct DeRham {
    TensorSpace gradient;
    std::vector<TensorSpace> curl; ///< its three components, (2.15); empty in 2D
    std::vector<TensorSpace> divergence;
    TensorSpace square; ///< L2
};
DeRham de_rham(const TensorSpace& space);

} // namespace gaspard
