// The periodic unit square as a flat surface of quadratic cells, squares or triangles (each square divided
// along one diagonal), for the surface elements.
#pragma once

#include "core/fem/surface_q2.hpp"

namespace gaspard {

inline SurfaceSetup periodic_surface(int n, CellShape shape, int geometry_order = 1) {
    const std::int32_t side = 2 * n + 1; // nodes on the lattice of half cells
    const auto vertex = [](std::int32_t i, std::int32_t j) { return i % 2 == 0 && j % 2 == 0; };
    std::vector<std::int32_t> number(static_cast<std::size_t>(side * side), -1), unknowns;
    std::vector<Vec3> nodes;
    const auto at = [&](std::int32_t i, std::int32_t j) -> std::int32_t& {
        return number[static_cast<std::size_t>(j * side + i)];
    };
    SurfaceSetup setup{.mesh = {{.kind = {shape, 2}, .space_dimension = 2, .nodes = {}, .cells = {}}, 0},
                       .shape = SurfaceShape::flat,
                       .geometry_order = geometry_order,
                       .monitor_at_vertices = geometry_order == 1};
    std::int32_t next = 0;
    for (const bool vertices : {true, false}) {
        std::vector<std::int32_t> of(static_cast<std::size_t>(4 * n * n), -1); // by position on the torus
        for (std::int32_t j = 0; j < side; ++j)
            for (std::int32_t i = 0; i < side; ++i) {
                if (vertex(i, j) != vertices) continue;
                at(i, j) = static_cast<std::int32_t>(nodes.size());
                nodes.push_back({i / (2.0 * n), j / (2.0 * n), 0});
                auto& unknown = of[static_cast<std::size_t>(j % (2 * n) * 2 * n + i % (2 * n))];
                if (unknown < 0) unknown = next++;
                unknowns.push_back(unknown);
            }
        if (vertices) setup.mesh.vertex_count = nodes.size();
    }
    auto& mesh = setup.mesh.quadratic;
    mesh.nodes = Points(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) mesh.nodes.set(i, nodes[i]);
    for (std::int32_t j = 0; j < 2 * n; j += 2)
        for (std::int32_t i = 0; i < 2 * n; i += 2) {
            const auto add = [&](std::initializer_list<std::pair<int, int>> places) {
                for (const auto& [a, b] : places) mesh.cells.push_back(at(i + a, j + b));
            };
            if (shape == CellShape::quadrilateral) {
                add({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}});
            } else {
                add({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {2, 1}, {1, 1}});
                add({{0, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 2}, {0, 1}});
            }
        }
    setup.unknowns = std::move(unknowns);
    return setup;
}

} // namespace gaspard
