// Smoothing of a function on a regular grid, by a length in the units of the domain.
//
//   Gaussian blur       g = exp(sigma^2 / 2 Delta) f, which on the plane is the convolution with a normal
//                       distribution of standard deviation sigma
//   Helmholtz filter    (I - L^2 Delta) g = f
//
// Delta is the Laplacian (Laplace-Beltrami on surfaces), with slope zero at open ends. On boxes it is exact
// for the trigonometric polynomials through f (FFT). On the sphere and on surfaces it is that of finite
// volumes on the grid (error O(h^2)), and the blur is `blur_steps` implicit Euler steps of heat conduction,
// which are Helmholtz filters with L^2 = sigma^2 / (2 blur_steps). Both keep the mean (by `measures`) and
// constants; on the sphere and on surfaces with orthogonal parameters also the range of f.
#pragma once

#include "core/function/grid.hpp"

#include <span>
#include <stop_token>
#include <vector>

namespace gaspard {

inline constexpr int blur_steps = 8;

/// Overwrite the values f (grid.size() of them) by g. Lengths >= 0; with 0 nothing changes. Throw
/// Interrupted if asked to stop.
void blur(const Grid& grid, std::span<double> values, double sigma, const Progress& progress = {},
          std::stop_token stop = {});
void helmholtz_filter(const Grid& grid, std::span<double> values, double length,
                      const Progress& progress = {}, std::stop_token stop = {});

} // namespace gaspard
