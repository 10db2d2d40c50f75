// Small explicit meshes of every cell shape, and displaced positions.
#pragma once

#include "core/mesh/mesh.hpp"

#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <vector>

namespace gaspard {

inline Mesh mesh_of(CellKind kind, int dimension, std::initializer_list<Vec3> nodes,
                    std::vector<std::int32_t> cells) {
    Mesh mesh;
    mesh.kind = kind;
    mesh.space_dimension = dimension;
    mesh.nodes = Points(nodes.size());
    std::size_t i = 0;
    for (const Vec3 node : nodes) mesh.nodes.set(i++, node);
    mesh.cells = std::move(cells);
    return mesh;
}

/// [0, 1] with three line cells; nodes not in ascending order.
inline Mesh three_lines() {
    return mesh_of({CellShape::line, 1}, 1, {{0, 0, 0}, {1, 0, 0}, {0.25, 0, 0}, {2.0 / 3, 0, 0}},
                   {0, 2, 2, 3, 3, 1});
}

/// The unit square as two triangles.
inline Mesh two_triangles() {
    return mesh_of({CellShape::triangle, 1}, 2, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                   {0, 1, 2, 0, 2, 3});
}

/// One square of order 2 whose first nodes are not corners.
inline Mesh curved_square() {
    return mesh_of({CellShape::quadrilateral, 2}, 3,
                   {{.5, .5, .1},
                    {.5, 0, .1},
                    {0, 0, 0},
                    {1, 0, 0},
                    {1, 1, 0},
                    {0, 1, 0},
                    {1, .5, 0},
                    {.5, 1, 0},
                    {0, .5, 0}},
                   {2, 3, 4, 5, 1, 6, 7, 8, 0});
}

/// Two adjacent cubes.
inline Mesh two_cubes() {
    return mesh_of({CellShape::hexahedron, 1}, 3,
                   {{0, 0, 0},
                    {1, 0, 0},
                    {2, 0, 0},
                    {0, 1, 0},
                    {1, 1, 0},
                    {2, 1, 0},
                    {0, 0, 1},
                    {1, 0, 1},
                    {2, 0, 1},
                    {0, 1, 1},
                    {1, 1, 1},
                    {2, 1, 1}},
                   {0, 1, 4, 3, 6, 7, 10, 9, 1, 2, 5, 4, 7, 8, 11, 10});
}

/// The same cells with order 2. Requires coordinates whose means are exact in floating point.
inline Mesh of_order_two(const Mesh& straight) {
    Mesh mesh;
    mesh.kind = {straight.kind.shape, 2};
    mesh.space_dimension = straight.space_dimension;
    std::map<std::array<double, 3>, std::int32_t> numbers;
    const auto corners = static_cast<std::size_t>(nodes_per_cell(straight.kind));
    std::vector<double> values(corners);
    std::vector<Vec3> gradients(corners), nodes;
    for (std::size_t c = 0; c < straight.cell_count(); ++c)
        for (const Vec3 where : reference_nodes(mesh.kind)) {
            shape_functions(straight.kind, where, values, gradients);
            Vec3 p;
            for (std::size_t k = 0; k < corners; ++k)
                p = p + values[k] * straight.nodes[static_cast<std::size_t>(straight.cell(c)[k])];
            const auto [entry, fresh] =
                numbers.try_emplace({p.x, p.y, p.z}, static_cast<std::int32_t>(nodes.size()));
            if (fresh) nodes.push_back(p);
            mesh.cells.push_back(entry->second);
        }
    mesh.nodes = Points(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) mesh.nodes.set(i, nodes[i]);
    return mesh;
}

/// The unit sphere as eight outward-facing triangles of order 2 with all nodes on the sphere.
inline Mesh round_octahedron() {
    const Mesh straight = mesh_of({CellShape::triangle, 1}, 3,
                                  {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                                  {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5});
    Mesh mesh = of_order_two(straight);
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
        mesh.nodes.set(i, (1 / norm(mesh.nodes[i])) * mesh.nodes[i]);
    return mesh;
}

/// Two or more cells of every kind.
inline std::vector<Mesh> meshes_of_every_kind() {
    Mesh lines = three_lines();
    lines.nodes.x[3] = 0.625; // exact in binary, for of_order_two()
    std::vector<Mesh> meshes = {lines, two_triangles(), unit_square_mesh(2), two_cubes()};
    for (std::size_t i = 0; i < 4; ++i) meshes.push_back(of_order_two(meshes[i]));
    return meshes;
}

/// Displaces every node slightly, to values that single precision cannot represent.
inline Points moved(const Mesh& mesh) {
    Points x = mesh.nodes;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 p = x[i];
        const int d = mesh.space_dimension;
        x.set(i,
              {p.x + 0.01 * std::sin(3.0 + 7 * p.x + p.y), d > 1 ? p.y + 0.02 * std::cos(p.x + 5 * p.y) : 0,
               d > 2 ? p.z + 0.03 * std::sin(1 + p.x) : 0});
    }
    return x;
}

} // namespace gaspard
