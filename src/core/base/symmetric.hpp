// Determinant, cofactors and eigenvalues of symmetric matrices of size 2 and 3, given by the upper triangle
// by rows: (xx, xy, yy), (xx, xy, xz, yy, yz, zz).
#pragma once

#include "core/base/eigenvalues.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gaspard {

template <std::size_t D>
using Symmetric = std::array<double, D*(D + 1) / 2>;

/// Where the diagonal is in the upper triangle.
template <std::size_t D>
inline constexpr std::array<std::size_t, D> diagonal{};
template <>
inline constexpr std::array<std::size_t, 2> diagonal<2> = {0, 2};
template <>
inline constexpr std::array<std::size_t, 3> diagonal<3> = {0, 3, 5};

inline double trace(const Symmetric<2>& h) { return h[0] + h[2]; }
inline double trace(const Symmetric<3>& h) { return h[0] + h[3] + h[5]; }

/// The derivatives of the determinant with respect to the entries of a matrix that need not be symmetric.
inline Symmetric<2> cofactors(const Symmetric<2>& h) { return {h[2], -h[1], h[0]}; }
inline Symmetric<3> cofactors(const Symmetric<3>& h) {
    const auto& [xx, xy, xz, yy, yz, zz] = h;
    return {yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy,
            xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
}

inline double determinant(const Symmetric<2>& h) { return h[0] * h[2] - h[1] * h[1]; }
inline double determinant(const Symmetric<3>& h) {
    const Symmetric<3> c = cofactors(h);
    return h[0] * c[0] + h[1] * c[1] + h[2] * c[2];
}

/// Ascending.
inline std::array<double, 2> eigenvalues(const Symmetric<2>& h) {
    const auto [smallest, largest] = symmetric_eigenvalues(h[0], h[1], h[2]);
    return {smallest, largest};
}
/// With B = (H - mean) / p of unit size: 2 cos of a third of the angle whose cosine is det B / 2.
inline std::array<double, 3> eigenvalues(const Symmetric<3>& h) {
    const double mean = trace(h) / 3;
    Symmetric<3> b = h;
    for (const std::size_t d : diagonal<3>) b[d] -= mean;
    const double square =
        b[0] * b[0] + b[3] * b[3] + b[5] * b[5] + 2 * (b[1] * b[1] + b[2] * b[2] + b[4] * b[4]);
    const double p = std::sqrt(square / 6);
    if (!(p > 0)) return {mean, mean, mean};
    for (double& entry : b) entry /= p;
    const double angle = std::acos(std::clamp(determinant(b) / 2, -1.0, 1.0)) / 3;
    const double largest = mean + 2 * p * std::cos(angle);
    const double smallest = mean + 2 * p * std::cos(angle + 2 * std::numbers::pi / 3);
    return {smallest, 3 * mean - smallest - largest, largest};
}

} // namespace gaspard
