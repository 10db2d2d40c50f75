#include "core/monitor/domain_grid.hpp"

#include "core/function/chart_extent.hpp"
#include "core/function/grid_function.hpp"
#include "core/monitor/own_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace gaspard {

namespace {

constexpr double most_points = 6e5;
constexpr std::size_t least_count = 32, most_count = 4096; ///< of points along a direction

/// Grids in powers of 2, 3 and 5 have fast Fourier transforms.
std::size_t fast_count(double wanted) {
    const auto least =
        static_cast<std::size_t>(std::clamp(std::ceil(wanted), double(least_count), double(most_count)));
    const auto is_fast = [](std::size_t n) {
        for (const std::size_t prime : {2U, 3U, 5U})
            while (n % prime == 0) n /= prime;
        return n == 1;
    };
    std::size_t count = least;
    while (!is_fast(count) || count % 2 != 0) ++count;
    return count;
}

/// Lengths of the chart's directions; for surfaces of the longest of some lines.
std::array<double, 3> lengths_of(const Chart& chart) {
    constexpr int samples = 9;
    std::array<double, 3> lengths{};
    Points s(samples * samples);
    const auto at = [&](std::size_t d, int i) {
        const ChartDirection& own = chart.direction(d);
        return own.low + (own.high - own.low) * (i + 0.5) / samples;
    };
    for (std::size_t i = 0; i < s.size(); ++i) {
        Vec3 p{at(0, static_cast<int>(i) % samples), 0, 0};
        if (chart.dimension() > 1) p.y = at(1, static_cast<int>(i) / samples);
        if (chart.dimension() > 2) p.z = at(2, samples / 2);
        s.set(i, p);
    }
    std::array<Points, 3> tangents;
    chart.tangents(s, tangents);
    for (std::size_t d = 0; d < chart.dimension(); ++d) {
        double longest = 0;
        for (std::size_t i = 0; i < s.size(); ++i) longest = std::max(longest, norm(tangents[d][i]));
        lengths[d] = longest * (chart.direction(d).high - chart.direction(d).low);
    }
    return lengths;
}

/// The nearest points of a planar patch.
Points nearest_on(const PatchParameters& parameters, const Points& x) {
    Points uv, nearest;
    parameters.find(x, uv);
    for (std::size_t i = 0; i < uv.size(); ++i)
        uv.set(i, {std::clamp(uv.x[i], 0.0, 1.0), std::clamp(uv.y[i], 0.0, 1.0), 0});
    parameters.points(uv, nearest);
    return nearest;
}

/// Puts the points beside a planar patch or a solid at its nearest points, and takes their measure.
void keep_to(DomainGrid& domain, const Points& nearest) {
    const double close = 1e-6 * domain.size;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        if (norm(nearest[i] - domain.x[i]) <= close) continue;
        domain.x.set(i, nearest[i]), domain.s.set(i, nearest[i]);
        domain.measures[i] = 0;
    }
}

} // namespace

double DomainGrid::mean(std::span<const double> values) const {
    double sum = 0, whole = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += measures[i] * values[i], whole += measures[i];
    return sum / whole;
}

double DomainGrid::least(std::span<const double> values) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < values.size(); ++i)
        if (measures[i] > 0) least = std::min(least, values[i]);
    return least;
}

double DomainGrid::largest(std::span<const double> values) const {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < values.size(); ++i)
        if (measures[i] > 0) largest = std::max(largest, values[i]);
    return largest;
}

void go_on_beside(const DomainGrid& domain, std::vector<double>& values) {
    if (!domain.patch) return;
    std::vector<double> nearest(values.size());
    GridFunction(domain.grid, values).values(domain.x, nearest);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(domain.measures[i] > 0)) values[i] = nearest[i];
}

DomainGrid domain_on(Grid grid, const DataContext& context) {
    const Chart& chart = *grid.chart;
    DomainGrid domain{.grid = std::move(grid)};
    const std::size_t dimension = chart.dimension();
    domain.cell = cell_size(measure_of(domain.grid.chart, context), dimension, context);
    if (context.discretisation) {
        domain.size = extent_of(*context.discretisation->mesh(), context.space, false).size;
    } else if (chart.kind() != ChartKind::sphere) {
        const auto lengths = lengths_of(chart);
        domain.size = *std::max_element(lengths.begin(), lengths.end());
    }
    domain.s = domain.grid.coordinates();
    domain.measures = measures(domain.grid);
    chart.points(domain.s, domain.x);
    const auto parameters = context.discretisation ? context.discretisation->parameters() : nullptr;
    const auto solid = context.discretisation ? context.discretisation->solid_shape() : nullptr;
    domain.patch = chart.kind() == ChartKind::box && (parameters || (solid && !solid->is_box()));
    if (domain.patch && parameters) keep_to(domain, nearest_on(*parameters, domain.x));
    if (domain.patch && solid) {
        Points nearest;
        solid->nearest(domain.x, nearest);
        keep_to(domain, nearest);
    }
    return domain;
}

DomainGrid domain_grid(const DataContext& context, double per_cell) {
    const auto chart = chart_of(context);
    const auto lengths = lengths_of(*chart);
    const std::size_t dimension = chart->dimension();
    double spacing = cell_size(measure_of(chart, context), dimension, context) / per_cell, points = 1;
    for (std::size_t d = 0; d < dimension; ++d) points *= std::max(1.0, lengths[d] / spacing);
    if (points > most_points) spacing *= std::pow(points / most_points, 1 / static_cast<double>(dimension));
    std::vector<std::size_t> counts(dimension);
    for (std::size_t d = 0; d < dimension;
         ++d) { // of open ends the Fourier transforms have 2 (count - 1) points
        const bool open = chart->direction(d).ends == ChartEnds::open;
        counts[d] = fast_count(lengths[d] / spacing) + (open ? 1 : 0);
    }
    return domain_on(grid_on(chart, counts), context);
}

} // namespace gaspard
