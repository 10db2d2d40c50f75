#include "core/spline/nearest_point.hpp"

#include "core/base/box.hpp"
#include "core/base/check.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace gaspard {

namespace {

constexpr std::size_t leaf = 8; // points that are compared one by one

double along(Vec3 x, int axis) { return axis == 0 ? x.x : axis == 1 ? x.y : x.z; }

} // namespace

NearestPoint::NearestPoint(Points points) : points_(std::move(points)), axis_(points_.size()) {
    GASPARD_CHECK(points_.size() > 0);
    order_.resize(points_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    sort(0, order_.size());
}

void NearestPoint::sort(std::size_t begin, std::size_t end) {
    if (end - begin <= leaf) return;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    for (std::size_t i = begin; i < end; ++i) {
        const Vec3 p = points_[order_[i]];
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 side = high - low;
    const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
        return along(points_[a], axis) < along(points_[b], axis);
    });
    axis_[middle] = static_cast<std::uint8_t>(axis);
    sort(begin, middle), sort(middle + 1, end);
}

void NearestPoint::search(std::size_t begin, std::size_t end, Vec3 x, Best& best) const {
    const auto compare = [&](std::size_t i) {
        const Vec3 d = points_[order_[i]] - x;
        if (const double squared = dot(d, d); squared < best.squared) best = {squared, order_[i]};
    };
    if (end - begin <= leaf) {
        for (std::size_t i = begin; i < end; ++i) compare(i);
        return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    compare(middle);
    const int axis = axis_[middle];
    const double beyond = along(x, axis) - along(points_[order_[middle]], axis);
    beyond < 0 ? search(begin, middle, x, best) : search(middle + 1, end, x, best);
    if (beyond * beyond < best.squared)
        beyond < 0 ? search(middle + 1, end, x, best) : search(begin, middle, x, best);
}

std::size_t NearestPoint::operator()(Vec3 x) const {
    Best best{std::numeric_limits<double>::infinity(), 0};
    search(0, order_.size(), x, best);
    return best.index;
}

} // namespace gaspard
