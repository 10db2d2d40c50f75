#include "core/tessellate/clip.hpp"

#include "core/base/check.hpp"

#include <cmath>

namespace gaspard {

void ClipPolygon::add(ClipCorner corner) {
    if (size_ > 0 && corners_[size_ - 1].point == corner.point) {
        corners_[size_ - 1].marks |= corner.marks;
        return;
    }
    GASPARD_CHECK(size_ < corners_.size());
    corners_[size_++] = corner;
}

void ClipPolygon::close() {
    if (size_ < 2 || corners_[0].point != corners_[size_ - 1].point) return;
    corners_[0].marks |= corners_[size_ - 1].marks;
    --size_;
}

Clipper::Clipper(const std::vector<CutWedge>& cut, double tolerance, LatticePoints& points)
    : tolerance_(tolerance), points_(points) {
    for (const CutWedge& wedge : cut) {
        const auto begin = static_cast<std::uint32_t>(planes_.size());
        planes_.insert(planes_.end(), wedge.begin(), wedge.end());
        wedges_.push_back({begin, static_cast<std::uint32_t>(planes_.size())});
    }
    GASPARD_CHECK(planes_.size() <= most_cut_planes);
}

double Clipper::distance(std::uint32_t point, std::uint32_t plane) const {
    const double away = planes_[plane].distance(points_.place(point));
    return std::abs(away) <= tolerance_ ? 0 : away;
}

ClipCorner Clipper::cross(ClipCorner a, ClipCorner b, std::uint32_t plane) {
    const double from = distance(a.point, plane), to = distance(b.point, plane);
    if (to == 0) return {b.point, b.marks | mark(plane)};
    return {points_.between(a.point, b.point, from / (from - to), plane), (a.marks & b.marks) | mark(plane)};
}

void Clipper::split(const ClipPolygon& polygon, std::uint32_t plane, ClipPolygon& before,
                    ClipPolygon& beyond) {
    before = beyond = {};
    std::array<double, 32> away{};
    bool some_before = false, some_beyond = false;
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i) {
        away[i] = distance(polygon[i].point, plane);
        some_before = some_before || away[i] < 0;
        some_beyond = some_beyond || away[i] > 0;
    }
    const bool divided = some_before && some_beyond;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        ClipCorner corner = polygon[i];
        if (away[i] == 0) corner.marks |= mark(plane);
        if (divided ? away[i] <= 0 : some_before) before.add(corner);
        if (divided ? away[i] >= 0 : !some_before) beyond.add(corner);
        if (!(away[i] < 0 && away[next] > 0) && !(away[i] > 0 && away[next] < 0)) continue;
        const ClipCorner between = cross(corner, polygon[next], plane);
        before.add(between);
        beyond.add(between);
    }
    before.close();
    beyond.close();
}

ClipPolygon Clipper::within_wedge(ClipPolygon polygon, std::uint32_t wedge, std::uint32_t cap) {
    ClipPolygon before, beyond;
    for (std::uint32_t plane = wedges_[wedge].begin; plane < wedges_[wedge].end; ++plane) {
        if (plane == cap) continue;
        if (plane < cap && stays_in(polygon, plane, cap)) return {}; // that one has it
        split(polygon, plane, before, beyond);
        if (beyond.size() < 3) return {};
        polygon = beyond;
    }
    return polygon;
}

bool Clipper::stays_in(const ClipPolygon& polygon, std::uint32_t plane, std::uint32_t cap) const {
    if (!(dot(planes_[plane].normal, planes_[cap].normal) > 0)) return false;
    const auto corners = polygon.corners();
    return std::all_of(corners.begin(), corners.end(),
                       [&](const ClipCorner& corner) { return distance(corner.point, plane) == 0; });
}

} // namespace gaspard
