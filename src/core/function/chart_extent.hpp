// The size of a domain and its cells, and of the grids on which functions from files are sampled.
#pragma once

#include "core/function/grid.hpp"
#include "core/mesh/chart.hpp"
#include "core/mesh/data_context.hpp"

#include <cstddef>
#include <memory>
#include <string>

namespace gaspard {

struct ChartExtent {
    double width = 0, height = 0; ///< sides of the chart's box as lengths, on surfaces their means
    double cell = 0;              ///< size of a cell of the uniform mesh (cell_size)
};
/// Length, area or volume of the domain; of a planar patch or a solid without what lies beside it in the box.
double measure_of(const std::shared_ptr<const Chart>& chart, const DataContext& context);
/// The size of a cell of the uniform mesh of a domain: (measure / cells)^(1/dimension). Two triangles count
/// as one cell; without a mesh there are 60 cells along each direction.
double cell_size(double measure, std::size_t dimension, const DataContext& context);
ChartExtent extent_of(const std::shared_ptr<const Chart>& chart, const DataContext& context);

/// The least number >= wanted, 32 to 2048, that is even and without large prime factors, for Fourier
/// transforms.
std::size_t handy_count(double wanted);
/// A positive number with two digits, for notes; and as a length: "1 cell", "2.2 cells".
std::string rounded(double value);
std::string in_cells(double value);

} // namespace gaspard
