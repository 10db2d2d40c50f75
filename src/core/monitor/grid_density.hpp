// Densities on grids, which images and fields become:
//
//   m_i = 1 + (C - 1) d_i,    d_i in [0, 1]     C: the contrast, the largest ratio of densities
//   m(x) = exp( spline of log m_i )             positive whatever the interpolation does
//
// They are blurred so much that a mesh can follow them (steepness() in monitor/stages.hpp).
#pragma once

#include "core/function/grid.hpp"
#include "core/monitor/domain_grid.hpp"
#include "core/monitor/monitor.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// Overwrites d by 1 + (C - 1) d.
void to_density(std::span<double> d, double contrast);
/// Blurs m on the grid of a domain by sigma, and by more until it is not steeper than the limit. Returns the
/// sigma of all of the blur. Throws Interrupted if asked to stop.
double blur_density(const DomainGrid& domain, std::span<double> m, double sigma, const DataContext& context);
/// The monitor with these values, which are positive, on a grid; beside the grid within e times their range.
std::shared_ptr<const Monitor> grid_density(Grid grid, std::vector<double> density, MonitorReport report,
                                            SpaceKind kind);

} // namespace gaspard
