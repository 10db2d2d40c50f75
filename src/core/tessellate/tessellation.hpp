// What eye and files need of a mesh: points to show, triangles that fill the cells, segments that draw their
// edges.
//
// The structure is made once per mesh; positions and node fields follow a snapshot through fixed weights:
//   shown point p = sum over j of w_pj * node j
// Cells of order 1 in the plane need no further points (p = node); curved edges and faces are cut finer.
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
    /// Of a map of this tessellation (core/tessellate/sphere_map.hpp): its points come first here, and what
    /// they are made of stands there. Else null.
    std::shared_ptr<const Tessellation> base;

    /// The node that a shown point is; nothing for points on curved edges and faces, and on cuts.
    std::optional<std::uint32_t> node_of(std::uint32_t point) const;
};

/// `cuts` pieces per curved edge (order 2 only). Of solids, the boundary faces and all edges of those faces.
Tessellation tessellate(const Mesh& mesh, int cuts = 8);

/// How many pieces per edge show a mesh whose nodes stand at `x` well: so many that no edge strays from its
/// curve by more than a thousandth of its length, as long as there are not too many cells for that. Fewer are
/// not worth saving where cells are few. 1 for order 1.
int cuts_for(const Mesh& mesh, const Points& x);

/// Closed lines of shown points around cells (ascending), in order; on a map a cell may have two, of a solid
/// they surround the shown faces.
std::vector<std::vector<std::uint32_t>> cell_outlines(const Tessellation& tessellation,
                                                      std::span<const std::uint32_t> cells);

/// For what belongs to cells, at the shown points: the mean of the triangles around each (of the segments
/// where there are only those). Points in no cell get 0.
std::vector<double> point_means(const Tessellation& tessellation, std::span<const double> cells);

/// The shown points for given node positions (mesh numbering).
Points shown_points(const Tessellation& tessellation, const Points& nodes);
/// The same into room that is there already.
void put_shown_points(const Tessellation& tessellation, const Points& nodes, Points& shown);
/// The shown values of a node field.
std::vector<double> shown_values(const Tessellation& tessellation, std::span<const double> nodes);

} // namespace gaspard
