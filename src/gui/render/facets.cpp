#include "gui/render/facets.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <initializer_list>
#include <unordered_set>

namespace gaspard {

DrawnFacets make_facets(const Tessellation& tessellation, bool quadrilaterals) {
    const std::vector<std::uint32_t>& t = tessellation.triangles;
    DrawnFacets found;
    found.facets.reserve(t.size() / (quadrilaterals ? 6 : 3));
    found.corners.reserve(t.size());
    const auto add = [&](const Facet& points, std::initializer_list<std::uint32_t> corners) {
        const auto first = static_cast<std::uint32_t>(4 * found.facets.size());
        found.facets.push_back(points);
        for (const std::uint32_t corner : corners) found.corners.push_back(first + corner);
    };
    for (std::size_t i = 0; i < t.size(); i += 3) {
        // A map divides triangles at its border; what remains of a pair is then a single triangle.
        const bool pair = quadrilaterals && i + 5 < t.size() && t[i + 3] == t[i + 1] &&
                          t[i + 5] == t[i + 2] &&
                          tessellation.triangle_cells[i / 3] == tessellation.triangle_cells[i / 3 + 1];
        if (pair) {
            add({t[i], t[i + 1], t[i + 4], t[i + 2]}, {0, 1, 3, 2, 3, 1});
            i += 3;
        } else {
            add({t[i], t[i + 1], t[i + 2], t[i + 2]}, {0, 1, 2});
        }
    }
    return found;
}

std::vector<std::uint32_t> sides_on_segments(const DrawnFacets& facets, const Tessellation& tessellation) {
    const auto key = [](std::uint32_t a, std::uint32_t b) {
        return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    };
    const auto& ends = tessellation.segments;
    std::unordered_set<std::uint64_t> segments;
    segments.reserve(ends.size() / 2);
    std::vector<char> on_segment(tessellation.point_count, 0);
    for (const std::uint32_t end : ends) on_segment[end] = 1;
    for (std::size_t i = 0; i < ends.size(); i += 2) segments.insert(key(ends[i], ends[i + 1]));
    std::vector<std::uint32_t> sides;
    sides.reserve(facets.facets.size());
    for (const Facet& points : facets.facets) {
        const std::size_t corners = points[3] == points[2] ? 3 : 4;
        std::uint32_t found = 0;
        for (std::size_t k = 0; k < corners; ++k)
            if (segments.contains(key(points[k], points[(k + 1) % corners]))) found |= 1U << k;
        for (std::size_t k = 0; corners == 3 && k < 3; ++k)
            if (on_segment[points[k]] != 0 && (found >> k & 1U) == 0 && (found >> (k + 2) % 3 & 1U) == 0)
                found |= 16U << k;
        sides.push_back(found);
    }
    return sides;
}

std::vector<Segment> segments_of(const Tessellation& tessellation) {
    const auto& ends = tessellation.segments;
    const auto& sides = tessellation.segment_sides;
    GASPARD_CHECK(sides.size() == ends.size());
    std::vector<Segment> segments(ends.size() / 2);
    for (std::size_t i = 0; i < segments.size(); ++i)
        segments[i] = {ends[2 * i], ends[2 * i + 1], sides[2 * i], sides[2 * i + 1]};
    return segments;
}

std::vector<Segment> segments_at_borders(const Tessellation& tessellation) {
    std::vector<Segment> border = segments_of(tessellation);
    std::erase_if(border, [](const Segment& one) { return one[2] != one[3] || one[2] == one[0]; });
    return border;
}

} // namespace gaspard
