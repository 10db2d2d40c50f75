// Lagrange shape functions and the local numbering of nodes, edges and faces (as in VTK).
#include "core/base/check.hpp"
#include "core/mesh/mesh.hpp"

#include <array>
#include <cmath>

namespace gaspard {

namespace {

// One row per kind of cell; everything else is looked up here.
struct CellTable {
    CellKind kind;
    const char* name;
    int dimension;
    int corners;
    std::vector<Vec3> nodes; ///< reference positions
    std::vector<std::vector<int>> edges;
    std::vector<std::vector<int>> faces;
};

/// Made when it is first needed, which may be before the constants of this file are.
std::vector<std::vector<int>> cube_faces() {
    return {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
}

/// VTK's Lagrange hexahedron.
CellTable hexahedron_of_order(int order) {
    CellTable cell{
        {CellShape::hexahedron, order},
        "hexahedron",
        3,
        8,
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}},
        cube_faces()};
    const auto place = [order](int i) { return static_cast<double>(i) / order; };
    for (auto& edge : cell.edges) { // their nodes run along the axes, whatever the direction of the edge
        const Vec3 a = cell.nodes[static_cast<std::size_t>(edge[0])],
                   way = cell.nodes[static_cast<std::size_t>(edge[1])] - a;
        const bool against = way.x + way.y + way.z < 0;
        const int first = static_cast<int>(cell.nodes.size());
        const auto on_edge = [&](double along, double of_corner, double t) {
            return along != 0 ? t : of_corner;
        };
        for (int i = 1; i < order; ++i) {
            const double t = place(i);
            cell.nodes.push_back({on_edge(way.x, a.x, t), on_edge(way.y, a.y, t), on_edge(way.z, a.z, t)});
            edge.push_back(against ? first + order - 1 - i : first + i - 1);
        }
    }
    for (const int normal : {0, 1, 2})
        for (const double side : {0.0, 1.0})
            for (int j = 1; j < order; ++j)
                for (int i = 1; i < order; ++i)
                    cell.nodes.push_back(normal == 0   ? Vec3{side, place(i), place(j)}
                                         : normal == 1 ? Vec3{place(i), side, place(j)}
                                                       : Vec3{place(i), place(j), side});
    for (int k = 1; k < order; ++k)
        for (int j = 1; j < order; ++j)
            for (int i = 1; i < order; ++i) cell.nodes.push_back({place(i), place(j), place(k)});
    return cell;
}

/// A line with equidistant nodes.
CellTable line_of_order(int order) {
    CellTable cell{{CellShape::line, order}, "line", 1, 2, {{0, 0, 0}, {1, 0, 0}}, {{0, 1}}, {}};
    for (int i = 1; i < order; ++i) {
        cell.nodes.push_back({static_cast<double>(i) / order, 0, 0});
        cell.edges[0].push_back(i + 1);
    }
    return cell;
}

/// VTK's Lagrange quadrilateral.
CellTable quadrilateral_of_order(int order) {
    CellTable cell{{CellShape::quadrilateral, order},
                   "quadrilateral",
                   2,
                   4,
                   {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                   {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
                   {}};
    const auto place = [order](int i) { return static_cast<double>(i) / order; };
    for (std::size_t e = 0; e < 4; ++e) {
        for (int i = 1; i < order; ++i) {
            const double fixed = e == 1 || e == 2 ? 1 : 0;
            cell.nodes.push_back(e % 2 == 0 ? Vec3{place(i), fixed, 0} : Vec3{fixed, place(i), 0});
        }
        const int first = 4 + static_cast<int>(e) * (order - 1);
        for (int i = 0; i + 1 < order; ++i) // the last two edges run against s and t
            cell.edges[e].push_back(e < 2 ? first + i : first + order - 2 - i);
    }
    for (int j = 1; j < order; ++j)
        for (int i = 1; i < order; ++i) cell.nodes.push_back({place(i), place(j), 0});
    return cell;
}

std::vector<CellTable> make_cell_tables() {
    std::vector<CellTable> tables = {
        {{CellShape::line, 1}, "line", 1, 2, {{0, 0, 0}, {1, 0, 0}}, {{0, 1}}, {}},
        {{CellShape::line, 2}, "line", 1, 2, {{0, 0, 0}, {1, 0, 0}, {.5, 0, 0}}, {{0, 1, 2}}, {}},
        {{CellShape::triangle, 1},
         "triangle",
         2,
         3,
         {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
         {{0, 1}, {1, 2}, {2, 0}},
         {}},
        {{CellShape::triangle, 2},
         "triangle",
         2,
         3,
         {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.5, 0, 0}, {.5, .5, 0}, {0, .5, 0}},
         {{0, 1, 3}, {1, 2, 4}, {2, 0, 5}},
         {}},
        {{CellShape::quadrilateral, 1},
         "quadrilateral",
         2,
         4,
         {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
         {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
         {}},
        {{CellShape::quadrilateral, 2},
         "quadrilateral",
         2,
         4,
         {{0, 0, 0},
          {1, 0, 0},
          {1, 1, 0},
          {0, 1, 0},
          {.5, 0, 0},
          {1, .5, 0},
          {.5, 1, 0},
          {0, .5, 0},
          {.5, .5, 0}},
         {{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}},
         {}},
    };
    for (int order = 3; order <= highest_order; ++order) {
        tables.push_back(line_of_order(order));
        tables.push_back(quadrilateral_of_order(order));
    }
    for (int order = 1; order <= highest_order; ++order) tables.push_back(hexahedron_of_order(order));
    return tables;
}

const std::vector<CellTable>& cell_tables() {
    static const std::vector<CellTable> tables = make_cell_tables();
    return tables;
}

const CellTable& table(CellKind kind) {
    for (const auto& entry : cell_tables())
        if (entry.kind == kind) return entry;
    check_failed("the kind of cell is in the table");
}

// Lagrange polynomials on [0,1] of the node at `node` (a multiple of 1/order): value and derivative.
struct ValueAndSlope {
    double value, slope;
};
ValueAndSlope lagrange(int order, double node, double s) {
    if (order == 1) return node == 0 ? ValueAndSlope{1 - s, -1} : ValueAndSlope{s, 1};
    if (order > 2) {
        const auto own = std::lround(node * order);
        ValueAndSlope product{1, 0};
        for (int i = 0; i <= order; ++i) {
            if (i == own) continue;
            const auto distance = static_cast<double>(own - i);
            const double factor = (order * s - i) / distance, slope = order / distance;
            product = {product.value * factor, product.slope * factor + product.value * slope};
        }
        return product;
    }
    if (node == 0) return {(1 - s) * (1 - 2 * s), 4 * s - 3};
    if (node == 1) return {s * (2 * s - 1), 4 * s - 1};
    return {4 * s * (1 - s), 4 - 8 * s};
}

void tensor_shapes(const CellTable& cell, Vec3 point, std::span<double> values, std::span<Vec3> gradients) {
    const int order = cell.kind.order;
    using Line = std::array<ValueAndSlope, highest_order + 1>; // of the polynomials of one direction
    const auto along = [&](double s, bool used) {
        Line line;
        line.fill({1, 0});
        for (int k = 0; used && k <= order; ++k)
            line[static_cast<std::size_t>(k)] = lagrange(order, static_cast<double>(k) / order, s);
        return line;
    };
    const Line x = along(point.x, true), y = along(point.y, cell.dimension > 1),
               z = along(point.z, cell.dimension > 2);
    const auto of = [&](const Line& line, double node) {
        return line[static_cast<std::size_t>(std::lround(node * order))];
    };
    for (std::size_t i = 0; i < cell.nodes.size(); ++i) {
        const auto a = of(x, cell.nodes[i].x), b = of(y, cell.nodes[i].y), c = of(z, cell.nodes[i].z);
        values[i] = a.value * b.value * c.value;
        gradients[i] = {a.slope * b.value * c.value, a.value * b.slope * c.value,
                        a.value * b.value * c.slope};
    }
}

void triangle_shapes(int order, Vec3 p, std::span<double> values, std::span<Vec3> gradients) {
    const double l[3] = {1 - p.x - p.y, p.x, p.y};
    const Vec3 dl[3] = {{-1, -1, 0}, {1, 0, 0}, {0, 1, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        values[i] = order == 1 ? l[i] : l[i] * (2 * l[i] - 1);
        gradients[i] = order == 1 ? dl[i] : (4 * l[i] - 1) * dl[i];
    }
    if (order == 1) return;
    for (std::size_t e = 0; e < 3; ++e) {
        const std::size_t a = e, b = (e + 1) % 3;
        values[3 + e] = 4 * l[a] * l[b];
        gradients[3 + e] = 4 * (l[a] * dl[b] + l[b] * dl[a]);
    }
}

} // namespace

int cell_dimension(CellKind kind) { return table(kind).dimension; }
int corners_per_cell(CellKind kind) { return table(kind).corners; }
int nodes_per_cell(CellKind kind) { return static_cast<int>(table(kind).nodes.size()); }

std::string cell_name(CellKind kind) {
    return std::string(table(kind).name) + ", order " + std::to_string(kind.order);
}

std::span<const Vec3> reference_nodes(CellKind kind) { return table(kind).nodes; }
std::span<const std::vector<int>> cell_edges(CellKind kind) { return table(kind).edges; }
std::span<const std::vector<int>> cell_faces(CellKind kind) { return table(kind).faces; }

void shape_functions(CellKind kind, Vec3 point, std::span<double> values, std::span<Vec3> gradients) {
    const CellTable& cell = table(kind);
    GASPARD_CHECK(values.size() == cell.nodes.size() && gradients.size() == cell.nodes.size());
    if (kind.shape == CellShape::triangle)
        triangle_shapes(kind.order, point, values, gradients);
    else
        tensor_shapes(cell, point, values, gradients);
}

} // namespace gaspard
