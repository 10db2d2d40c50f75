// Visible faces and boundary facets of a mesh, and names for the sides of a box.
//
// A facet is shared by two neighbouring cells: a point between line cells, an edge between surface cells, a
// face between solid cells. Its nodes are ordered like those of a cell of its own kind (corners, edges,
// interior) and oriented so that the domain lies to the left of an edge and behind a face.
#pragma once

#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

struct Facets {
    CellKind kind;      ///< of the facets; meaningless for the end points of lines
    int corners = 1;    ///< corners per facet
    int nodes_each = 1; ///< nodes per facet; 1 for points
    std::vector<std::int32_t> nodes;
    std::vector<std::uint32_t> cells; ///< the cell of each facet

    std::size_t size() const { return cells.size(); }
    std::span<const std::int32_t> operator[](std::size_t i) const {
        const auto n = static_cast<std::size_t>(nodes_each);
        return {nodes.data() + i * n, n};
    }
};

/// The facets that belong to exactly one cell, in the order of cells. Empty for a sphere. An edge that is one
/// point, such as the tip of a cone, is none.
Facets border(const Mesh& mesh);

/// The visible faces: the cells of a surface, the boundary of solids; empty for lines.
Facets shown_faces(const Mesh& mesh);

/// The corners of all cells.
std::vector<std::int32_t> corners_of_cells(const Mesh& mesh);

struct BorderGroup {
    std::string name;
    std::vector<std::size_t> facets;
};

/// Groups of boundary facets. If every facet lies on a side of the bounding box of the computational mesh
/// (square, cube, interval), one group per side: left, right (min and max x), bottom, top (y in the plane, z
/// in space), front, back (y in space). Otherwise one group "boundary". Empty if there is no boundary.
std::vector<BorderGroup> border_groups(const Mesh& mesh, const Facets& facets);

} // namespace gaspard
