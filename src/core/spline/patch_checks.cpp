#include "core/spline/patch_checks.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr double largest_coordinate = 1e12;

} // namespace

void not_a_patch(const std::string& origin, const std::string& what) {
    throw InputError(origin + " is not a valid patch: " + what);
}

KnotVector checked_direction(double degree, std::vector<double> knots, const std::string& which,
                             const std::string& origin) {
    if (!(degree >= 1 && degree <= highest_degree) || degree != std::floor(degree))
        not_a_patch(origin, "degrees must be integers from 1 to " + std::to_string(highest_degree));
    for (const double knot : knots)
        if (!std::isfinite(knot)) not_a_patch(origin, "knots[" + which + "] must be finite numbers");
    KnotVector space{static_cast<int>(degree), std::move(knots)};
    if (!space.knots.empty()) {
        const double first = space.knots.front(), last = space.knots.back(), length = last - first;
        for (double& knot : space.knots) knot = knot == last ? (length > 0 ? 1 : 0) : (knot - first) / length;
    }
    if (!is_open(space))
        not_a_patch(origin,
                    "knots[" + which +
                        "] must be an open ascending knot vector: the first and the last knot occur " +
                        std::to_string(space.degree + 1) + " times for degree " +
                        std::to_string(space.degree) + ", no knot more often");
    constexpr double shortest = 1e-6; // relative to the whole range
    const auto breaks = space.breaks();
    for (std::size_t i = 1; i < breaks.size(); ++i)
        if (breaks[i] - breaks[i - 1] < shortest)
            not_a_patch(origin, "knots[" + which + "] has two knots closer than 1e-6 of its range");
    return space;
}

void check_patch(const SplinePatch& patch, const std::string& origin) {
    const std::size_t n = patch.space.size();
    if (patch.control.size() != n)
        not_a_patch(origin, "the knots require " + std::to_string(n) + " control points, but there are " +
                                std::to_string(patch.control.size()));
    for (std::size_t i = 0; i < n; ++i)
        for (const double c : {patch.control.x[i], patch.control.y[i], patch.control.z[i]})
            if (!(std::abs(c) <= largest_coordinate))
                not_a_patch(origin, "control point " + std::to_string(i) + " has a coordinate larger than " +
                                        format_number(largest_coordinate));
    if (patch.weights.size() != n) not_a_patch(origin, "there must be as many weights as control points");
    for (const double w : patch.weights)
        if (!(w >= 1e-6 && w <= 1e6))
            not_a_patch(origin, "weights must be positive (1e-6 to 1e6), but one is " + format_number(w));
}

void check_regular(const PatchMap& map, const std::string& origin) {
    constexpr std::size_t side = 64; // sampled at the centres of side x side squares
    constexpr double least = 1e-9;   // relative to the largest Jacobian
    Points xi(side * side), first, second;
    for (std::size_t i = 0; i < xi.size(); ++i)
        xi.set(i, {(static_cast<double>(i % side) + 0.5) / side, (static_cast<double>(i / side) + 0.5) / side,
                   0});
    map.tangents(xi, first, second);
    double smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
    std::size_t where = 0;
    for (std::size_t i = 0; i < xi.size(); ++i) {
        const Vec3 normal = cross(first[i], second[i]);
        const double jacobian = map.space_dimension() == 2 ? normal.z : norm(normal);
        if (!std::isfinite(jacobian)) not_a_patch(origin, "the map is not finite everywhere");
        if (jacobian < smallest) smallest = jacobian, where = i;
        largest = std::max(largest, jacobian);
    }
    const double size = std::max(std::abs(smallest), std::abs(largest));
    if (!(smallest > least * size) && !(largest < -least * size))
        not_a_patch(origin, "the map folds or has no area, for example at ξ = (" +
                                format_number(xi.x[where]) + ", " + format_number(xi.y[where]) + ")");
}

} // namespace gaspard
