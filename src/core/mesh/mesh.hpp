// Cells of dimension 1 to 3 and order 1 or 2, and the mesh of one kind of them, in our own arrays.
//
// A mesh is the computational one (nodes xi). The physical mesh has the same cells, with other positions x of
// the same nodes. A periodic domain is unwrapped: nodes at both sides, identified only by the function
// spaces.
#pragma once

#include "core/base/points.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

enum class CellShape { line, triangle, quadrilateral, hexahedron };

/// What one kind of cell is. Nodes are numbered as in VTK: corners, then edges, then faces, then the
/// interior.
struct CellKind {
    CellShape shape = CellShape::quadrilateral;
    int order =
        1; ///< 1: straight edges; 2: one more node per edge (and face, and cell, for squares and cubes)

    friend bool operator==(const CellKind&, const CellKind&) = default;
};

int cell_dimension(CellKind kind);
int corners_per_cell(CellKind kind);
int nodes_per_cell(CellKind kind);
std::string cell_name(CellKind kind); ///< "quadrilateral, order 2"

/// Where the nodes stand in the reference cell: [0,1]^d, or the triangle (0,0), (1,0), (0,1).
std::span<const Vec3> reference_nodes(CellKind kind);

/// Shape functions and their derivatives at a point of the reference cell.
/// `values`: nodes_per_cell; `gradients`: nodes_per_cell, d/ds, d/dt, d/du in x, y, z.
void shape_functions(CellKind kind, Vec3 point, std::span<double> values, std::span<Vec3> gradients);

/// The edges of one cell as local node numbers: two per edge of order 1, three (end, end, middle) of order 2.
std::span<const std::vector<int>> cell_edges(CellKind kind);
/// The faces of one solid cell as local corner numbers, outward and counter-clockwise; empty for lines and
/// surfaces.
std::span<const std::vector<int>> cell_faces(CellKind kind);

struct Mesh {
    CellKind kind;
    int space_dimension = 2;         ///< 1, 2 or 3: how many coordinates may differ from zero
    Points nodes;                    ///< xi
    std::vector<std::int32_t> cells; ///< nodes_per_cell numbers per cell

    std::size_t node_count() const { return nodes.size(); }
    std::size_t cell_count() const { return cells.size() / static_cast<std::size_t>(nodes_per_cell(kind)); }
    std::span<const std::int32_t> cell(std::size_t i) const {
        const auto n = static_cast<std::size_t>(nodes_per_cell(kind));
        return {cells.data() + i * n, n};
    }
};

/// The unit square cut into n x n squares; node (i, j) has number j (n + 1) + i, cell (i, j) number j n + i.
Mesh unit_square_mesh(int n);

} // namespace gaspard
