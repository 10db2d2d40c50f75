#include "core/base/box.hpp"

#include "core/base/finite_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

Vec3 minimum(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 maximum(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

} // namespace

Box bounding_box(const Points& points) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto x = finite_range(points.x), y = finite_range(points.y), z = finite_range(points.z);
    if (x && y && z) return {{x->first, y->first, z->first}, {x->second, y->second, z->second}};
    const auto finite = [](Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
    Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const Vec3 p = points[i]; finite(p))
            box.low = minimum(box.low, p), box.high = maximum(box.high, p);
    return box.low.x <= box.high.x ? box : Box{};
}

Box merge(const Box& a, const Box& b) { return {minimum(a.low, b.low), maximum(a.high, b.high)}; }

double longest_side(const Box& box) {
    const Vec3 sides = box.high - box.low;
    return std::max({sides.x, sides.y, sides.z});
}

} // namespace gaspard
