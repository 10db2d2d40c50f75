// Densities on grids, which images and fields become:
//
//   m_i = 1 + (C - 1) d_i,    d_i in [0, 1]     C: the contrast, the largest ratio of densities
//   m(x) = exp( spline of log m_i )             positive whatever the interpolation does
//
// They are blurred so much that the relative change of m over a cell of the adapted mesh is limited; h is the
// size of the cells of the uniform mesh:
//
//   max over x of  h sqrt( mean m / m(x) ) |grad m(x)| / m(x)  <=  steepest
#pragma once

#include "core/function/grid.hpp"
#include "core/monitor/monitor.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// Overwrites d by 1 + (C - 1) d.
void to_density(std::span<double> d, double contrast);
/// The limit above: 1.2 on the square, 0.5 on the sphere and on patches. Found by experiment
/// (bench/images.py, docs/monitors.md): with it, `auto` converges for every picture tried.
double steepest(const Space& space);
/// Blurs m by sigma, and by more until it is not steeper than the limit. Returns the sigma of all of the
/// blur. Throws Interrupted if asked to stop.
double blur_density(const Grid& grid, std::span<double> m, double sigma, double cell,
                    const DataContext& context);
/// The monitor with these values, which are positive, on a grid.
std::shared_ptr<const Monitor> grid_density(Grid grid, std::vector<double> density, MonitorReport report,
                                            SpaceKind kind);

} // namespace gaspard
