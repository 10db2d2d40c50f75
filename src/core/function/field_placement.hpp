// Where the data of a field lie on a domain; shared by grids and scattered points.
#pragma once

#include "core/data/field_data.hpp"
#include "core/function/chart_extent.hpp"
#include "core/function/field_function.hpp"
#include "core/mesh/chart.hpp"

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gaspard {

/// An affine map of one coordinate.
struct AxisMap {
    double factor = 1, shift = 0;
    double operator()(double t) const { return factor * t + shift; }
};
AxisMap between(double low, double high, double to_low, double to_high);

struct AxisRange {
    double low = 0, high = 0;
    double length() const { return high - low; }
};
/// `all` is not empty.
AxisRange range_of(const std::vector<double>& all);
AxisRange range_of(const Chart& chart, std::size_t direction);

/// Whether data with these ranges of coordinates, as many as the chart has, are placed by them.
bool by_coordinates(const std::vector<AxisRange>& data, Coordinates coordinates, const Chart& chart,
                    FieldPlacement wanted);
/// Says that the data are fitted if that was not asked for.
void note_placement(bool by_coordinates, FieldPlacement wanted, const Chart& chart,
                    std::vector<std::string>& notes);
/// Says how much of the domain has no data: of the nodes of the mesh, or of the points of the grid if there
/// is no mesh. `inside`: of every point of the grid whether it has. Throws InputError if nothing has, or if
/// that is not allowed.
void note_coverage(const Grid& grid, const std::vector<char>& inside, const FieldOptions& options,
                   const DataContext& context, std::vector<std::string>& notes);
/// The grid for data with these steps in the chart's coordinates: its steps are half of them, unless the blur
/// makes that needless; at most `most` points along each direction.
Grid sampling_grid(const std::shared_ptr<const Chart>& chart, const std::array<double, 2>& data_steps,
                   const ChartExtent& extent, double sigma, std::size_t most);
/// Reports progress; throws Interrupted if asked to stop.
void check_stop(const DataContext& context, double done, std::string_view what);

/// The two kinds of data on a grid of a chart with two directions (field_grid).
FieldGrid grid_field(GridData data, const FieldOptions& options, const DataContext& context);
FieldGrid scattered_field(ScatteredData data, const FieldOptions& options, const DataContext& context);
/// Both kinds on a grid of a solid's chart. Throws InputError if they do not have three coordinates.
FieldGrid solid_field(const FieldData& field, const FieldOptions& options, const DataContext& context);

} // namespace gaspard
