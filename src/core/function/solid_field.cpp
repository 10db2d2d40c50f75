// Fields on solids: data with three coordinates on a grid of the box around the solid.
#include "core/base/error.hpp"
#include "core/function/chart_extent.hpp"
#include "core/function/field_placement.hpp"
#include "core/function/field_values.hpp"
#include "core/function/line_resampling.hpp"
#include "core/function/scattered_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

/// Points of the grid: of data on a grid, and of scattered ones, each of which takes a fit.
constexpr double most_sampled = 2e6, most_scattered = 4e5;

std::array<std::vector<double>*, 3> arrays_of(Points& points) { return {&points.x, &points.y, &points.z}; }

double length_along(const Chart& chart, std::size_t d) { return range_of(chart, d).length(); }

/// The grid for data with these steps: its steps are half of them, unless the blur makes that needless.
Grid solid_grid(const std::shared_ptr<const Chart>& chart, const std::array<double, 3>& data_steps,
                double sigma, double most) {
    std::array<double, 3> wanted{};
    double points = 1;
    for (std::size_t d = 0; d < 3; ++d) {
        wanted[d] = length_along(*chart, d) / std::max(data_steps[d] / 2, sigma / 4);
        points *= std::max(wanted[d], 32.0);
    }
    const double coarser = std::cbrt(std::max(points / most, 1.0));
    std::vector<std::size_t> counts;
    for (const double one : wanted) counts.push_back(handy_count(one / coarser));
    return grid_on(chart, counts, sigma > 0 ? GridEnds::reflecting : GridEnds::free); // as blur() needs
}

/// The cell size of the mesh and the blur.
FieldGrid measured_solid(const std::shared_ptr<const Chart>& chart, const FieldOptions& options,
                         const DataContext& context) {
    FieldGrid made;
    made.cell = cell_size(measure_of(chart, context), 3, context);
    made.sigma = options.blur * made.cell;
    return made;
}

double median_of_steps(const std::vector<double>& axis) {
    std::vector<double> steps(axis.size());
    std::adjacent_difference(axis.begin(), axis.end(), steps.begin());
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(1 + (steps.size() - 1) / 2);
    std::nth_element(steps.begin() + 1, middle, steps.end());
    return *middle;
}

/// An array of values with three directions, the first fastest.
struct Block {
    std::array<std::size_t, 3> counts{};
    std::vector<double> values;

    std::size_t stride(std::size_t d) const {
        return d == 0 ? 1 : d == 1 ? counts[0] : counts[0] * counts[1];
    }
};

/// The block with the lines along one direction resampled.
Block resampled(const Block& given, std::size_t d, const LineResampling& line, std::size_t count,
                const DataContext& context) {
    Block made{given.counts, {}};
    made.counts[d] = count;
    made.values.resize(made.counts[0] * made.counts[1] * made.counts[2]);
    const std::size_t from_stride = given.stride(d), to_stride = made.stride(d),
                      lines = given.values.size() / given.counts[d];
    std::vector<double> from(given.counts[d]), to(count);
    for (std::size_t number = 0; number < lines; ++number) {
        if (number % 4096 == 0)
            check_stop(context,
                       (static_cast<double>(d) + static_cast<double>(number) / static_cast<double>(lines)) /
                           3,
                       "Placing the field");
        // The strides of slower directions include this one.
        const std::size_t fast = number % from_stride, slow = number / from_stride;
        const std::size_t begin = slow * from_stride * given.counts[d] + fast,
                          target = slow * to_stride * count + fast;
        for (std::size_t i = 0; i < from.size(); ++i) from[i] = given.values[begin + i * from_stride];
        line.apply(from, to);
        for (std::size_t i = 0; i < count; ++i) made.values[target + i * to_stride] = to[i];
    }
    return made;
}

