// The faces that show and the facets at the border of a mesh, with names for the sides of a box.
//
// A facet is what two neighbouring cells share: a point of lines, an edge of surfaces, a face of solids. Its
// nodes are numbered as those of a cell of its own kind (corners, edges, interior), the domain lying to the
// left of an edge and behind a face.
#pragma once

#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

struct Facets {
    CellKind kind;      ///< of the facets; for the end points of lines it says nothing
    int corners = 1;    ///< of each
    int nodes_each = 1; ///< 1: points
    std::vector<std::int32_t> nodes;
    std::vector<std::uint32_t> cells; ///< the cell that each belongs to

    std::size_t size() const { return cells.size(); }
    std::span<const std::int32_t> operator[](std::size_t i) const {
        const auto n = static_cast<std::size_t>(nodes_each);
        return {nodes.data() + i * n, n};
    }
};

/// The facets that one cell alone has, in the cells' order. None of a sphere.
Facets border(const Mesh& mesh);

/// What is seen of a mesh: the cells of a surface, the border of solids; nothing of lines.
Facets shown_faces(const Mesh& mesh);

/// The corners of all cells, cell by cell.
std::vector<std::int32_t> corners_of_cells(const Mesh& mesh);

/// The nodes that are named, each once and in their order; the names become places among them.
std::vector<std::size_t> number_anew(std::vector<std::int32_t>& names, std::size_t node_count);

struct BorderGroup {
    std::string name;
    std::vector<std::size_t> facets;
};

/// Where every facet lies on a side of the box around the computational mesh (the square, the cube, the
/// interval): left and right (lowest and highest x), bottom and top (y in the plane, z in space), front and
/// back (y in space), those that there are. Elsewhere one group, "boundary". Empty without a border.
std::vector<BorderGroup> border_groups(const Mesh& mesh, const Facets& facets);

} // namespace gaspard
