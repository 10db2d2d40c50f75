// Cells of dimension 1 to 3 and order 1 or 2, lines and quadrilaterals up to order 7, and a mesh of cells of
// one kind, in plain arrays.
//
// A Mesh is the computational mesh with nodes xi. The physical mesh has the same cells and other positions x
// of the same nodes. A periodic domain is unwrapped: it has nodes on both sides, which only the function
// spaces identify.
#pragma once

#include "core/base/export.hpp"
#include "core/base/points.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

enum class CellShape { line, triangle, quadrilateral, hexahedron };

inline constexpr int highest_order = 7; ///< of lines and quadrilaterals; 2 for other shapes

/// Shape and order of a cell. Nodes are equidistant and numbered as in VTK: corners, edges, faces, interior.
/// Of a quadrilateral of order 3 or higher (a Lagrange cell), those on edges run in the direction of s or t,
/// those of the interior by rows.
struct CellKind {
    CellShape shape = CellShape::quadrilateral;
    /// 1: straight edges; k: k - 1 more nodes per edge, (k - 1)^2 per face of quadrilaterals and hexahedra
    int order = 1;

    friend bool operator==(const CellKind&, const CellKind&) = default;
};

int cell_dimension(CellKind kind);
int corners_per_cell(CellKind kind);
int nodes_per_cell(CellKind kind);
std::string cell_name(CellKind kind); ///< "quadrilateral, order 2"

/// Coordinates of the nodes in the reference cell: [0,1]^d, or the triangle (0,0), (1,0), (0,1).
std::span<const Vec3> reference_nodes(CellKind kind);

/// Shape functions and their derivatives at a point of the reference cell. Both spans have nodes_per_cell
/// entries; gradients[i] = (d/ds, d/dt, d/du) with (s, t, u) the reference coordinates.
void shape_functions(CellKind kind, Vec3 point, std::span<double> values, std::span<Vec3> gradients);

/// The edges of one cell as local node numbers: the ends, then those between, from the first end on.
std::span<const std::vector<int>> cell_edges(CellKind kind);
/// The faces of a three-dimensional cell as local corner numbers, counter-clockwise as seen from outside;
/// empty for lines and surface cells.
std::span<const std::vector<int>> cell_faces(CellKind kind);

struct Mesh {
    CellKind kind;
    int space_dimension = 2;         ///< 1, 2 or 3; further coordinates are zero
    Points nodes;                    ///< xi
    std::vector<std::int32_t> cells; ///< nodes_per_cell node numbers per cell
    /// If the cells are a lattice, their numbers in its directions, the first running fastest; else zeros.
    std::array<std::int32_t, 3> lattice{};

    std::size_t node_count() const { return nodes.size(); }
    std::size_t cell_count() const { return cells.size() / static_cast<std::size_t>(nodes_per_cell(kind)); }
    std::span<const std::int32_t> cell(std::size_t i) const {
        const auto n = static_cast<std::size_t>(nodes_per_cell(kind));
        return {cells.data() + i * n, n};
    }
};

/// The unit square divided into n x n squares. Node (i, j) has number j (n + 1) + i, cell (i, j) number j n +
/// i.
Mesh unit_square_mesh(int n);

} // namespace GASPARD_API