FieldGrid from_grid(GridData data, const FieldOptions& options, const DataContext& context) {
    std::vector<std::string> notes;
    prepare_values(data, options, notes);
    const auto chart = chart_of(context);
    const bool placed =
        by_coordinates({range_of(data.axes[0]), range_of(data.axes[1]), range_of(data.axes[2])},
                       data.coordinates, *chart, options.placement);
    std::array<double, 3> data_steps{};
    for (std::size_t d = 0; d < 3; ++d) {
        const AxisRange from = range_of(data.axes[d]), to = range_of(*chart, d);
        const AxisMap map = placed ? AxisMap{} : between(from.low, from.high, to.low, to.high);
        for (double& one : data.axes[d]) one = map(one);
        data_steps[d] = median_of_steps(data.axes[d]);
    }
    note_placement(placed, options.placement, *chart, notes);
    FieldGrid made = measured_solid(chart, options, context);
    made.grid = solid_grid(chart, data_steps, made.sigma, most_sampled);
    const double low = range_of(data.values).low;
    Block block{{data.count(0), data.count(1), data.count(2)}, std::move(data.values)};
    std::vector<LineResampling> lines;
    for (std::size_t d = 0; d < 3; ++d) {
        const std::size_t count = made.grid.directions[d].count;
        lines.emplace_back(data.axes[d], made.grid.coordinate(d, 0), made.grid.spacing(d), count,
                           std::nullopt);
        block = resampled(block, d, lines[d], count, context);
    }
    std::vector<char> inside(block.values.size());
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const std::size_t nx = block.counts[0], ny = block.counts[1];
        inside[i] = lines[0].covers(i % nx) && lines[1].covers(i / nx % ny) && lines[2].covers(i / nx / ny);
        if (inside[i] == 0 && options.missing == MissingValues::lowest) block.values[i] = low;
    }
    made.values = std::move(block.values);
    made.notes = std::move(notes);
    note_coverage(made.grid, inside, options, context, made.notes);
    return made;
}

/// Throws InputError if all points lie in a plane: else nothing tells how the field varies beside it.
void check_volume(const Points& points) {
    const auto farthest = [&](const auto& distance) {
        std::size_t found = 0;
        for (std::size_t p = 1; p < points.size(); ++p)
            if (distance(points[p]) > distance(points[found])) found = p;
        return points[found];
    };
    const Vec3 begin = points[0], first = farthest([&](Vec3 x) { return norm(x - begin); }) - begin;
    const auto beside = [&](Vec3 x) { return norm(cross(x - begin, first)); };
    const Vec3 normal = cross(first, farthest(beside) - begin);
    const auto off = [&](Vec3 x) { return std::abs(dot(x - begin, normal)); };
    if (!(off(farthest(off)) > 1e-9 * norm(normal) * norm(first)))
        throw InputError("all points of the field lie in a plane, so that it is not known beside it; a "
                         "solid needs values all over it");
}

FieldGrid from_points(ScatteredData data, const FieldOptions& options, const DataContext& context) {
    std::vector<std::string> notes;
    prepare_values(data, options, notes);
    const auto chart = chart_of(context);
    const bool placed =
        by_coordinates({range_of(data.points.x), range_of(data.points.y), range_of(data.points.z)},
                       data.coordinates, *chart, options.placement);
    for (std::size_t d = 0; !placed && d < 3; ++d) {
        std::vector<double>& all = *arrays_of(data.points)[d];
        const AxisRange from = range_of(all), to = range_of(*chart, d);
        const AxisMap map = between(from.low, from.high, to.low, to.high);
        for (double& one : all) one = map(one);
    }
    note_placement(placed, options.placement, *chart, notes);
    if (const std::size_t merged = merge_coincident(data.points, data.values, context.stop))
        notes.push_back(coincidence_note(merged));
    check_volume(data.points);
    const double low = range_of(data.values).low;
    const std::size_t count = data.values.size();
    const ScatteredFit fit(std::move(data.points), std::move(data.values), 3);
    const double spacing = fit.spacing();
    FieldGrid made = measured_solid(chart, options, context);
    made.grid = solid_grid(chart, {spacing, spacing, spacing}, made.sigma, most_scattered);
    const Points targets = made.grid.coordinates();
    made.values.resize(targets.size());
    std::vector<char> inside(targets.size());
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (i % 4096 == 0)
            check_stop(context, static_cast<double>(i) / static_cast<double>(targets.size()),
                       "Fitting the field");
        const auto [value, distance] = fit.at(targets[i]);
        inside[i] = distance <= 3 * spacing ? 1 : 0;
        made.values[i] = inside[i] != 0 || options.missing != MissingValues::lowest ? value : low;
    }
    notes.push_back("The field is a moving least-squares fit of " + std::to_string(count) +
                    " points (linear, Gaussian weights, " + std::to_string(ScatteredFit::neighbours) +
                    " neighbours).");
    made.notes = std::move(notes);
    note_coverage(made.grid, inside, options, context, made.notes);
    return made;
}

} // namespace

FieldGrid solid_field(const FieldData& field, const FieldOptions& options, const DataContext& context) {
    const auto* grid = std::get_if<GridData>(&field.data);
    const auto* points = std::get_if<ScatteredData>(&field.data);
    if (grid ? grid->dimension() != 3 : points->dimension != 3)
        throw InputError("'" + field.variable +
                         "' has values in two directions only; a solid needs a field in x, y and z");
    return grid ? from_grid(*grid, options, context) : from_points(*points, options, context);
}

} // namespace gaspard
