#include "core/data/field_data.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/parameter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gaspard {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The different coordinates in increasing order.
std::vector<double> different(std::vector<double> all) {
    std::sort(all.begin(), all.end());
    const double tolerance = 1e-9 * (all.back() - all.front());
    std::vector<double> found;
    for (const double one : all)
        if (found.empty() || one - found.back() > tolerance) found.push_back(one);
    return found;
}

std::size_t nearest_index(const std::vector<double>& axis, double at) {
    const auto above =
        static_cast<std::size_t>(std::lower_bound(axis.begin(), axis.end(), at) - axis.begin());
    if (above == 0) return 0;
    if (above == axis.size()) return above - 1;
    return at - axis[above - 1] <= axis[above] - at ? above - 1 : above;
}

std::vector<std::size_t> order_of(const std::vector<double>& axis) {
    std::vector<std::size_t> order(axis.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return axis[a] < axis[b]; });
    return order;
}

void check_axis(const std::vector<double>& axis) {
    for (const double at : axis)
        if (!std::isfinite(at)) throw InputError("a coordinate of the grid is missing or not finite");
}

std::string shortened_list(const std::vector<std::string>& names) {
    constexpr std::size_t most = 20;
    if (names.size() <= most) return join(names, ", ");
    return join(std::vector<std::string>(names.begin(), names.begin() + most), ", ") + ", ...";
}

} // namespace

std::size_t count_missing(const std::vector<double>& values) {
    return static_cast<std::size_t>(
        std::count_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }));
}

const std::vector<double>& values_of(const FieldData& field) {
    return std::visit([](const auto& data) -> const std::vector<double>& { return data.values; }, field.data);
}

std::optional<GridData> as_grid(const ScatteredData& data) {
    if (data.dimension != 2 || data.values.size() < 4) return std::nullopt;
    GridData grid{data.coordinates, {different(data.points.x), different(data.points.y)}, {}};
    const std::size_t nx = grid.axes[0].size(), ny = grid.axes[1].size();
    if (nx < 2 || ny < 2 || nx > data.values.size() / ny || nx * ny != data.values.size())
        return std::nullopt;
    grid.values.assign(nx * ny, nothing);
    std::vector<char> taken(nx * ny, 0);
    for (std::size_t p = 0; p < data.values.size(); ++p) {
        const std::size_t i = nearest_index(grid.axes[0], data.points.x[p]);
        const std::size_t at = nearest_index(grid.axes[1], data.points.y[p]) * nx + i;
        if (taken[at] != 0) return std::nullopt;
        taken[at] = 1;
        grid.values[at] = data.values[p];
    }
    return grid;
}

GridData with_sorted_axes(GridData grid) {
    const auto increasing = [](const std::vector<double>& axis) {
        return std::adjacent_find(axis.begin(), axis.end(), std::greater_equal<>()) == axis.end();
    };
    check_axis(grid.axes[0]), check_axis(grid.axes[1]);
    if (increasing(grid.axes[0]) && increasing(grid.axes[1])) return grid;
    const auto columns = order_of(grid.axes[0]), rows = order_of(grid.axes[1]);
    GridData sorted{grid.coordinates, {}, {}};
    for (const std::size_t i : columns) sorted.axes[0].push_back(grid.axes[0][i]);
    for (const std::size_t j : rows) sorted.axes[1].push_back(grid.axes[1][j]);
    for (const auto& axis : sorted.axes) {
        const auto twice = std::adjacent_find(axis.begin(), axis.end());
        if (twice != axis.end())
            throw InputError("the coordinate " + format_number(*twice) + " of the grid appears twice");
    }
    sorted.values.reserve(grid.values.size());
    for (const std::size_t j : rows)
        for (const std::size_t i : columns) sorted.values.push_back(grid.values[j * columns.size() + i]);
    return sorted;
}

std::size_t find_variable(std::string_view variable, const std::vector<std::string>& names) {
    if (variable.empty() && !names.empty()) return 0;
    const auto found = std::find(names.begin(), names.end(), variable);
    if (found == names.end())
        throw InputError("it has no variable '" + std::string(variable.substr(0, 100)) + "'" +
                         did_you_mean(variable, names) + "; it has " + shortened_list(names));
    return static_cast<std::size_t>(found - names.begin());
}

std::size_t find_index(std::int64_t index, std::size_t count, std::string_view what) {
    if (index == -1 && count > 0) return count - 1;
    if (index >= 0 && static_cast<std::uint64_t>(index) < count) return static_cast<std::size_t>(index);
    const std::string name(what);
    if (count < 2)
        throw InputError("there is no " + name + " " + std::to_string(index) + "; it has only one");
    throw InputError("there is no " + name + " " + std::to_string(index) + "; it has 0 to " +
                     std::to_string(count - 1) + " (-1 is the last)");
}

} // namespace gaspard
