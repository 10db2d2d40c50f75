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
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr int point_type = 15;

/// Gmsh numbers a quadrilateral's nodes ring by ring from outside: corners, then edges around it.
std::vector<int> rings(int order) {
    const auto ours = [order](int i, int j) { // column, row
        const auto nodes = reference_nodes({CellShape::quadrilateral, order});
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (std::lround(order * nodes[k].x) == i && std::lround(order * nodes[k].y) == j)
                return static_cast<int>(k);
        check_failed("every column and row of a cell has a node");
    };
    std::vector<int> all;
    for (int low = 0, high = order; low <= high; ++low, --high) {
        if (low == high) all.push_back(ours(low, low));
        if (low >= high) break;
        for (const auto& [i, j] : {std::pair(low, low), {high, low}, {high, high}, {low, high}})
            all.push_back(ours(i, j));
        for (int k = low + 1; k < high; ++k) all.push_back(ours(k, low));
        for (int k = low + 1; k < high; ++k) all.push_back(ours(high, k));
        for (int k = high - 1; k > low; --k) all.push_back(ours(k, high));
        for (int k = high - 1; k > low; --k) all.push_back(ours(low, k));
    }
    return all;
}

/// Which of our nodes Gmsh wants at each place. It differs from VTK in the edges and faces of curved solids,
/// and in edges and interiors from order 3 on.
std::vector<int> gmsh_order(CellKind kind) {
    if (kind == CellKind{CellShape::hexahedron, 2})
        return {0,  1,  2,  3,  4,  5,  6,  7,                  // corners
                8,  11, 16, 9,  17, 10, 18, 19, 12, 15, 13, 14, // edges
                24, 22, 20, 21, 23, 25, 26};                    // faces, interior
    if (kind.shape == CellShape::quadrilateral) return rings(kind.order);
    std::vector<int> same;
    for (int i = 0; i < nodes_per_cell(kind); ++i) same.push_back(i);
    return same;
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
    const int type = facets.nodes_each == 1 ? point_type : cell_type_numbers(facets.kind).gmsh;
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (const std::size_t f : groups[g].facets)
            append_element(text, ++number, type, 2 + g, facets[f], {});
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
