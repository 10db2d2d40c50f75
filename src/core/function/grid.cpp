#include "core/function/grid.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

/// Numbers from points of the first direction to those of the last, for every point of a grid.
template <class Visit>
void for_each_point(const Grid& grid, const Visit& visit) {
    std::array<std::size_t, 3> counts{1, 1, 1}, at{};
    for (std::size_t d = 0; d < grid.directions.size(); ++d) counts[d] = grid.directions[d].count;
    std::size_t i = 0;
    for (at[2] = 0; at[2] < counts[2]; ++at[2])
        for (at[1] = 0; at[1] < counts[1]; ++at[1])
            for (at[0] = 0; at[0] < counts[0]; ++at[0]) visit(i++, at);
}

/// The step that the point stands for: half a step where a direction ends at a point.
double share(const GridDirection& direction, double spacing, std::size_t i) {
    const bool end = i == 0 || i + 1 == direction.count;
    const bool halved = end && !direction.centred && direction.ends != GridEnds::periodic;
    return halved && direction.count > 1 ? spacing / 2 : spacing;
}

} // namespace

std::size_t Grid::size() const {
    std::size_t size = 1;
    for (const GridDirection& direction : directions) size *= direction.count;
    return size;
}

double Grid::spacing(std::size_t d) const {
    const GridDirection& direction = directions[d];
    const double length = chart->direction(d).high - chart->direction(d).low;
    const bool by_points = direction.centred || direction.ends == GridEnds::periodic;
    const std::size_t steps = by_points ? direction.count : direction.count - 1;
    return length / static_cast<double>(std::max<std::size_t>(steps, 1));
}

double Grid::coordinate(std::size_t d, std::size_t i) const {
    return chart->direction(d).low +
           (static_cast<double>(i) + (directions[d].centred ? 0.5 : 0.0)) * spacing(d);
}

Points Grid::coordinates() const {
    Points s(size());
    for_each_point(*this, [&](std::size_t i, const std::array<std::size_t, 3>& at) {
        std::array<double, 3> own{};
        for (std::size_t d = 0; d < directions.size(); ++d) own[d] = coordinate(d, at[d]);
        s.set(i, {own[0], own[1], own[2]});
    });
    return s;
}

Grid grid_on(std::shared_ptr<const Chart> chart, std::vector<std::size_t> counts, GridEnds open_ends) {
    GASPARD_CHECK(counts.size() == chart->dimension());
    Grid grid{std::move(chart), {}};
    for (std::size_t d = 0; d < counts.size(); ++d) {
        GridDirection direction{std::max<std::size_t>(counts[d], 1)};
        switch (grid.chart->direction(d).ends) {
        case ChartEnds::open:
            direction.ends = open_ends;
            direction.centred = open_ends == GridEnds::reflecting;
            break;
        case ChartEnds::periodic:
            direction.ends = GridEnds::periodic;
            break;
        case ChartEnds::poles:
            direction.ends = GridEnds::poles;
            direction.count = std::max<std::size_t>(direction.count, 3);
            break;
        }
        grid.directions.push_back(direction);
    }
    if (grid.chart->kind() == ChartKind::sphere) {
        auto& longitudes = grid.directions[0].count;
        longitudes = std::max<std::size_t>(longitudes + longitudes % 2, 4);
    }
    return grid;
}

std::vector<double> measures(const Grid& grid) {
    std::vector<double> result(grid.size());
    std::array<double, 3> spacing{};
    for (std::size_t d = 0; d < grid.directions.size(); ++d) spacing[d] = grid.spacing(d);
    for_each_point(grid, [&](std::size_t i, const std::array<std::size_t, 3>& at) {
        result[i] = 1;
        for (std::size_t d = 0; d < grid.directions.size(); ++d)
            result[i] *= share(grid.directions[d], spacing[d], at[d]);
    });
    if (grid.chart->kind() == ChartKind::box) return result;
    std::array<Points, 3> t;
    grid.chart->tangents(grid.coordinates(), t);
    if (grid.chart->kind() == ChartKind::surface) {
        for (std::size_t i = 0; i < result.size(); ++i) result[i] *= norm(cross(t[0][i], t[1][i]));
        return result;
    }
    // The sphere: areas of bands between parallels, exactly.
    constexpr double degree = std::numbers::pi / 180;
    const std::size_t longitudes = grid.directions[0].count, latitudes = grid.directions[1].count;
    const double length = norm(t[1][0]); // of a degree
    for (std::size_t j = 0; j < latitudes; ++j) {
        const double latitude = grid.coordinate(1, j), half = spacing[1] / 2;
        const double band = std::sin(std::min(latitude + half, 90.0) * degree) -
                            std::sin(std::max(latitude - half, -90.0) * degree);
        const double area = length * length / degree * band * spacing[0];
        std::fill_n(result.begin() + static_cast<std::ptrdiff_t>(j * longitudes), longitudes, area);
    }
    return result;
}

} // namespace gaspard
