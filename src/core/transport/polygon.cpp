#include "core/transport/polygon.hpp"

#include "core/base/box.hpp"
#include "core/base/short_number.hpp"
#include "core/transport/checks.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gaspard {

namespace {

double turn(Vec3 a, Vec3 b, Vec3 c) { return cross(b - a, c - b).z; }

/// Of p from the line from a to b, positive on its left.
double height(Vec3 a, Vec3 b, Vec3 p) { return cross(b - a, p - a).z / norm(b - a); }

double size_of(const Points& polygon) { return longest_side(bounding_box(polygon)); }

bool sides_meet(const Points& p, std::size_t i, std::size_t j) {
    const Vec3 a = p[i], b = p[(i + 1) % p.size()], c = p[j], d = p[(j + 1) % p.size()];
    const auto apart = [](double u, double v) { return (u > 0 && v > 0) || (u < 0 && v < 0); };
    if (apart(turn(a, b, c), turn(a, b, d)) || apart(turn(c, d, a), turn(c, d, b))) return false;
    const auto boxes_meet = [](double u, double v, double w, double x) {
        return std::max(u, v) >= std::min(w, x) && std::max(w, x) >= std::min(u, v);
    };
    return boxes_meet(a.x, b.x, c.x, d.x) && boxes_meet(a.y, b.y, c.y, d.y);
}

/// For polygons that have a fault, so that it may be slow.
std::optional<std::string> crossing(const Points& p, const VertexName& name) {
    const std::size_t n = std::min(p.size(), std::size_t{5000});
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j)
            if ((j + 1) % p.size() != i && sides_meet(p, i, j))
                return "crosses itself: its sides after " + name(i) + " and after " + name(j) + " meet";
    return std::nullopt;
}

double area_of_hull(const Points& p, const std::vector<std::size_t>& hull) {
    Points corners(hull.size());
    for (std::size_t i = 0; i < hull.size(); ++i) corners.set(i, p[hull[i]]);
    return signed_area(corners);
}

/// The numbers of the hull in the order of the polygon, from the smallest on; empty if that is another order.
std::vector<std::size_t> in_order(std::vector<std::size_t> hull) {
    std::rotate(hull.begin(), std::min_element(hull.begin(), hull.end()), hull.end());
    if (hull[1] > hull.back()) std::reverse(hull.begin() + 1, hull.end());
    if (!std::is_sorted(hull.begin(), hull.end())) hull.clear();
    return hull;
}

/// The vertex farthest inside the hull, if beyond the tolerance, or one where the polygon runs backwards.
std::optional<std::size_t> dent(const Points& p, const std::vector<std::size_t>& ordered, double allowed) {
    std::size_t worst = 0;
    double deepest = allowed;
    std::optional<std::size_t> backwards;
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        const std::size_t last = i + 1 < ordered.size() ? ordered[i + 1] : ordered[0] + p.size();
        const Vec3 a = p[ordered[i]], b = p[last % p.size()];
        double before = 0;
        for (std::size_t k = ordered[i] + 1; k <= last; ++k) {
            const Vec3 q = p[k % p.size()];
            const double along = dot(q - a, b - a) / norm(b - a), inside = std::abs(height(a, b, q));
            if (inside > deepest) deepest = inside, worst = k % p.size();
            if (along <= before && !backwards) backwards = k % p.size();
            before = along;
        }
    }
    return deepest > allowed ? std::optional(worst) : backwards;
}

} // namespace

VertexName counted_vertex(const Points& points, const std::string& noun) {
    return [&points, noun](std::size_t i) {
        return noun + " " + std::to_string(i + 1) + " at (" + exact_number(points.x[i]) + ", " +
               exact_number(points.y[i]) + ")";
    };
}

std::vector<std::size_t> convex_hull(const Points& points) {
    std::vector<std::size_t> sorted(points.size()), hull;
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::sort(sorted.begin(), sorted.end(), [&](std::size_t i, std::size_t j) {
        return std::tuple(points.x[i], points.y[i], i) < std::tuple(points.x[j], points.y[j], j);
    });
    const auto chain = [&](auto begin, auto end) { // the lower half, then the upper half
        const std::size_t bottom = hull.size();
        for (auto at = begin; at != end; ++at) {
            while (hull.size() >= bottom + 2 &&
                   turn(points[hull[hull.size() - 2]], points[hull.back()], points[*at]) <= 0)
                hull.pop_back();
            if (hull.size() == bottom || !(points[hull.back()] == points[*at])) hull.push_back(*at);
        }
        if (hull.size() > bottom) hull.pop_back();
    };
    chain(sorted.begin(), sorted.end());
    chain(sorted.rbegin(), sorted.rend());
    return hull;
}

double signed_area(const Points& polygon) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]).z;
    return sum / 2;
}

std::optional<std::string> convexity_fault(const Points& polygon, double tolerance, const VertexName& name) {
    const std::size_t n = polygon.size();
    const double allowed = tolerance * size_of(polygon);
    for (std::size_t i = 0; i < n; ++i)
        if (norm(polygon[(i + 1) % n] - polygon[i]) <= 1e-12 * size_of(polygon))
            return "has the same point twice: " + name(i) + " and " + name((i + 1) % n);
    const auto hull = convex_hull(polygon);
    if (!(area_of_hull(polygon, hull) > std::max(3 * allowed, 1e-9 * size_of(polygon)) * size_of(polygon)))
        return "has no area, all its points lie on one line";
    const auto ordered = in_order(hull);
    if (ordered.empty()) {
        if (auto fault = crossing(polygon, name)) return fault;
        return "crosses itself";
    }
    const auto at = dent(polygon, ordered, allowed);
    if (!at) return std::nullopt;
    if (auto fault = crossing(polygon, name)) return fault;
    return "is not convex at " + name(*at);
}

std::vector<std::size_t> true_corners(const Points& polygon, double tolerance) {
    const auto hull = convex_hull(polygon);
    const double allowed = tolerance * size_of(polygon);
    const std::size_t n = hull.size();
    const auto at = [&](std::size_t i) { return polygon[hull[i % n]]; };
    std::size_t start = 0; // a corner that stays
    double sharpest = -1;
    for (std::size_t i = 0; i < n; ++i) {
        const double depth = -height(at(i + n - 1), at(i + 1), at(i));
        if (depth > sharpest) sharpest = depth, start = i;
    }
    std::vector<std::size_t> kept = {hull[start]};
    for (std::size_t from = start, i = start + 1; i < start + n; ++i) {
        bool straight = true; // from the last corner to the one after i
        for (std::size_t k = from + 1; k <= i && straight; ++k)
            straight = -height(at(from), at(i + 1), at(k)) <= allowed;
        if (!straight) kept.push_back(hull[i % n]), from = i;
    }
    return kept;
}

void check_convex(const Points& polygon, double tolerance, const std::string& noun) {
    const auto name = counted_vertex(polygon, noun);
    if (polygon.size() < 3)
        throw InputError("a closed convex curve needs at least three " + noun + "s, not " +
                         std::to_string(polygon.size()));
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (const double coordinate : {polygon.x[i], polygon.y[i]})
            check_finite(coordinate, "each coordinate of " + noun + " " + std::to_string(i + 1));
    if (const double size = size_of(polygon); size > 0) check_size(size, "curve");
    if (const auto fault = convexity_fault(polygon, tolerance, name))
        throw InputError((noun == "corner" ? "the polygon " : "the polygon of the " + noun + "s ") + *fault);
}

} // namespace gaspard
