#include "core/spline/patch_checks.hpp"

#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace gaspard {

namespace {

constexpr double largest_coordinate = 1e12;
/// Of the longest side of the box around the control points; areas and densities are within range then.
constexpr double smallest_size = 1e-30;

} // namespace

void not_a_patch(const std::string& origin, const std::string& what) {
    throw InputError(origin + " is not a valid patch: " + what);
}

namespace {

/// An inner knot that occurs degree + 1 times or more often: there the patch is not continuous.
void refuse_torn(const KnotVector& space, const std::string& which, const std::string& origin) {
    const auto& t = space.knots;
    const auto p = static_cast<std::size_t>(space.degree);
    for (std::size_t i = 0; i + p < t.size(); ++i)
        if (t[i] > t.front() && t[i] < t.back() && t[i] == t[i + p])
            not_a_patch(origin, "it is torn at the knot " + exact_number(t[i]) + " of knots[" + which +
                                    "]: for degree " + std::to_string(p) +
                                    " an inner knot may occur at most " + std::to_string(p) +
                                    (p == 1 ? " time" : " times"));
}

KnotVector checked_direction(double degree, std::vector<double> knots, const std::string& which,
                             const std::string& origin) {
    if (!(degree >= 1 && degree <= highest_degree) || degree != std::floor(degree))
        not_a_patch(origin, "degrees must be integers from 1 to " + std::to_string(highest_degree));
    for (const double knot : knots)
        if (!std::isfinite(knot)) not_a_patch(origin, "knots[" + which + "] must be finite numbers");
    KnotVector space{static_cast<int>(degree), std::move(knots)};
    if (std::is_sorted(space.knots.begin(), space.knots.end())) refuse_torn(space, which, origin);
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
            not_a_patch(origin, "knots[" + which + "] has two knots closer than 10⁻⁶ of its range");
    return space;
}

void check_weights(const std::vector<double>& weights, std::size_t count, const std::string& origin) {
    if (weights.size() != count)
        not_a_patch(origin, "there must be as many weights as control points, but there are " +
                                std::to_string(weights.size()) + " for " + std::to_string(count));
    for (const double w : weights)
        if (!(w >= 1e-6 && w <= 1e6))
            not_a_patch(origin, "weights must be positive (10⁻⁶ to 10⁶), but one is " + exact_number(w));
}

void check_coordinates(const Points& control, const std::string& origin) {
    for (std::size_t i = 0; i < control.size(); ++i)
        for (const double c : {control.x[i], control.y[i], control.z[i]})
            if (!(std::abs(c) <= largest_coordinate))
                not_a_patch(origin, "control point " + std::to_string(i) + " has a coordinate larger than " +
                                        exact_number(largest_coordinate));
    double size = 0;
    for (const auto* c : {&control.x, &control.y, &control.z}) {
        const auto [low, high] = std::minmax_element(c->begin(), c->end());
        if (low != c->end()) size = std::max(size, *high - *low);
    }
    if (size > 0 && size < smallest_size) // without any extent the map has no area: check_regular
        not_a_patch(origin, "it measures only " + exact_number(size) + "; the smallest size is " +
                                exact_number(smallest_size) + ": give the coordinates in a smaller unit");
}

} // namespace

SplinePatch make_patch(PatchParts parts, const std::string& origin) {
    SplinePatch patch;
    for (std::size_t d = 0; d < parts.directions; ++d)
        patch.space.directions.push_back(
            checked_direction(parts.degrees[d], std::move(parts.knots[d]), std::to_string(d), origin));
    const std::size_t n = patch.space.size();
    patch.control = std::move(parts.control);
    if (patch.control.size() != n)
        not_a_patch(origin, "the knots require " + std::to_string(n) + " control points, but there are " +
                                std::to_string(patch.control.size()));
    check_coordinates(patch.control, origin);
    patch.weights = std::move(parts.weights);
    if (patch.weights.empty()) patch.weights.assign(n, 1.0);
    check_weights(patch.weights, n, origin);
    return patch;
}

