// What eye and files need of a mesh: points to show, triangles that fill the cells, segments that draw their
// edges.
//
// The structure is made once per mesh; positions and node fields follow a snapshot through fixed weights:
//   shown point p = sum over j of w_pj * node j
// Cells of order 1 in the plane need no further points (p = node); curved edges and faces are cut finer.
#pragma once

#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

struct Tessellation {
    std::size_t point_count = 0;
    int cuts = 1; ///< segments per edge
    // Row p of the weights: entries starts[p] .. starts[p + 1] of nodes and weights. All empty: p = node p.
    std::vector<std::uint32_t> starts, nodes;
    std::vector<double> weights;
    std::vector<std::uint32_t> triangles;      ///< three points each
    std::vector<std::uint32_t> triangle_cells; ///< which cell each triangle belongs to
    std::vector<std::uint32_t> segments;       ///< two points each; an edge shared by cells is drawn once
    std::vector<std::uint32_t>
        segment_cells; ///< which cell each belongs to, where cells are lines; else empty
    /// Two points per segment: a corner at the far side of each cell beside it, so that a picture can tell
    /// how close the next line is. The same twice at a border; the segment's own first point where there is
    /// nothing beside.
    std::vector<std::uint32_t> segment_sides;
};

/// `cuts` pieces per curved edge (order 2 only). Of solids, the boundary faces and all edges of those faces.
Tessellation tessellate(const Mesh& mesh, int cuts = 8);

/// For what belongs to cells, at the shown points: the mean of the triangles around each (of the segments
/// where there are only those). Points in no cell get 0.
std::vector<double> point_means(const Tessellation& tessellation, std::span<const double> cells);

/// The shown points for given node positions (mesh numbering).
Points shown_points(const Tessellation& tessellation, const Points& nodes);
/// The shown values of a node field.
std::vector<double> shown_values(const Tessellation& tessellation, std::span<const double> nodes);

} // namespace gaspard
