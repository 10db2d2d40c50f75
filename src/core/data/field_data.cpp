#include "core/data/field_data.hpp"

#include "core/base/error.hpp"
#include "core/base/join.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace gaspard {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

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

bool all_finite(const std::vector<double>& all) {
    return std::all_of(all.begin(), all.end(), [](double one) { return std::isfinite(one); });
}

/// Throws Interrupted from the comparisons of a long sort.
class StopCheck {
  public:
    explicit StopCheck(const std::stop_token& stop) : stop_(&stop) {}
    void operator()() {
        if (++calls_ % 65'536 == 0 && stop_->stop_requested()) throw Interrupted();
    }

  private:
    const std::stop_token* stop_;
    std::size_t calls_ = 0;
};

/// Cells so small that points of one count as the same. A cell begins beside round numbers, so that what
/// rounding has moved away from one stays in its cell.
class FineCells {
  public:
    explicit FineCells(const Points& points) : points_(&points) {
        const std::array<const std::vector<double>*, 3> all = {&points.x, &points.y, &points.z};
        std::array<double, 3> extents{};
        double largest = 0; // coordinates are rounded by a fraction of it, where they come from angles
        for (std::size_t d = 0; d < 3; ++d) {
            const auto [low, high] = std::minmax_element(all[d]->begin(), all[d]->end());
            extents[d] = *high - *low, largest = std::max({largest, std::abs(*low), std::abs(*high)});
        }
        for (std::size_t d = 0; d < 3; ++d) {
            const double side = std::max(1e-9 * extents[d], 1e-15 * largest);
            inverse_[d] = side > 0 ? 1 / side : 0;
        }
    }
    std::array<double, 3> operator()(std::uint32_t p) const {
        const Vec3 x = (*points_)[p];
        return {cell(x.x, 0), cell(x.y, 1), cell(x.z, 2)};
    }

  private:
    double cell(double at, std::size_t d) const { return std::floor(at * inverse_[d] + 0.37); }

    const Points* points_;
    std::array<double, 3> inverse_{}; ///< of the sides of a cell
};

/// The mean of those that are present; NaN if none is.
double mean_of(const std::vector<double>& values, std::span<const std::uint32_t> which) {
    const auto present =
        std::count_if(which.begin(), which.end(), [&](std::uint32_t p) { return std::isfinite(values[p]); });
    double mean = present == 0 ? no_value : 0;
    for (const std::uint32_t p : which)
        if (std::isfinite(values[p])) mean += values[p] / static_cast<double>(present);
    return mean;
}

std::string shortened_list(const std::vector<std::string>& names) {
    constexpr std::size_t most = 20;
    if (names.size() <= most) return join(names, ", ");
    return join(std::vector<std::string>(names.begin(), names.begin() + most), ", ") + ", ...";
}

} // namespace

void check_stop(const FieldRequest& request, double done) {
    if (request.stop.stop_requested()) throw Interrupted();
    if (request.progress) request.progress(done);
}

std::size_t count_missing(const std::vector<double>& values) {
    return static_cast<std::size_t>(
        std::count_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }));
}

const std::vector<double>& values_of(const FieldData& field) {
    return std::visit([](const auto& data) -> const std::vector<double>& { return data.values; }, field.data);
}

std::size_t merge_coincident(Points& points, std::vector<double>& values, const std::stop_token& stop) {
    if (!all_finite(points.x) || !all_finite(points.y) || !all_finite(points.z) || values.empty()) return 0;
    const FineCells cell_of(points);
    std::vector<std::uint32_t> order(values.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&, check = StopCheck(stop)](auto a, auto b) mutable {
        check();
        const auto of_a = cell_of(a), of_b = cell_of(b);
        return of_a != of_b ? of_a < of_b : a < b;
    });
    std::vector<char> removed(values.size(), 0);
    for (std::size_t begin = 0, end = 1; begin < order.size(); begin = end++) {
        const auto cell = cell_of(order[begin]);
        while (end < order.size() && cell_of(order[end]) == cell) removed[order[end++]] = 1;
        if (end - begin > 1)
            values[order[begin]] = mean_of(values, std::span(order).subspan(begin, end - begin));
    }
    std::size_t kept = 0;
    for (std::size_t p = 0; p < values.size(); ++p)
        if (removed[p] == 0) points.set(kept, points[p]), values[kept++] = values[p];
    const std::size_t merged = values.size() - kept;
    points.resize(kept), values.resize(kept);
    return merged;
}

