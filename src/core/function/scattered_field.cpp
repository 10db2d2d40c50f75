// Scattered points on a domain: where they lie, and the fit at the points of the chart's grid.
#include "core/base/box.hpp"
#include "core/base/error.hpp"
#include "core/function/field_placement.hpp"
#include "core/function/field_values.hpp"
#include "core/function/scattered_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t most_fitted = 648; // points of the grid along each direction

/// Points in the coordinates in which they are fitted.
struct Cloud {
    Points points;
    std::vector<double> values;
    int dimension = 2;
    bool in_chart = false; ///< these are the chart's coordinates; else those of the domain
};

void fit_coordinate(std::vector<double>& all, const AxisRange& to) {
    const AxisRange from = range_of(all);
    const AxisMap map = between(from.low, from.high, to.low, to.high);
    for (double& one : all) one = map(one);
}

/// The points in their directions from the centre of the sphere.
Cloud on_sphere(ScatteredData data, double radius) {
    Cloud cloud{{}, {}, 3, false};
    for (std::size_t p = 0; p < data.values.size(); ++p) {
        Vec3 x = data.points[p];
        if (data.dimension == 2) x = at_latitude_longitude(x.y, x.x);
        const double length = norm(x);
        if (!(length > 0)) continue; // no direction
        x = (radius / length) * x;
        cloud.points.x.push_back(x.x), cloud.points.y.push_back(x.y), cloud.points.z.push_back(x.z);
        cloud.values.push_back(data.values[p]);
    }
    if (cloud.values.empty()) throw InputError("all points lie at the centre of the sphere");
    return cloud;
}

/// Moves the points to the period that begins at the chart's low end.
void to_first_period(Points& points, const Chart& chart) {
    for (std::size_t d = 0; d < 2; ++d) {
        if (chart.direction(d).ends != ChartEnds::periodic) continue;
        const AxisRange box = range_of(chart, d);
        const double rounding = 1e-9 * box.length(); // the end of a period is its beginning
        for (double& one : d == 0 ? points.x : points.y) {
            one -= box.length() * std::floor((one - box.low) / box.length());
            if (one > box.low + box.length() - rounding) one = box.low;
        }
    }
}

/// Adds images of the points near the ends of a period.
void add_images(Cloud& cloud, const Chart& chart) {
    const double reach = std::clamp(6 / std::sqrt(static_cast<double>(cloud.values.size())), 0.02, 1.0);
    for (std::size_t d = 0; d < 2; ++d) {
        if (chart.direction(d).ends != ChartEnds::periodic) continue;
        const AxisRange box = range_of(chart, d);
        const double margin = reach * box.length();
        const std::vector<double>& own = d == 0 ? cloud.points.x : cloud.points.y;
        for (std::size_t p = 0, n = own.size(); p < n; ++p)
            for (const double turn : {-1.0, 1.0}) {
                const double moved = own[p] + turn * box.length();
                if (moved < box.low - margin || moved > box.high + margin) continue;
                Vec3 x = cloud.points[p];
                (d == 0 ? x.x : x.y) = moved;
                cloud.points.x.push_back(x.x), cloud.points.y.push_back(x.y), cloud.points.z.push_back(x.z);
                cloud.values.push_back(cloud.values[p]);
            }
    }
}

/// Throws InputError unless the points lie at three places at least, not on a line: else nothing tells how
/// the field varies beside them.
void check_spread(const Points& points) {
    const auto farthest = [&](const auto& distance) {
        std::size_t found = 0;
        for (std::size_t p = 1; p < points.size(); ++p)
            if (distance(points[p]) > distance(points[found])) found = p;
        return points[found];
    };
    const Vec3 begin = points[0];
    const Vec3 end = farthest([&](Vec3 x) { return norm(x - begin); });
    const double length = norm(end - begin);
    if (!(length > 0))
        throw InputError("all points of the field lie at one place; at least three that are not on a line "
                         "are needed");
    const Vec3 along = (1 / length) * (end - begin);
    const auto beside = [&](Vec3 x) { return norm(cross(x - begin, along)); };
    if (!(beside(farthest(beside)) > 1e-9 * length))
        throw InputError(points.size() == 2 ? "the field has values at two points only; at least three that "
                                              "are not on a line are needed"
                                            : "all points of the field lie on a line, so that it is not "
                                              "known between and beside them in the plane");
}

