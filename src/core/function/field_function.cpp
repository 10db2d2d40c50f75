#include "core/function/field_function.hpp"

#include "core/base/error.hpp"
#include "core/function/chart_extent.hpp"
#include "core/function/field_placement.hpp"
#include "core/function/field_values.hpp"
#include "core/function/grid_function.hpp"
#include "core/function/line_resampling.hpp"
#include "core/function/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace gaspard {

namespace {

bool first_equals_last(const GridData& grid, std::size_t d) {
    const std::size_t nx = grid.axes[0].size(), ny = grid.axes[1].size();
    const AxisRange range = range_of(grid.values);
    const std::size_t count = d == 0 ? ny : nx;
    for (std::size_t k = 0; k < count; ++k) {
        const double a = grid.values[d == 0 ? k * nx : k],
                     b = grid.values[d == 0 ? k * nx + nx - 1 : (ny - 1) * nx + k];
        if (std::abs(a - b) > 1e-6 * range.length()) return false;
    }
    return true;
}

/// The axes become coordinates of the chart, over its whole box.
void fit_axes(GridData& grid, const Chart& chart) {
    for (std::size_t d = 0; d < 2; ++d) {
        std::vector<double>& axis = grid.axes[d];
        AxisRange data = range_of(axis);
        const double step = data.length() / static_cast<double>(axis.size() - 1);
        const ChartEnds ends = chart.direction(d).ends;
        if (ends == ChartEnds::periodic && !first_equals_last(grid, d)) data.high += step;
        if (ends == ChartEnds::poles && grid.coordinates == Coordinates::none)
            data.low -= step / 2, data.high += step / 2;
        const AxisMap map = between(data.low, data.high, range_of(chart, d).low, range_of(chart, d).high);
        for (double& one : axis) one = map(one);
    }
}

double median_step(const std::vector<double>& axis) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < axis.size(); ++i) steps.push_back(axis[i] - axis[i - 1]);
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                     steps.end());
    return steps[steps.size() / 2];
}

/// The values of a row of a latitude-longitude map as they go on across a pole: of the opposite meridian.
constexpr std::size_t rows_beyond_pole = 24;

struct Rows {
    std::vector<double> axis;
    std::vector<std::vector<double>> values; ///< one row for each
};

/// Adds rows beyond poles that are within a step of the outermost rows.
void go_across_poles(Rows& rows) {
    const std::size_t n = rows.axis.size();
    const double step = median_step(rows.axis);
    const auto opposite = [](const std::vector<double>& row) {
        std::vector<double> turned = row;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(row.size() / 2),
                    turned.end());
        return turned;
    };
    Rows more;
    const auto add = [&](double latitude, const std::vector<double>& row) {
        const bool first = more.axis.empty();
        if (!first && latitude - more.axis.back() < 1e-6 * step) return; // the pole itself
        more.axis.push_back(latitude), more.values.push_back(row);
    };
    const std::size_t beyond = std::min(n, rows_beyond_pole);
    if (rows.axis.front() + 90 <= step * 1.001)
        for (std::size_t j = beyond; j-- > 0;) add(-180 - rows.axis[j], opposite(rows.values[j]));
    for (std::size_t j = 0; j < n; ++j) add(rows.axis[j], rows.values[j]);
    if (90 - rows.axis.back() <= step * 1.001)
        for (std::size_t j = n; j-- > n - beyond;) add(180 - rows.axis[j], opposite(rows.values[j]));
    rows = std::move(more);
}

/// The field on the grid; its axes are coordinates of the chart.
std::vector<double> resample(const GridData& data, const Grid& grid, const FieldOptions& options,
                             const DataContext& context, std::vector<std::string>& notes) {
    const Chart& chart = *grid.chart;
    const std::size_t nx = data.axes[0].size(), columns = grid.directions[0].count,
                      rows = grid.directions[1].count;
    const auto period = [&](std::size_t d) -> std::optional<double> {
        const AxisRange box = range_of(chart, d);
        const bool fits = range_of(data.axes[d]).length() <= box.length() * (1 + 1e-6);
        return chart.direction(d).ends == ChartEnds::periodic && fits ? std::optional(box.length())
                                                                      : std::nullopt;
    };
    const LineResampling across(data.axes[0], grid.coordinate(0, 0), grid.spacing(0), columns, period(0));
    Rows lines{data.axes[1], {}};
    for (std::size_t j = 0; j < data.axes[1].size(); ++j) {
        if (j % 64 == 0)
            check_stop(context, static_cast<double>(j) / static_cast<double>(data.axes[1].size()),
                       "Placing the field");
        lines.values.emplace_back(columns);
        across.apply(std::span(data.values).subspan(j * nx, nx), lines.values.back());
    }
    if (chart.kind() == ChartKind::sphere) go_across_poles(lines);
    const LineResampling up(lines.axis, grid.coordinate(1, 0), grid.spacing(1), rows, period(1));
    std::vector<double> result(grid.size()), given(lines.axis.size()), wanted(rows);
    const double low = range_of(data.values).low;
    std::vector<char> covered(grid.size());
    for (std::size_t i = 0; i < columns; ++i) {
        for (std::size_t j = 0; j < given.size(); ++j) given[j] = lines.values[j][i];
        up.apply(given, wanted);
        for (std::size_t j = 0; j < rows; ++j) {
            const bool inside = across.covers(i) && up.covers(j);
            covered[j * columns + i] = inside ? 1 : 0;
            result[j * columns + i] = inside || options.missing != MissingValues::lowest ? wanted[j] : low;
        }
    }
    note_coverage(grid, covered, options, context, notes);
    return result;
}

} // namespace

FieldGrid grid_field(GridData data, const FieldOptions& options, const DataContext& context) {
    FieldGrid made;
    prepare_values(data, options, made.notes);
    const auto chart = chart_of(context);
    const ChartExtent extent = extent_of(chart, context);
    const bool placed = by_coordinates({range_of(data.axes[0]), range_of(data.axes[1])}, data.coordinates,
                                       *chart, options.placement);
    if (placed && chart->kind() == ChartKind::surface)
        throw InputError(
            "a grid with two coordinates cannot be placed by them on a surface in space; use placement = "
            "fit");
    if (!placed) fit_axes(data, *chart);
    note_placement(placed, options.placement, *chart, made.notes);
    made.cell = extent.cell, made.sigma = options.blur * extent.cell;
    made.grid = sampling_grid(chart, {median_step(data.axes[0]), median_step(data.axes[1])}, extent,
                              made.sigma, 2048);
    made.values = resample(data, made.grid, options, context, made.notes);
    return made;
}

FieldGrid field_grid(const FieldData& field, const FieldOptions& options, const DataContext& context) {
    const std::size_t dimension = chart_of(context)->dimension();
    if (dimension == 1) throw InputError("a field needs a domain of dimension two or three");
    FieldGrid made = dimension == 3
                         ? solid_field(field, options, context)
                         : std::visit(
                               [&](const auto& data) {
                                   if constexpr (std::is_same_v<std::decay_t<decltype(data)>, GridData>)
                                       return grid_field(data, options, context);
                                   else
                                       return scattered_field(data, options, context);
                               },
                               field.data);
    made.notes.insert(made.notes.begin(), field.notes.begin(), field.notes.end());
    return made;
}

MadeFunction field_function(const FieldData& field, const FieldOptions& options, const DataContext& context) {
    FieldGrid made = field_grid(field, options, context);
    blur(made.grid, made.values, made.sigma, context.progress, context.stop);
    return {std::make_shared<GridFunction>(std::move(made.grid), made.values), std::move(made.notes), {}};
}

} // namespace gaspard