Points points_in_rows(const std::vector<double>& coordinates, std::size_t dimension) {
    Points points(coordinates.size() / dimension);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double* c = &coordinates[dimension * i];
        points.set(i, {c[0], c[1], dimension == 3 ? c[2] : 0});
    }
    return points;
}

Points points_in_columns(const std::vector<double>& coordinates, std::size_t dimension) {
    const std::size_t n = coordinates.size() / dimension;
    Points points(n);
    for (std::size_t i = 0; i < n; ++i)
        points.set(i, {coordinates[i], coordinates[n + i], dimension == 3 ? coordinates[2 * n + i] : 0});
    return points;
}

void divide_by_weights(PatchParts& parts, const std::string& origin) {
    check_weights(parts.weights, parts.control.size(), origin);
    for (std::size_t i = 0; i < parts.control.size(); ++i)
        parts.control.set(i, (1 / parts.weights[i]) * parts.control[i]);
}

/// The unit vector to which all vectors are parallel, in either direction; nullopt if there is none.
static std::optional<Vec3> common_direction(const Points& vectors) {
    Vec3 longest;
    for (std::size_t i = 0; i < vectors.size(); ++i)
        if (norm(vectors[i]) > norm(longest)) longest = vectors[i];
    if (!(norm(longest) > 0)) return std::nullopt;
    const Vec3 unit = (1 / norm(longest)) * longest;
    for (std::size_t i = 0; i < vectors.size(); ++i)
        if (norm(cross(vectors[i], unit)) > 1e-9 * norm(longest)) return std::nullopt;
    return unit;
}

/// At points xi; the Jacobian must have one sign.
static void check_jacobians(const Points& xi, const std::vector<double>& jacobians, const std::string& what,
                            const std::string& origin) {
    constexpr double least = 1e-9; // relative to the largest Jacobian
    double smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
    for (const double one : jacobians) {
        if (!std::isfinite(one)) not_a_patch(origin, "the map is not finite everywhere");
        smallest = std::min(smallest, one), largest = std::max(largest, one);
    }
    const double size = std::max(std::abs(smallest), std::abs(largest));
    if (smallest > least * size || largest < -least * size) return;
    // A mirrored map folds where the sign is that of fewer points.
    const bool mirrored = largest + smallest < 0;
    const double worst = mirrored ? largest : smallest;
    const auto where =
        static_cast<std::size_t>(std::find(jacobians.begin(), jacobians.end(), worst) - jacobians.begin());
    const bool solid = what == "volume";
    not_a_patch(origin, "the map folds or has no " + what + ", for example at ξ = (" +
                            exact_number(xi.x[where]) + ", " + exact_number(xi.y[where]) +
                            (solid ? ", " + exact_number(xi.z[where]) : "") + ")");
}

void check_regular(const PatchMap& map, const std::string& origin) {
    constexpr std::size_t side = 64; // sampled at the centres of side x side squares
    Points xi(side * side);
    std::array<Points, 2> tangents;
    for (std::size_t i = 0; i < xi.size(); ++i)
        xi.set(i, {(static_cast<double>(i % side) + 0.5) / side, (static_cast<double>(i / side) + 0.5) / side,
                   0});
    map.tangents(xi, tangents);
    Points normals(xi.size());
    for (std::size_t i = 0; i < xi.size(); ++i) normals.set(i, cross(tangents[0][i], tangents[1][i]));
    const std::optional<Vec3> plane = common_direction(normals);
    std::vector<double> jacobians(xi.size());
    for (std::size_t i = 0; i < xi.size(); ++i)
        jacobians[i] = plane ? dot(normals[i], *plane) : norm(normals[i]);
    check_jacobians(xi, jacobians, "area", origin);
}

void check_regular(const SolidMap& map, const std::string& origin) {
    const Points xi = cube_middles(24);
    std::array<Points, 3> tangents;
    map.tangents(xi, tangents);
    std::vector<double> jacobians(xi.size());
    for (std::size_t i = 0; i < xi.size(); ++i)
        jacobians[i] = dot(cross(tangents[0][i], tangents[1][i]), tangents[2][i]);
    check_jacobians(xi, jacobians, "volume", origin);
}

} // namespace gaspard
