// Meshes of the unit sphere by quadratic cells, oriented outward: the cubed sphere (equiangular gnomonic,
// 6 k^2 quadrilaterals) and the refined icosahedron (20 4^r triangles).
//
// Nodes: vertices first, then one per edge, then one per quadrilateral; so the cells' corners alone are a
// mesh of order 1 on the first of them.
#pragma once

#include "core/mesh/mesh.hpp"

namespace gaspard {

enum class SphereCells { cubed, icosahedral };

/// Where the nodes on edges and in cells stand: halfway between the corners (the mean of all four for a
/// cell), pushed out to the sphere; or, on the cubed sphere, halfway in both gnomonic angles.
enum class MidNodes { normalised, equiangular };

struct SphereGrid {
    SphereCells cells = SphereCells::cubed;
    int resolution = 16; ///< k, or how often the icosahedron is refined
    MidNodes mid_nodes = MidNodes::normalised;

    friend bool operator==(const SphereGrid&, const SphereGrid&) = default;
};

/// A closed surface of quadratic cells.
struct SurfaceMesh {
    Mesh quadratic; ///< of order 2
    std::size_t vertex_count = 0;
};

SurfaceMesh sphere_mesh(const SphereGrid& grid);

/// The same cells with straight edges, on the vertices alone.
Mesh straightened(const SurfaceMesh& surface);

/// In which cell a point stands, and where in the reference cell (to a part of the cell's size that is of
/// second order in it: as if the cells' lines were great circles, evenly divided).
struct CellPlace {
    std::size_t cell = 0;
    Vec3 at;
};
/// `direction` need not be of length 1.
CellPlace locate(const SphereGrid& grid, Vec3 direction);

} // namespace gaspard
