// The numbers that file formats give the kinds of cells.
#pragma once

#include "core/base/check.hpp"
#include "core/mesh/mesh.hpp"

namespace gaspard {

struct CellTypeNumbers {
    CellKind kind;
    int vtk;  ///< nodes are numbered as ours; from order 3 on, Lagrange cells of any order
    int gmsh; ///< see msh.cpp
};

inline const CellTypeNumbers& cell_type_numbers(CellKind kind) {
    static constexpr CellTypeNumbers table[] = {
        {{CellShape::line, 1}, 3, 1},          {{CellShape::line, 2}, 21, 8},
        {{CellShape::triangle, 1}, 5, 2},      {{CellShape::triangle, 2}, 22, 9},
        {{CellShape::quadrilateral, 1}, 9, 3}, {{CellShape::quadrilateral, 2}, 28, 10},
        {{CellShape::hexahedron, 1}, 12, 5},   {{CellShape::hexahedron, 2}, 29, 12},
        {{CellShape::line, 3}, 68, 26},        {{CellShape::quadrilateral, 3}, 70, 36},
        {{CellShape::line, 4}, 68, 27},        {{CellShape::quadrilateral, 4}, 70, 37},
        {{CellShape::line, 5}, 68, 28},        {{CellShape::quadrilateral, 5}, 70, 38},
        {{CellShape::line, 6}, 68, 62},        {{CellShape::quadrilateral, 6}, 70, 47},
        {{CellShape::line, 7}, 68, 63},        {{CellShape::quadrilateral, 7}, 70, 48},
        {{CellShape::hexahedron, 3}, 72, 92},  {{CellShape::hexahedron, 4}, 72, 93},
        {{CellShape::hexahedron, 5}, 72, 94},  {{CellShape::hexahedron, 6}, 72, 95},
        {{CellShape::hexahedron, 7}, 72, 96},
    };
    for (const CellTypeNumbers& row : table)
        if (row.kind == kind) return row;
    check_failed("the kind of cell has numbers in VTK and Gmsh");
}

} // namespace gaspard
