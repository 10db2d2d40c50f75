#include "core/function/chart_extent.hpp"

#include "core/base/parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gaspard {

namespace {

double length(const Chart& chart, std::size_t d) { return chart.direction(d).high - chart.direction(d).low; }

/// The area of a planar patch, which does not fill its box, by the midpoint rule.
double area_of(const PatchParameters& patch) {
    constexpr int count = 64;
    Points uv(count * count), first, second;
    for (int i = 0; i < count * count; ++i)
        uv.set(static_cast<std::size_t>(i), {(i % count + 0.5) / count, (i / count + 0.5) / count, 0});
    patch.tangents(uv, first, second);
    double area = 0;
    for (std::size_t i = 0; i < uv.size(); ++i) area += norm(cross(first[i], second[i]));
    return area / (count * count);
}

} // namespace

double measure_of(const std::shared_ptr<const Chart>& chart, const DataContext& context) {
    if (chart->kind() == ChartKind::surface) {
        const std::vector<double> areas = measures(grid_on(chart, {33, 33}, GridEnds::reflecting));
        return std::accumulate(areas.begin(), areas.end(), 0.0);
    }
    if (chart->kind() == ChartKind::sphere) {
        std::array<Points, 3> t;
        chart->tangents(Points(1), t);
        const double degree = norm(t[1][0]);
        return 360 * 360 * degree * degree / std::numbers::pi;
    }
    const auto patch = context.discretisation ? context.discretisation->parameters() : nullptr;
    if (patch) return area_of(*patch);
    if (const auto solid = context.discretisation ? context.discretisation->solid_shape() : nullptr)
        return solid->volume();
    double measure = 1;
    for (std::size_t d = 0; d < chart->dimension(); ++d) measure *= length(*chart, d);
    return measure;
}

double cell_size(double measure, std::size_t dimension, const DataContext& context) {
    const double power = 1 / static_cast<double>(dimension);
    if (!context.discretisation) return std::pow(measure, power) / 60;
    const auto mesh = context.discretisation->mesh();
    const double cells = static_cast<double>(mesh->cell_count());
    const bool halves = mesh->kind.shape == CellShape::triangle;
    return std::pow(measure / (halves ? cells / 2 : cells), power);
}

ChartExtent extent_of(const std::shared_ptr<const Chart>& shared, const DataContext& context) {
    const Chart& chart = *shared;
    ChartExtent extent{};
    if (chart.kind() == ChartKind::surface) {
        const Grid grid = grid_on(shared, {33, 33}, GridEnds::reflecting);
        std::array<Points, 3> t;
        chart.tangents(grid.coordinates(), t);
        for (std::size_t i = 0; i < grid.size(); ++i)
            extent.width += norm(t[0][i]), extent.height += norm(t[1][i]);
        extent.width /= static_cast<double>(grid.size()), extent.height /= static_cast<double>(grid.size());
    } else if (chart.kind() == ChartKind::sphere) {
        std::array<Points, 3> t;
        chart.tangents(Points(1), t);
        extent.height = norm(t[1][0]) * 180, extent.width = 2 * extent.height;
    } else {
        extent.width = length(chart, 0), extent.height = length(chart, 1);
    }
    extent.cell = cell_size(measure_of(shared, context), 2, context);
    return extent;
}

std::size_t handy_count(double wanted) {
    auto count = static_cast<std::size_t>(std::clamp(std::ceil(wanted), 32.0, 2048.0));
    const auto handy = [](std::size_t n) {
        for (const std::size_t factor : {2, 3, 5})
            while (n % factor == 0) n /= factor;
        return n == 1;
    };
    while (count % 2 != 0 || !handy(count)) ++count;
    return count;
}

std::string rounded(double value) {
    if (!(value > 0)) return "0";
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    const double digits = std::round(value / unit);
    return format_number(unit < 1 ? digits / std::round(1 / unit) : digits * unit);
}

std::string in_cells(double value) {
    const std::string number = rounded(value);
    return number + (number == "1" ? " cell" : " cells");
}

} // namespace gaspard
