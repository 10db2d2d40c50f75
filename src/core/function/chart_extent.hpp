// The size of a domain of dimension two, and of the grids on which functions from files are sampled.
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
    double area = 0;
    double cell = 0; ///< size of a cell of the uniform mesh; of 60 x 60 cells if there is no mesh
};
ChartExtent extent_of(const std::shared_ptr<const Chart>& chart, const DataContext& context);

/// The least number >= wanted, 32 to 2048, that is even and without large prime factors, for Fourier
/// transforms.
std::size_t handy_count(double wanted);
/// A positive number with two digits, for notes.
std::string rounded(double value);

} // namespace gaspard