std::string coincidence_note(std::size_t merged) {
    return (merged == 1 ? std::string("One point coincides with another")
                        : std::to_string(merged) + " points coincide with others") +
           "; the means of the values at such points are used.";
}

std::variant<GridData, ScatteredData> arranged(ScatteredData data, std::vector<std::string>& notes,
                                               const FieldRequest& request) {
    if (const std::size_t merged = merge_coincident(data.points, data.values, request.stop))
        notes.push_back(coincidence_note(merged));
    if (static_cast<std::size_t>(data.dimension) > request.dimension) return data;
    if (auto grid = as_grid(data)) return std::move(*grid);
    return data;
}

std::optional<GridData> as_grid(const ScatteredData& data) {
    const std::array<const std::vector<double>*, 3> coordinates{&data.points.x, &data.points.y,
                                                                &data.points.z};
    const auto dimension = static_cast<std::size_t>(data.dimension);
    if (data.values.size() < 4) return std::nullopt;
    GridData grid{data.coordinates, {}, {}};
    std::size_t points = 1;
    for (std::size_t d = 0; d < dimension; ++d) {
        if (!all_finite(*coordinates[d])) return std::nullopt;
        grid.axes[d] = different(*coordinates[d]);
        const std::size_t count = grid.axes[d].size();
        if (count < 2 || count > data.values.size() / points) return std::nullopt;
        points *= count;
    }
    if (points != data.values.size()) return std::nullopt;
    grid.values.assign(points, no_value);
    std::vector<char> taken(points, 0);
    for (std::size_t p = 0; p < points; ++p) {
        std::size_t at = 0;
        for (std::size_t d = dimension; d-- > 0;)
            at = at * grid.count(d) + nearest_index(grid.axes[d], (*coordinates[d])[p]);
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
    for (const auto& axis : grid.axes) check_axis(axis);
    if (std::all_of(grid.axes.begin(), grid.axes.end(), increasing)) return grid;
    std::array<std::vector<std::size_t>, 3> orders;
    GridData sorted{grid.coordinates, {}, {}};
    for (std::size_t d = 0; d < 3; ++d) {
        orders[d] = order_of(grid.axes[d]);
        for (const std::size_t i : orders[d]) sorted.axes[d].push_back(grid.axes[d][i]);
        if (orders[d].empty()) orders[d] = {0};
    }
    for (const auto& axis : sorted.axes) {
        const auto twice = std::adjacent_find(axis.begin(), axis.end());
        if (twice != axis.end())
            throw InputError("the coordinate " + exact_number(*twice) + " of the grid appears twice");
    }
    sorted.values.reserve(grid.values.size());
    for (const std::size_t k : orders[2])
        for (const std::size_t j : orders[1])
            for (const std::size_t i : orders[0])
                sorted.values.push_back(grid.values[(k * grid.count(1) + j) * grid.count(0) + i]);
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

std::size_t find_time(const FieldRequest& request, std::size_t count) {
    const bool after = !request.time_ends && count > 0 && request.time >= 0 &&
                       static_cast<std::uint64_t>(request.time) >= count;
    return after ? count - 1 : find_index(request.time, count, "time");
}

FieldData interpolated(FieldData a, const FieldData& b, double weight) {
    const auto same_points = [&] {
        if (a.data.index() != b.data.index()) return false;
        if (const auto* grid = std::get_if<GridData>(&a.data))
            return grid->axes == std::get<GridData>(b.data).axes;
        return std::get<ScatteredData>(a.data).points == std::get<ScatteredData>(b.data).points;
    };
    if (!same_points())
        throw InputError("the points of '" + a.variable +
                         "' differ from one time step to the next, so that "
                         "there are no values between them");
    const std::vector<double>& next = values_of(b);
    std::visit(
        [&](auto& data) {
            for (std::size_t i = 0; i < data.values.size(); ++i)
                data.values[i] = (1 - weight) * data.values[i] + weight * next[i];
        },
        a.data);
    return a;
}

} // namespace gaspard
