// The Helmholtz filter (I - L^2 Delta) g = f on curved surfaces by finite volumes around the points of a
// grid: factorised once, applied many times.
//
//   sphere    the longitudes by Fourier transform, a tridiagonal system of latitudes for every wave number;
//             the points of a pole are one unknown
//   surface   five-point stencils with the metric in the middles of the grid's cells, and mixed derivatives
//             there; a sparse factorisation
#pragma once

#include "core/function/grid.hpp"

#include <memory>
#include <span>
#include <stop_token>

namespace gaspard {

class SurfaceFilter {
  public:
    virtual ~SurfaceFilter() = default;
    /// Overwrites f by g. Throws Interrupted if asked to stop.
    virtual void apply(std::span<double> values, const std::stop_token& stop) = 0;
};

std::unique_ptr<SurfaceFilter> sphere_filter(const Grid& grid, double length);
std::unique_ptr<SurfaceFilter> patch_filter(const Grid& grid, double length, const Progress& progress,
                                            const std::stop_token& stop);

} // namespace gaspard
