#include "core/io/facets.hpp"

#include "core/base/check.hpp"
#include "core/mesh/surface_topology.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace gaspard {

namespace {

/// The facets of one cell as lists of local node numbers.
using LocalFacets = std::vector<std::vector<int>>;

/// The node of a solid cell at a place of the reference cell.
int node_at(CellKind kind, Vec3 where) {
    const auto nodes = reference_nodes(kind);
    const auto found = std::find_if(nodes.begin(), nodes.end(), [&](Vec3 node) {
        return norm(node - where) < 1e-3; // far less than between nodes
    });
    GASPARD_CHECK(found != nodes.end());
    return static_cast<int>(found - nodes.begin());
}

/// The faces of a hexahedron with all their nodes.
LocalFacets whole_faces(CellKind kind) {
    const auto nodes = reference_nodes(kind);
    LocalFacets faces;
    for (const auto& corners : cell_faces(kind)) {
        const auto corner = [&](std::size_t i) { return nodes[static_cast<std::size_t>(corners[i])]; };
        auto& face = faces.emplace_back();
        for (const Vec3 at : reference_nodes({CellShape::quadrilateral, kind.order}))
            face.push_back(
                node_at(kind, corner(0) + at.x * (corner(1) - corner(0)) + at.y * (corner(3) - corner(0))));
    }
    return faces;
}

LocalFacets local_facets(CellKind kind) {
    if (cell_dimension(kind) == 3) return whole_faces(kind);
    if (cell_dimension(kind) == 1) return {{0}, {1}};
    const auto edges = cell_edges(kind);
    return {edges.begin(), edges.end()};
}

Facets no_facets(CellKind cell) {
    Facets facets;
    facets.kind = {cell_dimension(cell) == 3 ? CellShape::quadrilateral : CellShape::line, cell.order};
    if (cell_dimension(cell) == 1) return facets;
    facets.corners = corners_per_cell(facets.kind);
    facets.nodes_each = nodes_per_cell(facets.kind);
    return facets;
}

struct Candidate {
    std::array<std::int32_t, 4> corners{-1, -1, -1, -1}; ///< sorted: equal for both cells of the facet
    std::uint32_t cell = 0, local = 0;
};

std::vector<Candidate> candidates(const Mesh& mesh, const LocalFacets& local, std::size_t corners) {
    std::vector<Candidate> all;
    all.reserve(mesh.cell_count() * local.size());
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        for (std::size_t f = 0; f < local.size(); ++f) {
            Candidate candidate;
            candidate.cell = static_cast<std::uint32_t>(c);
            candidate.local = static_cast<std::uint32_t>(f);
            for (std::size_t i = 0; i < corners; ++i)
                candidate.corners[i] = mesh.cell(c)[static_cast<std::size_t>(local[f][i])];
            std::sort(candidate.corners.begin(), candidate.corners.end());
            all.push_back(candidate);
        }
    return all;
}

/// The candidates that occur exactly once, in the order of cells.
std::vector<Candidate> single_candidates(const Mesh& mesh, const LocalFacets& local, std::size_t corners) {
    std::vector<Candidate> all = candidates(mesh, local, corners);
    std::sort(all.begin(), all.end(),
              [](const Candidate& a, const Candidate& b) { return a.corners < b.corners; });
    std::size_t kept = 0;
    for (std::size_t i = 0, next = 0; i < all.size(); i = next) {
        for (next = i + 1; next < all.size() && all[next].corners == all[i].corners;) ++next;
        if (next == i + 1) all[kept++] = all[i];
    }
    all.resize(kept);
    std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
        return std::pair(a.cell, a.local) < std::pair(b.cell, b.local);
    });
    return all;
}

using Coordinate = std::vector<double> Points::*;

struct BoxSide {
    const char* name;
    Coordinate coordinate;
    bool high;
};

std::vector<BoxSide> box_sides(int dimension) {
    std::vector<BoxSide> sides = {{"left", &Points::x, false}, {"right", &Points::x, true}};
    if (dimension == 2) sides.insert(sides.end(), {{"bottom", &Points::y, false}, {"top", &Points::y, true}});
    if (dimension == 3)
        sides.insert(sides.end(), {{"front", &Points::y, false},
                                   {"back", &Points::y, true},
                                   {"bottom", &Points::z, false},
                                   {"top", &Points::z, true}});
    return sides;
}

