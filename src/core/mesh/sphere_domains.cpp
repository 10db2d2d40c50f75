#include "core/mesh/domain_type.hpp"
#include "core/mesh/sphere_mesh.hpp"

namespace gaspard {

namespace {

std::vector<ParameterRow> common_rows() {
    return {
        {.key = "geometry_order",
         .label = "Geometry order",
         .kind = ParameterKind::integer,
         .minimum = 1,
         .maximum = 2,
         .default_value = std::int64_t{2},
         .help =
             "1: cells with straight edges; 2: curved cells with edge nodes; with 1 the iteration diverges "
             "for strong monitors",
         .remedy = std::int64_t{2}},
        {.key = "radius",
         .label = "Radius",
         .symbol = "R",
         .unit = "length",
         .minimum = 1e-3,
         .maximum = 1e9,
         .scale = ParameterScale::logarithmic,
         .default_value = 1.0,
         .help = "radius of the sphere; scales the result without any other effect"},
        {.key = "monitor_nodes",
         .label = "Monitor nodes",
         .kind = ParameterKind::choice,
         .default_value = std::string("all"),
         .choices = {"all", "vertices"},
         .help = "where the monitor is evaluated for integrals: at all nodes of the cells, or only at the "
                 "vertices, with linear interpolation"}};
}

Space sphere_space(const Values&, const DomainContent&) { return {SpaceKind::sphere}; }

} // namespace

DomainType cubed_sphere_domain() {
    std::vector<ParameterRow> rows = {
        {.key = "cells",
         .label = "Cells per side",
         .symbol = "k",
         .kind = ParameterKind::integer,
         .minimum = 2,
         .maximum = 128,
         .scale = ParameterScale::logarithmic,
         .default_value = std::int64_t{16},
         .help = "per side of each of the six cube faces: 6 k^2 quadrilaterals"},
        {.key = "mid_nodes",
         .label = "Edge-node placement",
         .kind = ParameterKind::choice,
         .default_value = std::string("normalised"),
         .choices = {"normalised", "equiangular"},
         .help = "nodes on edges and in cells: midpoints projected onto "
                 "the sphere, or midpoints in angle"}};
    for (auto& row : common_rows()) rows.push_back(std::move(row));
    return {.name = "cubed-sphere",
            .label = "Cubed sphere",
            .help = "a sphere of quadrilaterals: the six faces of a cube, projected",
            .rows = std::move(rows),
            .space = sphere_space};
}

DomainType icosahedral_sphere_domain() {
    std::vector<ParameterRow> rows = {
        {.key = "refinements",
         .label = "Refinements",
         .kind = ParameterKind::integer,
         .minimum = 0,
         .maximum = 7,
         .default_value = std::int64_t{4},
         .help = "each divides every triangle of the icosahedron into four: 20 4^r triangles"}};
    for (auto& row : common_rows()) rows.push_back(std::move(row));
    return {.name = "icosahedral-sphere",
            .label = "Icosahedral sphere",
            .help = "a sphere of triangles: a refined icosahedron, projected",
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
