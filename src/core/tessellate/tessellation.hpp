// Tessellation of a mesh for display and export: shown points, triangles that fill the cells, and segments
// along their edges.
//
// It is made once per mesh; positions and nodal fields of a snapshot are mapped to shown points by fixed
// weights,
//
//   point p = sum over j of w_pj node_j.
//
// For cells of order 1 in the plane the points are the nodes; curved edges and faces are subdivided.
#pragma once

#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gaspard {

struct Tessellation {
    std::size_t point_count = 0;
    int cuts = 1; ///< segments per edge
    // Row p of the weights: entries starts[p] .. starts[p + 1] of `nodes` and `weights`. All empty if p =
    // node p.
    std::vector<std::uint32_t> starts, nodes;
    std::vector<double> weights;
    std::vector<std::uint32_t> triangles;      ///< three points per triangle
    std::vector<std::uint32_t> triangle_cells; ///< cell of each triangle
    std::size_t caps = 0;                     ///< so many of the last triangles close cells that a plane cuts
    std::vector<std::uint32_t> segments;      ///< two points per segment; shared edges occur once
    std::vector<std::uint32_t> segment_cells; ///< cell of each segment if cells are lines; else empty
    /// Two points per segment: a corner on the far side of each adjacent cell, from which a renderer can tell
    /// the distance to the next line. On a boundary the same point twice; without any cell, the segment's
    /// first point.
    std::vector<std::uint32_t> segment_sides;
    /// For a map of a tessellation (core/tessellate/sphere_map.hpp), that tessellation; its points come
    /// first. Else null.
    std::shared_ptr<const Tessellation> base;

    /// The node of a shown point; nullopt for points on curved edges and faces, and on cuts.
    std::optional<std::uint32_t> node_of(std::uint32_t point) const;
};

/// `cuts`: pieces per curved edge (order 2 and higher). For solids, the boundary faces and their edges.
Tessellation tessellate(const Mesh& mesh, int cuts = 8);

/// The number of pieces per edge for nodes at `x`: enough that no edge deviates from its curve by more than
/// 1e-3 of its length, unless there are too many cells for that. Meshes with few cells get more pieces. 1 for
/// order 1.
int cuts_for(const Mesh& mesh, const Points& x);

/// The outlines of a set of cells (ascending) as closed lines of shown points, in order. On a map a cell may
/// have two; for solids they surround the visible faces.
std::vector<std::vector<std::uint32_t>> cell_outlines(const Tessellation& tessellation,
                                                      std::span<const std::uint32_t> cells);

/// Cell values at the shown points: the mean over the adjacent triangles (segments if cells are lines), 0 for
/// points without cells.
std::vector<double> point_means(const Tessellation& tessellation, std::span<const double> cells);

/// The shown points for node positions `nodes` (mesh numbering).
Points shown_points(const Tessellation& tessellation, const Points& nodes);
/// The same into an existing array.
void put_shown_points(const Tessellation& tessellation, const Points& nodes, Points& shown);
/// The values of a nodal field at the shown points.
std::vector<double> shown_values(const Tessellation& tessellation, std::span<const double> nodes);

} // namespace gaspard
