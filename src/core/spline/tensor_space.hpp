// Tensor-product spline spaces in one to three directions, and the discrete de Rham complex of Bahari et al.
// (2.13), (2.14). General and slow; iterations use spline_forms.hpp.
#pragma once

#include "core/base/export.hpp"
#include "core/base/points.hpp"
#include "core/spline/knots.hpp"

#include <array>
#include <span>
#include <vector>

namespace gaspard GASPARD_API {

/// Functions B_i(x) B_j(y) B_k(z); the index of the first direction runs fastest.
struct TensorSpace {
    std::vector<KnotVector> directions; ///< one to three

    std::size_t size() const;
    friend bool operator==(const TensorSpace&, const TensorSpace&) = default;
};

/// A function of such a space.
struct SplineFunction {
    TensorSpace space;
    std::vector<double> coefficients; ///< the first direction varies fastest
};

/// The mixed derivative of the given orders at a point.
double evaluate(const TensorSpace& space, std::span<const double> coefficients, Vec3 point,
                std::array<int, 3> orders = {0, 0, 0});
/// The derivative along one direction of a function whose continuity allows it.
SplineFunction derivative(const SplineFunction& of, std::size_t direction);
/// Coefficients in `fine`, which refines `coarse` in every direction, of the same function.
std::vector<double> insert_knots(const TensorSpace& coarse, std::span<const double> coefficients,
                                 const TensorSpace& fine);

/// The complex grad (H1) -> curl (3D only) -> div -> L2: derivatives map each space into the next. In 2D the
/// first map is the rotated gradient.
struct DeRham {
    TensorSpace gradient;
    std::vector<TensorSpace> curl; ///< the three components, (2.15); empty in 2D
    std::vector<TensorSpace> divergence;
    TensorSpace square; ///< the L2 space
};
DeRham de_rham(const TensorSpace& space);

} // namespace GASPARD_API