/// Whether all nodes lie on the given side of the bounding box.
bool lies_on(const Mesh& mesh, std::span<const std::int32_t> nodes, const BoxSide& side, double place,
             double slack) {
    return std::all_of(nodes.begin(), nodes.end(), [&](std::int32_t node) {
        return std::abs((mesh.nodes.*side.coordinate)[static_cast<std::size_t>(node)] - place) <= slack;
    });
}

/// The sides of surface cells that one cell alone has, in the cells' order.
std::vector<Candidate> surface_border(const Mesh& mesh) {
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    const SurfaceEdges edges = surface_edges(mesh.node_count(), corners_of_cells(mesh), corners);
    std::vector<std::uint32_t> sides;
    for (const SurfaceEdge& edge : edges.edges)
        if (edge.count == 1) sides.push_back(edges.sides[edge.first]);
    std::sort(sides.begin(), sides.end());
    std::vector<Candidate> all;
    for (const std::uint32_t side : sides) {
        Candidate candidate;
        candidate.cell = static_cast<std::uint32_t>(side / corners);
        candidate.local = static_cast<std::uint32_t>(side % corners);
        all.push_back(candidate);
    }
    return all;
}

} // namespace

Facets border(const Mesh& mesh) {
    Facets facets = no_facets(mesh.kind);
    const LocalFacets local = local_facets(mesh.kind);
    const auto all = cell_dimension(mesh.kind) == 2
                         ? surface_border(mesh)
                         : single_candidates(mesh, local, static_cast<std::size_t>(facets.corners));
    const auto is_point = [&](const auto& candidate) {
        const auto& nodes = local[candidate.local];
        const auto at = [&](int node) {
            return mesh
                .nodes[static_cast<std::size_t>(mesh.cell(candidate.cell)[static_cast<std::size_t>(node)])];
        };
        return std::all_of(nodes.begin(), nodes.end(), [&](int node) { return at(node) == at(nodes[0]); });
    };
    for (const auto& candidate : all) {
        if (cell_dimension(mesh.kind) == 2 && is_point(candidate)) continue;
        facets.cells.push_back(candidate.cell);
        for (const int node : local[candidate.local])
            facets.nodes.push_back(mesh.cell(candidate.cell)[static_cast<std::size_t>(node)]);
    }
    return facets;
}

Facets shown_faces(const Mesh& mesh) {
    if (cell_dimension(mesh.kind) == 3) return border(mesh);
    Facets faces{mesh.kind, corners_per_cell(mesh.kind), nodes_per_cell(mesh.kind), {}, {}};
    if (cell_dimension(mesh.kind) == 1) return faces;
    faces.nodes = mesh.cells;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) faces.cells.push_back(static_cast<std::uint32_t>(c));
    return faces;
}

std::vector<std::int32_t> corners_of_cells(const Mesh& mesh) {
    std::vector<std::int32_t> corners;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        const auto of_cell = mesh.cell(c).first(static_cast<std::size_t>(corners_per_cell(mesh.kind)));
        corners.insert(corners.end(), of_cell.begin(), of_cell.end());
    }
    return corners;
}

std::vector<BorderGroup> border_groups(const Mesh& mesh, const Facets& facets) {
    if (facets.size() == 0) return {};
    std::vector<BorderGroup> groups;
    std::vector<bool> named(facets.size(), false);
    if (cell_dimension(mesh.kind) == mesh.space_dimension)
        for (const auto& side : box_sides(mesh.space_dimension)) {
            const auto& values = mesh.nodes.*side.coordinate;
            const auto [low, high] = std::minmax_element(values.begin(), values.end());
            BorderGroup group{side.name, {}};
            for (std::size_t f = 0; f < facets.size(); ++f) {
                if (named[f] ||
                    !lies_on(mesh, facets[f], side, side.high ? *high : *low, 1e-12 * (*high - *low)))
                    continue;
                named[f] = true;
                group.facets.push_back(f);
            }
            groups.push_back(std::move(group));
        }
    if (std::find(named.begin(), named.end(), false) == named.end()) return groups;
    BorderGroup all{"boundary", std::vector<std::size_t>(facets.size())};
    for (std::size_t f = 0; f < facets.size(); ++f) all.facets[f] = f;
    return {all};
}

} // namespace gaspard
