#include "core/transport/boundary_loop.hpp"

#include "core/base/box.hpp"
#include "core/base/short_number.hpp"
#include "core/mesh/surface_topology.hpp"
#include "core/transport/checks.hpp"
#include "core/transport/polygon.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace gaspard {

namespace {

std::size_t node_index(std::int32_t node) { return static_cast<std::size_t>(node); }

void check_cells(const Mesh& mesh) {
    if (!(mesh.kind == CellKind{CellShape::triangle, 1}))
        throw InputError(
            "a mesh of a convex domain must consist of triangles with straight edges, not of cells \"" +
            cell_name(mesh.kind) + "\"");
    if (mesh.cells.empty()) throw InputError("the mesh has no triangles");
    if (const auto fault = fault_of(mesh.node_count(), polygon_faces(mesh)))
        throw InputError("the mesh is not one of triangles: " + *fault);
    std::vector<bool> used(mesh.node_count(), false);
    for (const auto node : mesh.cells) used[node_index(node)] = true;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
        if (!used[i]) throw InputError("node " + std::to_string(i) + " belongs to no triangle");
        const Vec3 p = mesh.nodes[i];
        for (const double coordinate : {p.x, p.y, p.z})
            check_finite(coordinate, "each coordinate of node " + std::to_string(i));
    }
}

/// Sets z to 0.
void flatten(Mesh& mesh) {
    const Box box = bounding_box(mesh.nodes);
    if (mesh.space_dimension == 3 && box.high.z - box.low.z > 1e-9 * longest_side(box))
        throw InputError("the mesh must lie in a plane z = const, but its z is between " +
                         exact_number(box.low.z) + " and " + exact_number(box.high.z));
    std::fill(mesh.nodes.z.begin(), mesh.nodes.z.end(), 0.0);
    mesh.space_dimension = 2;
    check_size(longest_side(bounding_box(mesh.nodes)), "mesh");
}

/// The boundary in the orientation of the triangles.
std::vector<std::int32_t> only_boundary(const Mesh& mesh) {
    const SurfaceTopology topology(mesh);
    if (!topology.manifold())
        throw InputError("the mesh is not a manifold: " + topology.facts(1, 0, false).front());
    if (topology.component_count() > 1)
        throw InputError("the mesh must be connected, but it has " +
                         std::to_string(topology.component_count()) + " parts");
    auto loops = topology.boundary_loops();
    if (loops.empty()) throw InputError("the mesh is a closed surface without a boundary");
    if (loops.size() > 1)
        throw InputError("the mesh must have one boundary, but it has " + std::to_string(loops.size()) +
                         ", as there are holes");
    return std::move(loops.front());
}

double area_of(const Mesh& mesh, std::size_t triangle) {
    const auto corner = [&](std::size_t k) { return mesh.nodes[node_index(mesh.cell(triangle)[k])]; };
    const Vec3 a = corner(1) - corner(0), b = corner(2) - corner(0), c = corner(2) - corner(1);
    const double twice = cross(a, b).z, longest = std::max({dot(a, a), dot(b, b), dot(c, c)});
    if (!(std::abs(twice) > 1e-10 * longest))
        throw InputError("triangle " + std::to_string(triangle) +
                         " is degenerate, its nodes lie on one line");
    return twice / 2;
}

/// Whether all triangles are clockwise.
bool clockwise(const Mesh& mesh) {
    const bool first = area_of(mesh, 0) < 0;
    for (std::size_t t = 1; t < mesh.cell_count(); ++t)
        if ((area_of(mesh, t) < 0) != first)
            throw InputError("triangles 0 and " + std::to_string(t) +
                             " have opposite orientations; all must be anticlockwise, or all clockwise");
    return first;
}

Points positions_of(const Mesh& mesh, const std::vector<std::int32_t>& nodes) {
    Points points(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) points.set(i, mesh.nodes[node_index(nodes[i])]);
    return points;
}

} // namespace

ConvexMesh convex_mesh(Mesh mesh) {
    check_cells(mesh);
    auto boundary = only_boundary(mesh);
    flatten(mesh);
    if (clockwise(mesh)) {
        for (std::size_t t = 0; t < mesh.cell_count(); ++t)
            std::swap(mesh.cells[3 * t + 1], mesh.cells[3 * t + 2]);
        std::reverse(boundary.begin() + 1, boundary.end());
    }
    const Points polygon = positions_of(mesh, boundary);
    const auto name = [&](std::size_t i) {
        return "node " + std::to_string(boundary[i]) + " at (" + exact_number(polygon.x[i]) + ", " +
               exact_number(polygon.y[i]) + ")";
    };
    if (const auto fault = convexity_fault(polygon, boundary_tolerance, name))
        throw InputError("the boundary of the mesh " + *fault);
    return {std::move(mesh), std::move(boundary)};
}

std::shared_ptr<const ConvexCurve> boundary_curve(const ConvexMesh& mesh, double radius) {
    return rounded_polygon(positions_of(mesh.mesh, mesh.boundary_nodes), radius, boundary_tolerance);
}

} // namespace gaspard
