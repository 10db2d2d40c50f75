// adapted.msh: Gmsh's mesh file of version 2.2 as text, the version that Gmsh and most finite element codes
// read. Cells have the numbers 1 to n in our order; behind them come the elements of the border. Fields of
// cells are left out: meshio, the way into FEniCS, reads no $ElementData where a file has elements of two
// kinds.
#include "core/base/check.hpp"
#include "core/base/parameter.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/cell_types.hpp"
#include "core/io/facets.hpp"
#include "core/io/formats.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace gaspard {

namespace {

constexpr int point_type = 15;

using Lattice = std::array<int, 3>; // place of a node in its cell, in units of 1 / order

Lattice between(const Lattice& a, const Lattice& b, int step, int steps) {
    Lattice at = a;
    for (std::size_t d = 0; d < 3; ++d) at[d] += (b[d] - a[d]) / steps * step;
    return at;
}

/// Gmsh numbers a quadrilateral's nodes ring by ring from outside: corners, then edges around it. `length`:
/// its order.
void append_rings(std::array<Lattice, 4> corners, int length, std::vector<Lattice>& all) {
    for (; length > 0; length -= 2) {
        all.insert(all.end(), corners.begin(), corners.end());
        for (std::size_t e = 0; e < 4; ++e)
            for (int k = 1; k < length; ++k)
                all.push_back(between(corners[e], corners[(e + 1) % 4], k, length));
        std::array<Lattice, 4> inner{};
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t d = 0; d < 3; ++d) {
                const int on = corners[(c + 1) % 4][d] + corners[(c + 3) % 4][d] - 2 * corners[c][d];
                inner[c][d] = corners[c][d] + on / length;
            }
        corners = inner;
    }
    if (length == 0) all.push_back(corners[0]);
}

/// The same for hexahedra, shell by shell: corners, edges, the insides of faces.
void append_shells(int low, int high, std::vector<Lattice>& all) {
    if (low == high) all.push_back({low, low, low});
    if (low >= high) return;
    static constexpr int edges[12][2] = {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3},
                                         {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
    static constexpr int faces[6][4] = {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3},
                                        {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}};
    std::array<Lattice, 8> corners{};
    for (std::size_t c = 0; c < 8; ++c) {
        const Vec3 at = reference_nodes({CellShape::hexahedron, 1})[c];
        corners[c] = {at.x > 0 ? high : low, at.y > 0 ? high : low, at.z > 0 ? high : low};
    }
    const auto corner = [&](int c) { return corners[static_cast<std::size_t>(c)]; };
    all.insert(all.end(), corners.begin(), corners.end());
    for (const auto& [a, b] : edges)
        for (int k = 1; k < high - low; ++k) all.push_back(between(corner(a), corner(b), k, high - low));
    for (const auto& face : faces) {
        std::vector<Lattice> whole; // corners and edges, then what is wanted
        append_rings({corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3])}, high - low, whole);
        all.insert(all.end(), whole.begin() + 4 * (high - low), whole.end());
    }
    append_shells(low + 1, high - 1, all);
}

/// Which of our nodes Gmsh wants at each place. It differs from VTK in the edges and faces of curved solids,
/// and in edges and interiors from order 3 on.
std::vector<int> gmsh_order(CellKind kind) {
    const int order = kind.order;
    std::vector<Lattice> places;
    if (kind.shape == CellShape::hexahedron) append_shells(0, order, places);
    if (kind.shape == CellShape::quadrilateral)
        append_rings({Lattice{0, 0, 0}, {order, 0, 0}, {order, order, 0}, {0, order, 0}}, order, places);
    std::map<Lattice, int> ours;
    for (int i = 0; i < nodes_per_cell(kind); ++i) {
        const Vec3 at = order * reference_nodes(kind)[static_cast<std::size_t>(i)];
        ours[{static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)),
              static_cast<int>(std::lround(at.z))}] = i;
    }
    std::vector<int> numbers;
    for (const Lattice& place : places) numbers.push_back(ours.at(place));
    return numbers;
}

void append_reals(std::string& text, std::initializer_list<double> values) {
    for (const double value : values) {
        GASPARD_CHECK(std::isfinite(value));
        text += ' ' + format_number(value);
    }
}

std::string physical_names(const Mesh& mesh, const std::vector<BorderGroup>& groups) {
    const int dimension = cell_dimension(mesh.kind);
    std::string text = "$PhysicalNames\n" + std::to_string(1 + groups.size()) + '\n';
    text += std::to_string(dimension) + " 1 \"domain\"\n";
    for (std::size_t g = 0; g < groups.size(); ++g)
        text += std::to_string(dimension - 1) + ' ' + std::to_string(2 + g) + " \"" + groups[g].name + "\"\n";
    return text + "$EndPhysicalNames\n";
}

std::string nodes(const Points& x) {
    std::string text = "$Nodes\n" + std::to_string(x.size()) + '\n';
    for (std::size_t i = 0; i < x.size(); ++i) {
        text += std::to_string(i + 1);
        append_reals(text, {x.x[i], x.y[i], x.z[i]});
        text += '\n';
    }
    return text + "$EndNodes\n";
}

