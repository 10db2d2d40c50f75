// The triangles of a tessellation in pairs, as the quadrilaterals that they halve. Values at four corners can
// then be interpolated independently of the diagonal along which they are halved (shaders/mesh_fill.vert).
// And its segments with what lies beside (shaders/mesh_line.vert).
#pragma once

#include "core/tessellate/tessellation.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace gaspard {

/// Four shown points in order around a quadrilateral; a triangle repeats its last one.
using Facet = std::array<std::uint32_t, 4>;

struct DrawnFacets {
    std::vector<Facet> facets;
    /// Three for each triangle of the tessellation, in its order: 4 times a facet plus the number of one of
    /// its points. Of a quadrilateral, the half at point 0 ends with point 3, the half at point 2 with point
    /// 1.
    std::vector<std::uint32_t> corners;
};

/// `quadrilaterals`: the faces of the cells are quadrilaterals; else every triangle is a facet.
DrawnFacets make_facets(const Tessellation& tessellation, bool quadrilaterals);

/// For each facet which of its sides lie on segments: bit k for that from point k to the next one. Of a
/// triangle also which of its points does so although neither of the sides that meet there does: bit 4 + k.
std::vector<std::uint32_t> sides_on_segments(const DrawnFacets& facets, const Tessellation& tessellation);

/// Two ends of a segment, and what lies beside (see Tessellation::segment_sides).
using Segment = std::array<std::uint32_t, 4>;

std::vector<Segment> segments_of(const Tessellation& tessellation);
/// Those with a cell on one side only.
std::vector<Segment> segments_at_borders(const Tessellation& tessellation);

} // namespace gaspard
