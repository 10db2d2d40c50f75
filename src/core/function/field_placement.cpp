#include "core/function/field_placement.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

/// The part of [a, b] that lies in the other range, as a fraction of the latter.
double covered(const AxisRange& part, const AxisRange& whole) {
    const double common = std::min(part.high, whole.high) - std::max(part.low, whole.low);
    return whole.length() > 0 ? std::clamp(common / whole.length(), 0.0, 1.0) : 1;
}

/// The point of the grid that is nearest along a direction.
std::size_t nearest_index(const Grid& grid, std::size_t d, double s) {
    const auto count = static_cast<double>(grid.directions[d].count);
    double index = std::round((s - grid.coordinate(d, 0)) / grid.spacing(d));
    if (grid.directions[d].ends == GridEnds::periodic) index -= count * std::floor(index / count);
    return static_cast<std::size_t>(std::clamp(index, 0.0, count - 1));
}

/// How many nodes of the mesh (points of the grid if there is none) have no data, and how many there are.
std::pair<std::size_t, std::size_t> count_outside(const Grid& grid, const std::vector<char>& inside,
                                                  const DataContext& context) {
    const auto no = [](char one) { return one == 0; };
    const auto outside = static_cast<std::size_t>(std::count_if(inside.begin(), inside.end(), no));
    if (!context.discretisation || outside == 0) return {outside, inside.size()};
    Points s;
    const Points& nodes = context.discretisation->mesh()->nodes;
    grid.chart->coordinates(nodes, s);
    std::size_t count = 0;
    for (std::size_t p = 0; p < s.size(); ++p) {
        const std::array<double, 3> at{s.x[p], s.y[p], s.z[p]};
        std::size_t index = 0;
        for (std::size_t d = grid.directions.size(); d-- > 0;)
            index = index * grid.directions[d].count + nearest_index(grid, d, at[d]);
        count += inside[index] == 0 ? 1 : 0;
    }
    return {count, s.size()};
}

} // namespace

void check_stop(const DataContext& context, double done, std::string_view what) {
    if (context.stop.stop_requested()) throw Interrupted();
    if (context.progress) context.progress(done, what);
}

AxisMap between(double low, double high, double to_low, double to_high) {
    const double factor = high > low ? (to_high - to_low) / (high - low) : 1;
    return {factor, to_low - factor * low};
}

AxisRange range_of(const std::vector<double>& all) {
    const auto [low, high] = std::minmax_element(all.begin(), all.end());
    return {*low, *high};
}
AxisRange range_of(const Chart& chart, std::size_t d) {
    return {chart.direction(d).low, chart.direction(d).high};
}

bool by_coordinates(const std::vector<AxisRange>& data, Coordinates coordinates, const Chart& chart,
                    FieldPlacement wanted) {
    if (wanted != FieldPlacement::automatic) return wanted == FieldPlacement::coordinates;
    if (coordinates == Coordinates::none || chart.kind() == ChartKind::surface) return false;
    if (chart.kind() == ChartKind::sphere) return coordinates == Coordinates::geographic;
    double of_domain = 1, of_data = 1;
    for (std::size_t d = 0; d < chart.dimension(); ++d) {
        of_domain *= covered(data[d], range_of(chart, d));
        of_data *= covered(range_of(chart, d), data[d]);
    }
    return of_domain >= 0.5 && of_data >= 0.05;
}

void note_placement(bool placed, FieldPlacement wanted, const Chart& chart, std::vector<std::string>& notes) {
    if (placed || wanted != FieldPlacement::automatic) return;
    const std::string target = chart.kind() == ChartKind::sphere    ? "the whole sphere, as a map"
                               : chart.kind() == ChartKind::surface ? "the parameters of the surface"
                                                                    : "the box of the domain";
    notes.push_back("The data are fitted to " + target + ".");
}

void note_coverage(const Grid& grid, const std::vector<char>& inside, const FieldOptions& options,
                   const DataContext& context, std::vector<std::string>& notes) {
    const auto [outside, all] = count_outside(grid, inside, context);
    if (outside == 0) return;
    const double share = 100.0 * static_cast<double>(outside) / static_cast<double>(all);
    const auto percent = static_cast<int>(std::clamp(std::round(share), 1.0, 99.0));
    const std::string part = "The data do not cover " + std::to_string(percent) + " % of the domain";
    if (outside == all)
        throw InputError("the data lie outside of the domain; fit them to it (placement = fit)");
    if (options.missing == MissingValues::error)
        throw InputError(
            "the data do not cover " + std::to_string(percent) +
            " % of the domain; allow the nearest or the lowest value there (missing = nearest or floor)");
    notes.push_back(part + (options.missing == MissingValues::nearest ? "; the nearest values are used there."
                                                                      : "; the lowest value is used there."));
}

Grid sampling_grid(const std::shared_ptr<const Chart>& chart, const std::array<double, 2>& data_steps,
                   const ChartExtent& extent, double sigma, std::size_t most) {
    const std::array<double, 2> lengths = {extent.width, extent.height};
    std::array<std::size_t, 2> counts{};
    for (std::size_t d = 0; d < 2; ++d) {
        const double length = range_of(*chart, d).length();
        const double step = std::max(data_steps[d] / 2, sigma / 4 * length / lengths[d]);
        counts[d] = std::min(handy_count(length / step), most);
    }
    if (chart->kind() == ChartKind::sphere) ++counts[1];
    return grid_on(chart, {counts[0], counts[1]},
                   sigma > 0 ? GridEnds::reflecting : GridEnds::free); // as blur() needs
}

} // namespace gaspard
