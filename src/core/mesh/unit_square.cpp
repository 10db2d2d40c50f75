#include "core/base/check.hpp"
#include "core/mesh/domain_type.hpp"
#include "core/mesh/mesh.hpp"

namespace gaspard {

Mesh unit_square_mesh(int n) {
    GASPARD_CHECK(n > 0);
    const auto side = static_cast<std::size_t>(n) + 1;
    Mesh mesh{.kind = {CellShape::quadrilateral, 1},
              .space_dimension = 2,
              .nodes = Points(side * side),
              .cells = {}};
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i)
            mesh.nodes.set(j * side + i, {static_cast<double>(i) / n, static_cast<double>(j) / n, 0});
    mesh.cells.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n) * 4);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int corner = j * (n + 1) + i;
            mesh.cells.insert(mesh.cells.end(), {corner, corner + 1, corner + n + 2, corner + n + 1});
        }
    return mesh;
}

DomainType plane_domain() {
    return {.name = "plane",
            .label = "Plane",
            .help = "the unit square, divided into n x n squares",
            .rows = {{.key = "boundary",
                      .label = "Boundary",
                      .kind = ParameterKind::choice,
                      .default_value = std::string("periodic"),
                      .choices = {"periodic", "walls"},
                      .help = "periodic: opposite sides are identified; walls: nodes slide along the sides"},
                     {.key = "cells",
                      .label = "Cells per side",
                      .symbol = "n",
                      .kind = ParameterKind::integer,
                      .minimum = 4,
                      .maximum = 480,
                      .scale = ParameterScale::logarithmic,
                      .default_value = std::int64_t{60},
                      .help = "the mesh has n x n cells"}},
            .space = [](const Values& values, const DomainContent&) {
                return Space{values.text("boundary") == "periodic" ? SpaceKind::periodic_square
                                                                   : SpaceKind::euclidean};
            }};
}

} // namespace gaspard
