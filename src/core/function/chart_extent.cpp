#include "core/function/chart_extent.hpp"

#include "core/base/parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gaspard {

ChartExtent extent_of(const std::shared_ptr<const Chart>& shared, const DataContext& context) {
    const Chart& chart = *shared;
    ChartExtent extent{};
    const auto length = [&](std::size_t d) { return chart.direction(d).high - chart.direction(d).low; };
    if (chart.kind() == ChartKind::surface) {
        const Grid grid = grid_on(shared, {33, 33}, GridEnds::reflecting);
        std::array<Points, 3> t;
        chart.tangents(grid.coordinates(), t);
        for (std::size_t i = 0; i < grid.size(); ++i)
            extent.width += norm(t[0][i]), extent.height += norm(t[1][i]);
        extent.width /= static_cast<double>(grid.size()), extent.height /= static_cast<double>(grid.size());
        const std::vector<double> areas = measures(grid);
        extent.area = std::accumulate(areas.begin(), areas.end(), 0.0);
    } else if (chart.kind() == ChartKind::sphere) {
        std::array<Points, 3> t;
        chart.tangents(Points(1), t);
        extent.height = norm(t[1][0]) * 180, extent.width = 2 * extent.height;
        extent.area = extent.width * extent.width / std::numbers::pi;
    } else {
        extent.width = length(0), extent.height = length(1), extent.area = extent.width * extent.height;
    }
    double cells = 60 * 60; // of a mesh that is not there
    if (context.discretisation) {
        const auto mesh = context.discretisation->mesh();
        cells = static_cast<double>(mesh->cell_count());
        if (mesh->kind.shape == CellShape::triangle) cells /= 2;
    }
    extent.cell = std::sqrt(extent.area / cells);
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
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    const double digits = std::round(value / unit);
    return format_number(unit < 1 ? digits / std::round(1 / unit) : digits * unit);
}

} // namespace gaspard