Cloud in_chart(ScatteredData data, bool placed, const Chart& chart) {
    Cloud cloud{std::move(data.points), std::move(data.values), 2, true};
    std::fill(cloud.points.z.begin(), cloud.points.z.end(), 0.0);
    if (!placed) {
        fit_coordinate(cloud.points.x, range_of(chart, 0));
        fit_coordinate(cloud.points.y, range_of(chart, 1));
    }
    return cloud;
}

/// Points in space near a surface in space.
Cloud in_space(ScatteredData data, FieldPlacement placement, const DataContext& context) {
    Cloud cloud{std::move(data.points), std::move(data.values), 3, false};
    if (placement == FieldPlacement::fit && context.discretisation) {
        const Box box = bounding_box(context.discretisation->mesh()->nodes);
        fit_coordinate(cloud.points.x, {box.low.x, box.high.x});
        fit_coordinate(cloud.points.y, {box.low.y, box.high.y});
        fit_coordinate(cloud.points.z, {box.low.z, box.high.z});
    }
    return cloud;
}

Cloud place(ScatteredData data, const FieldOptions& options, const DataContext& context, const Chart& chart,
            std::vector<std::string>& notes) {
    if (chart.kind() == ChartKind::surface && data.dimension == 3)
        return in_space(std::move(data), options.placement, context);
    const bool sphere = chart.kind() == ChartKind::sphere;
    if (data.dimension == 3 && !sphere) notes.push_back("The third coordinate of the points is not used.");
    const bool placed =
        (sphere && data.dimension == 3) || by_coordinates({range_of(data.points.x), range_of(data.points.y)},
                                                          data.coordinates, chart, options.placement);
    if (placed && chart.kind() == ChartKind::surface)
        throw InputError(
            "points with two coordinates cannot be placed by them on a surface in space; use placement "
            "= fit");
    note_placement(placed, options.placement, chart, notes);
    if (!sphere) return in_chart(std::move(data), placed, chart);
    if (!placed) {
        fit_coordinate(data.points.x, range_of(chart, 0));
        fit_coordinate(data.points.y, range_of(chart, 1));
    }
    Points origin(1), at;
    chart.points(origin, at);
    return on_sphere(std::move(data), norm(at[0]));
}

} // namespace

FieldGrid scattered_field(ScatteredData data, const FieldOptions& options, const DataContext& context) {
    FieldGrid made;
    prepare_values(data, options, made.notes);
    const auto chart = chart_of(context);
    const ChartExtent extent = extent_of(chart, context);
    Cloud cloud = place(std::move(data), options, context, *chart, made.notes);
    if (cloud.in_chart) to_first_period(cloud.points, *chart);
    if (const std::size_t merged = merge_coincident(cloud.points, cloud.values, context.stop))
        made.notes.push_back(coincidence_note(merged));
    check_spread(cloud.points);
    const std::size_t count = cloud.values.size();
    if (cloud.in_chart) add_images(cloud, *chart);
    const double low = range_of(cloud.values).low;
    const bool own_units = cloud.in_chart;
    const ScatteredFit fit(std::move(cloud.points), std::move(cloud.values), cloud.dimension);
    const double spacing = fit.spacing();
    made.cell = extent.cell, made.sigma = options.blur * extent.cell;
    const auto step = [&](std::size_t d) {
        const double length = d == 0 ? extent.width : extent.height;
        return own_units ? spacing : spacing * range_of(*chart, d).length() / length;
    };
    made.grid = sampling_grid(chart, {step(0), step(1)}, extent, made.sigma, most_fitted);
    Points targets = made.grid.coordinates();
    if (!own_units) {
        const Points s = std::move(targets);
        chart->points(s, targets);
    }
    made.values.resize(targets.size());
    std::vector<char> covered(targets.size());
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (i % 4096 == 0)
            check_stop(context, static_cast<double>(i) / static_cast<double>(targets.size()),
                       "Fitting the field");
        const auto [value, distance] = fit.at(targets[i]);
        const bool inside = !(distance > 3 * spacing);
        covered[i] = inside ? 1 : 0;
        made.values[i] = inside || options.missing != MissingValues::lowest ? value : low;
    }
    made.notes.push_back("The field is a moving least-squares fit of " + std::to_string(count) +
                         " points (linear, Gaussian weights, " + std::to_string(ScatteredFit::neighbours) +
                         " neighbours).");
    note_coverage(made.grid, covered, options, context, made.notes);
    return made;
}

} // namespace gaspard
