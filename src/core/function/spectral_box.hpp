// Functions of the Laplacian on a box: values on a grid are expanded in trigonometric functions (periodic
// directions) and cosines (other directions, slope zero at the ends), whose coefficients are multiplied.
#pragma once

#include "core/function/grid.hpp"

#include <functional>
#include <span>
#include <stop_token>

namespace gaspard {

/// Multiplies the coefficient of every eigenfunction of -Delta, with eigenvalue lambda, by factor(lambda).
/// Throws Interrupted if asked to stop.
void multiply_spectrum(const Grid& grid, std::span<double> values,
                       const std::function<double(double lambda)>& factor, const Progress& progress,
                       const std::stop_token& stop);

} // namespace gaspard