/// Physical group and geometrical entity have the same number.
void append_element(std::string& text, std::size_t number, int type, std::size_t group,
                    std::span<const std::int32_t> nodes, std::span<const int> order) {
    const std::string tag = std::to_string(group);
    text += std::to_string(number) + ' ' + std::to_string(type) + " 2 " + tag + ' ' + tag;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        text += ' ' + std::to_string(nodes[order.empty() ? i : static_cast<std::size_t>(order[i])] + 1);
    text += '\n';
}

std::string elements(const Mesh& mesh, const Facets& facets, const std::vector<BorderGroup>& groups) {
    std::string text = "$Elements\n" + std::to_string(mesh.cell_count() + facets.size()) + '\n';
    const auto order = gmsh_order(mesh.kind);
    std::size_t number = 0;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        append_element(text, ++number, cell_type_numbers(mesh.kind).gmsh, 1, mesh.cell(c), order);
    const auto facet_order = facets.nodes_each == 1 ? std::vector<int>() : gmsh_order(facets.kind);
    const int type = facets.nodes_each == 1 ? point_type : cell_type_numbers(facets.kind).gmsh;
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (const std::size_t f : groups[g].facets)
            append_element(text, ++number, type, 2 + g, facets[f], facet_order);
    return text + "$EndElements\n";
}

/// Nodes of one side and those that they are copies of, along the side.
std::vector<std::pair<std::int32_t, std::int32_t>> copies(const Mesh& mesh, const Facets& facets,
                                                          const BorderGroup& copy,
                                                          const BorderGroup& original,
                                                          std::vector<double> Points::*along) {
    const auto nodes_of = [&](const BorderGroup& group) {
        std::vector<std::int32_t> nodes;
        for (const std::size_t f : group.facets)
            nodes.insert(nodes.end(), facets[f].begin(), facets[f].end());
        std::sort(nodes.begin(), nodes.end(), [&](std::int32_t a, std::int32_t b) {
            const auto& values = mesh.nodes.*along;
            return values[static_cast<std::size_t>(a)] < values[static_cast<std::size_t>(b)];
        });
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        return nodes;
    };
    const auto from = nodes_of(copy), to = nodes_of(original);
    GASPARD_CHECK(from.size() == to.size());
    std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
    for (std::size_t i = 0; i < from.size(); ++i) pairs.emplace_back(from[i], to[i]);
    return pairs;
}

/// The sides of a periodic square: right is a copy of left, top of bottom.
std::string periodic(const Mesh& mesh, const Facets& facets, const std::vector<BorderGroup>& groups) {
    GASPARD_CHECK(groups.size() == 4); // left, right, bottom, top
    std::string text = "$Periodic\n2\n";
    for (const std::size_t original : {0u, 2u}) {
        const std::size_t copy = original + 1;
        text += "1 " + std::to_string(2 + copy) + ' ' + std::to_string(2 + original) + '\n';
        text += original == 0 ? "Affine 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1\n"
                              : "Affine 1 0 0 0 0 1 0 1 0 0 1 0 0 0 0 1\n";
        const auto pairs =
            copies(mesh, facets, groups[copy], groups[original], original == 0 ? &Points::y : &Points::x);
        text += std::to_string(pairs.size()) + '\n';
        for (const auto& [from, to] : pairs)
            text += std::to_string(from + 1) + ' ' + std::to_string(to + 1) + '\n';
    }
    return text + "$EndPeriodic\n";
}

/// One row per node: its number and the components of its value.
std::string node_data(const std::string& name, const std::vector<std::span<const double>>& components) {
    const std::size_t rows = components.front().size();
    std::string text = "$NodeData\n1\n\"" + name + "\"\n1\n0\n3\n0\n" + // one name, one time, three numbers:
                       std::to_string(components.size()) + '\n' + std::to_string(rows) + '\n'; // step 0, ...
    for (std::size_t i = 0; i < rows; ++i) {
        text += std::to_string(i + 1);
        for (const auto& component : components) append_reals(text, {component[i]});
        text += '\n';
    }
    return text + "$EndNodeData\n";
}

std::string node_data(const std::string& name, const Points& points) {
    return node_data(name, {points.x, points.y, points.z});
}

} // namespace

void write_msh(const std::filesystem::path& file, const Snapshot& snapshot, const Space& space) {
    const Mesh& mesh = *snapshot.mesh;
    GASPARD_CHECK(snapshot.x.size() == mesh.node_count());
    const Facets facets = border(mesh);
    const auto groups = border_groups(mesh, facets);
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    text += physical_names(mesh, groups) + nodes(snapshot.x) + elements(mesh, facets, groups);
    if (space.kind == SpaceKind::periodic_square) text += periodic(mesh, facets, groups);
    for (const auto& field : snapshot.fields)
        if (field.place == FieldPlace::node) text += node_data(field.name, {std::span(field.values)});
    text += node_data("displacement", snapshot.x - mesh.nodes) + node_data("xi", mesh.nodes);
    write_atomically(file, text);
}

} // namespace gaspard
