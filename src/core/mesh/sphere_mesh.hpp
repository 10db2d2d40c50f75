// Meshes of the unit sphere with quadratic cells, oriented outward: the equiangular gnomonic cubed sphere
// (6 k^2 quadrilaterals) and the refined icosahedron (20 4^r triangles).
//
// Node numbering: vertices, then one node per edge, then one per quadrilateral. The first nodes alone are
// thus the nodes of a mesh of order 1.
#pragma once

#include "core/base/export.hpp"
#include "core/mesh/mesh.hpp"

namespace gaspard GASPARD_API {

enum class SphereCells { cubed, icosahedral };

/// Placement of the nodes on edges and in cells. normalised: the mean of the two end points (of the four
/// corners in a cell), projected onto the sphere. equiangular (cubed sphere only): the midpoint in both
/// gnomonic angles.
enum class MidNodes { normalised, equiangular };

struct SphereGrid {
    SphereCells cells = SphereCells::cubed;
    int resolution = 16; ///< k, or the number r of refinements of the icosahedron
    MidNodes mid_nodes = MidNodes::normalised;

    friend bool operator==(const SphereGrid&, const SphereGrid&) = default;
};

/// A closed surface of quadratic cells.
struct SurfaceMesh {
    Mesh quadratic; ///< of order 2
    std::size_t vertex_count = 0;
};

SurfaceMesh sphere_mesh(const SphereGrid& grid);

/// The same cells with order 1: straight edges between the vertices.
Mesh straightened(const SurfaceMesh& surface);

/// The cell that contains a point, and the point's reference coordinates in it. The coordinates are those of
/// cells with great circles as edges, uniformly divided; their error is of second order in the cell size.
struct CellPlace {
    std::size_t cell = 0;
    Vec3 at;
};
/// `direction` is a nonzero vector of any length.
CellPlace locate(const SphereGrid& grid, Vec3 direction);

} // namespace GASPARD_API
