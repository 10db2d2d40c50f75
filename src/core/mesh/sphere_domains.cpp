#include "core/mesh/domain_type.hpp"
#include "core/mesh/sphere_mesh.hpp"

namespace gaspard {

namespace {

std::vector<ParameterRow> common_rows() {
    return {{.key = "geometry_order",
             .label = "Geometry order",
             .kind = ParameterKind::integer,
             .minimum = 1,
             .maximum = 2,
             .default_value = std::int64_t{2},
             .help =
                 "1: straight edges between vertices, 2: curved cells with nodes between them; with 1 strong "
                 "monitors blow up",
             .remedy = std::int64_t{2}},
            {.key = "radius",
             .label = "Radius",
             .symbol = "R",
             .unit = "length",
             .minimum = 1e-3,
             .maximum = 1e9,
             .scale = ParameterScale::logarithmic,
             .default_value = 1.0,
             .help = "of the sphere; it scales the result and changes nothing else"},
            {.key = "monitor_nodes",
             .label = "Monitor nodes",
             .kind = ParameterKind::choice,
             .default_value = std::string("all"),
             .choices = {"all", "vertices"},
             .help = "where the monitor is taken for integrals: at all nodes of the cells, or linear between "
                     "vertices"}};
}

Space sphere_space(const Values&) { return {SpaceKind::sphere}; }

} // namespace

DomainType cubed_sphere_domain() {
    std::vector<ParameterRow> rows = {{.key = "cells",
                                       .label = "Cells per side",
                                       .symbol = "k",
                                       .kind = ParameterKind::integer,
                                       .minimum = 2,
                                       .maximum = 128,
                                       .scale = ParameterScale::logarithmic,
                                       .default_value = std::int64_t{16},
                                       .help = "of each of the cube's six sides: 6 k^2 quadrilaterals"},
                                      {.key = "mid_nodes",
                                       .label = "Nodes between",
                                       .kind = ParameterKind::choice,
                                       .default_value = std::string("normalised"),
                                       .choices = {"normalised", "equiangular"},
                                       .help =
                                           "nodes between vertices: halfway and pushed out to the sphere, or "
                                           "halfway in angle"}};
    for (auto& row : common_rows()) rows.push_back(std::move(row));
    return {.name = "cubed-sphere",
            .label = "Cubed sphere",
            .help = "a sphere of quadrilaterals, from the six sides of a cube",
            .rows = std::move(rows),
            .space = sphere_space};
}

DomainType icosahedral_sphere_domain() {
    std::vector<ParameterRow> rows = {{.key = "refinements",
                                       .label = "Refinements",
                                       .kind = ParameterKind::integer,
                                       .minimum = 0,
                                       .maximum = 7,
                                       .default_value = std::int64_t{4},
                                       .help = "of the icosahedron, each into four: 20 4^r triangles"}};
    for (auto& row : common_rows()) rows.push_back(std::move(row));
    return {.name = "icosahedral-sphere",
            .label = "Icosahedral sphere",
            .help = "a sphere of triangles, from a refined icosahedron",
            .rows = std::move(rows),
            .space = sphere_space};
}

SphereGrid cubed_sphere_grid(const Values& values) {
    return {SphereCells::cubed, static_cast<int>(values.integer("cells")),
            values.text("mid_nodes") == "normalised" ? MidNodes::normalised : MidNodes::equiangular};
}

SphereGrid icosahedral_sphere_grid(const Values& values) {
    return {SphereCells::icosahedral, static_cast<int>(values.integer("refinements"))};
}

} // namespace gaspard
