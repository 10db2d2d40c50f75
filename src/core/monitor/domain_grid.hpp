// A regular grid for a computation on a domain: its points, the part of the domain that each stands for, and
// how large the cells of the mesh are. Planar patches and most solids do not fill their box: grid points
// beside them have measure zero, and functions take there the values of their nearest points.
#pragma once

#include "core/function/grid.hpp"
#include "core/mesh/data_context.hpp"

#include <span>
#include <vector>

namespace gaspard {

struct DomainGrid {
    Grid grid;
    Points s{}; ///< coordinates of the grid's points; beside the domain of the nearest one
    Points x{}; ///< the points themselves, likewise
    std::vector<double> measures{}; ///< 0 beside the domain
    bool patch = false; ///< a patch or solid in a larger box: functions may go on slightly beside it
    double size = 1;    ///< of the domain: longest side of its box, radius of a sphere
    double cell = 1;    ///< size of a cell of the uniform mesh (cell_size)

    std::size_t dimension() const { return grid.directions.size(); }
    /// The average over the domain.
    double mean(std::span<const double> values) const;
    /// Points beside the domain do not count.
    double least(std::span<const double> values) const;
    double largest(std::span<const double> values) const;
};

/// Values beside a patch or solid become those of its nearest points.
void go_on_beside(const DomainGrid& domain, std::vector<double>& values);
/// A grid of the domain's chart as a grid of the domain.
DomainGrid domain_on(Grid grid, const DataContext& context);
/// About `per_cell` points along each side of a cell of the mesh, but at most 600,000 in all. Without a
/// discretisation as for a mesh of 60 cells along the domain.
DomainGrid domain_grid(const DataContext& context, double per_cell);

} // namespace gaspard
