// Regular grids of a chart: values of a function at points in equal steps of the chart's coordinates.
//
// Values are in arrays of grid.size() numbers, the first direction fastest.
#pragma once

#include "core/mesh/chart.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace gaspard {

/// How a function on a grid goes on beyond the grid's ends.
enum class GridEnds {
    free,       ///< nothing is known: not-a-knot conditions; beside the box the function goes on linearly
    reflecting, ///< mirrored, with slope zero at the ends
    periodic,
    poles, ///< of the latitude: on the opposite meridian
};

struct GridDirection {
    std::size_t count = 0; ///< of points; at least 1
    GridEnds ends = GridEnds::free;
    /// true: in the middles of `count` intervals, which divide the direction; not with free ends or poles.
    /// false: the first point at the low end and, unless periodic, the last at the high end.
    bool centred = false;
    friend bool operator==(const GridDirection&, const GridDirection&) = default;
};

struct Grid {
    std::shared_ptr<const Chart> chart;
    std::vector<GridDirection> directions; ///< as many as the chart has

    std::size_t size() const;
    /// The step from point to point; the length of the direction if there is one point.
    double spacing(std::size_t direction) const;
    double coordinate(std::size_t direction, std::size_t i) const;
    /// The chart's coordinates of all points.
    Points coordinates() const;
};

/// A grid with this many points along each direction. What ends in the chart is free (or reflecting, and then
/// with points in the middles of intervals); on the sphere the rows at the ends are the poles, the number of
/// longitudes is rounded up to an even one and that of latitudes is at least 3.
Grid grid_on(std::shared_ptr<const Chart> chart, std::vector<std::size_t> counts,
             GridEnds open_ends = GridEnds::free);

/// The measure (length, area, volume) of the part of the domain that a point of the grid stands for.
std::vector<double> measures(const Grid& grid);

} // namespace gaspard
