#include "core/mesh/sphere_mesh.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace gaspard {

namespace {

using Triangle = std::array<Vec3, 3>;
using Corners = std::vector<std::array<std::int32_t, 4>>; // triangles do not use the last entry

Vec3 onto_sphere(Vec3 p) { return (1 / norm(p)) * p; }
Vec3 middle(Vec3 a, Vec3 b) { return onto_sphere(a + b); }

double& component(Vec3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Numbers unordered pairs consecutively, in the order in which they first occur.
class PairNumbers {
  public:
    explicit PairNumbers(std::int32_t next) : next_(next) {}
    /// The number of the pair, and whether the pair is new.
    std::pair<std::int32_t, bool> number(std::int32_t a, std::int32_t b) {
        const auto [low, high] = std::minmax(a, b);
        const auto key = static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
        const auto [entry, fresh] = numbers_.try_emplace(key, next_);
        if (fresh) ++next_;
        return {entry->second, fresh};
    }

  private:
    std::int32_t next_;
    std::unordered_map<std::uint64_t, std::int32_t> numbers_;
};

Points to_points(const std::vector<Vec3>& list) {
    Points points(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) points.set(i, list[i]);
    return points;
}

/// The quadratic mesh for given corners, with nodes at the normalised midpoints.
SurfaceMesh complete(CellShape shape, std::vector<Vec3> nodes, const Corners& corners) {
    const std::size_t vertices = nodes.size(), sides = shape == CellShape::triangle ? 3 : 4;
    PairNumbers edges(static_cast<std::int32_t>(vertices));
    SurfaceMesh surface{{.kind = {shape, 2}, .space_dimension = 3, .nodes = {}, .cells = {}}, vertices};
    auto& cells = surface.quadratic.cells;
    for (const auto& cell : corners) {
        cells.insert(cells.end(), cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(sides));
        for (std::size_t e = 0; e < sides; ++e) {
            const auto a = cell[e], b = cell[(e + 1) % sides];
            const auto [number, fresh] = edges.number(a, b);
            if (fresh)
                nodes.push_back(
                    middle(nodes[static_cast<std::size_t>(a)], nodes[static_cast<std::size_t>(b)]));
            cells.push_back(number);
        }
        if (sides == 4) cells.push_back(0); // the middle node follows after all edges are numbered
    }
    if (sides == 4)
        for (std::size_t c = 0; c < corners.size(); ++c) {
            Vec3 sum;
            for (const auto corner : corners[c]) sum = sum + nodes[static_cast<std::size_t>(corner)];
            cells[9 * c + 8] = static_cast<std::int32_t>(nodes.size());
            nodes.push_back(onto_sphere(sum));
        }
    surface.quadratic.nodes = to_points(nodes);
    return surface;
}

// The faces of the cube, two for each axis. The cross product of the column and row directions points
// outward.
struct Face {
    int axis, column, row;
    bool front;
};
Face face(int number) {
    const int axis = number / 2;
    const bool front = number % 2 == 0;
    return {axis, (axis + (front ? 1 : 2)) % 3, (axis + (front ? 2 : 1)) % 3, front};
}

/// Gnomonic coordinate on a face; `at` in [-1, 1] is proportional to the angle.
double gnomonic(double at) { return std::tan(std::numbers::pi / 4 * at); }

SurfaceMesh cubed_sphere(int k, MidNodes mid_nodes) {
    std::unordered_map<std::int64_t, std::int32_t> numbers; // node numbers by lattice point; faces share them
    std::vector<Vec3> nodes;
    const auto at_lattice = [&](const Face& f, int column, int row) { // in units of half cells
        std::array<int, 3> at{};
        at[static_cast<std::size_t>(f.axis)] = f.front ? k : -k;
        at[static_cast<std::size_t>(f.column)] = column - k;
        at[static_cast<std::size_t>(f.row)] = row - k;
        return at;
    };
    const auto place = [&](const std::array<int, 3>& at) {
        return onto_sphere({gnomonic(static_cast<double>(at[0]) / k),
                            gnomonic(static_cast<double>(at[1]) / k),
                            gnomonic(static_cast<double>(at[2]) / k)});
    };
    const auto node = [&](const Face& f, int column, int row) {
        const auto at = at_lattice(f, column, row);
        const std::int64_t side = 2 * k + 1, key = ((at[0] + k) * side + at[1] + k) * side + at[2] + k;
        const auto [entry, fresh] = numbers.try_emplace(key, static_cast<std::int32_t>(nodes.size()));
        if (fresh) nodes.push_back(place(at));
        return entry->second;
    };
    Corners corners;
    for (int number = 0; number < 6; ++number) {
        const Face f = face(number);
        for (int row = 0; row < k; ++row)
            for (int column = 0; column < k; ++column) {
                const int i = 2 * column, j = 2 * row;
                corners.push_back(
                    {node(f, i, j), node(f, i + 2, j), node(f, i + 2, j + 2), node(f, i, j + 2)});
            }
    }
    SurfaceMesh surface = complete(CellShape::quadrilateral, std::move(nodes), corners);
    if (mid_nodes == MidNodes::normalised) return surface;
    constexpr int local[5][2] = {{1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
    std::size_t c = 0;
    for (int number = 0; number < 6; ++number)
        for (int row = 0; row < k; ++row)
            for (int column = 0; column < k; ++column, ++c)
                for (std::size_t e = 0; e < 5; ++e) {
                    const auto at = at_lattice(face(number), 2 * column + local[e][0], 2 * row + local[e][1]);
                    surface.quadratic.nodes.set(
                        static_cast<std::size_t>(surface.quadratic.cells[9 * c + 4 + e]), place(at));
                }
    return surface;
}

CellPlace locate_in_cube(int k, Vec3 p) {
    int axis = 0;
    for (int other = 1; other < 3; ++other)
        if (std::abs(component(p, other)) > std::abs(component(p, axis))) axis = other;
    const int number = 2 * axis + (component(p, axis) < 0 ? 1 : 0);
    const Face f = face(number);
    const auto along = [&](int direction) { // in units of cells
        const double angle = std::atan(component(p, direction) / std::abs(component(p, axis)));
        return (1 + angle / (std::numbers::pi / 4)) / 2 * k;
    };
    const double s = along(f.column), t = along(f.row);
    const double column = std::clamp(std::floor(s), 0.0, k - 1.0),
                 row = std::clamp(std::floor(t), 0.0, k - 1.0);
    const auto cells = static_cast<std::size_t>(k);
    return {(static_cast<std::size_t>(number) * cells + static_cast<std::size_t>(row)) * cells +
                static_cast<std::size_t>(column),
            {s - column, t - row, 0}};
}

const std::vector<Vec3>& icosahedron_vertices() {
    static const std::vector<Vec3> vertices = [] {
        std::vector<Vec3> list;
        for (int axis = 0; axis < 3; ++axis)
            for (const double one : {-1.0, 1.0})
                for (const double golden : {-std::numbers::phi, std::numbers::phi}) {
                    Vec3 p;
                    component(p, (axis + 1) % 3) = one;
                    component(p, (axis + 2) % 3) = golden;
                    list.push_back(onto_sphere(p));
                }
        return list;
    }();
    return vertices;
}

double determinant(Vec3 a, Vec3 b, Vec3 c) { return dot(cross(a, b), c); }

/// The faces: triples of mutually adjacent vertices, counter-clockwise as seen from outside.
const Corners& icosahedron_faces() {
    static const Corners faces = [] {
        const auto& v = icosahedron_vertices();
        const auto near = [&](std::size_t a, std::size_t b) { return norm(v[a] - v[b]) < 1.1; }; // edge: 1.05
        Corners list;
        for (std::size_t a = 0; a < v.size(); ++a)
            for (std::size_t b = a + 1; b < v.size(); ++b)
                for (std::size_t c = b + 1; c < v.size(); ++c)
                    if (near(a, b) && near(b, c) && near(c, a)) {
                        std::array<std::int32_t, 4> corners = {static_cast<std::int32_t>(a),
                                                               static_cast<std::int32_t>(b),
                                                               static_cast<std::int32_t>(c), 0};
                        if (determinant(v[a], v[b], v[c]) < 0) std::swap(corners[1], corners[2]);
                        list.push_back(corners);
                    }
        GASPARD_CHECK(list.size() == 20);
        return list;
    }();
    return faces;
}

// Each triangle is divided into four; the first three keep one corner each, the last is the middle one.
SurfaceMesh icosahedral_sphere(int refinements) {
    std::vector<Vec3> nodes = icosahedron_vertices();
    Corners corners = icosahedron_faces();
    for (int level = 0; level < refinements; ++level) {
        PairNumbers edges(static_cast<std::int32_t>(nodes.size()));
        Corners finer;
        finer.reserve(4 * corners.size());
        for (const auto& [a, b, c, none] : corners) {
            const auto between = [&](std::int32_t p, std::int32_t q) {
                const auto [number, fresh] = edges.number(p, q);
                if (fresh)
                    nodes.push_back(
                        middle(nodes[static_cast<std::size_t>(p)], nodes[static_cast<std::size_t>(q)]));
                return number;
            };
            const auto ab = between(a, b), bc = between(b, c), ca = between(c, a);
            finer.insert(finer.end(), {{a, ab, ca, 0}, {ab, b, bc, 0}, {ca, bc, c, 0}, {ab, bc, ca, 0}});
        }
        corners = std::move(finer);
    }
    return complete(CellShape::triangle, std::move(nodes), corners);
}

/// Barycentric coordinates of a direction, up to a factor; all are positive inside the triangle.
Vec3 inside(const Triangle& t, Vec3 p) {
    return {determinant(t[1], t[2], p), determinant(t[2], t[0], p), determinant(t[0], t[1], p)};
}
double least(Vec3 a) { return std::min({a.x, a.y, a.z}); }

CellPlace locate_in_icosahedron(int refinements, Vec3 p) {
    const auto& v = icosahedron_vertices();
    std::size_t cell = 0;
    Triangle triangle{};
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < icosahedron_faces().size(); ++f) {
        const auto& corners = icosahedron_faces()[f];
        const Triangle candidate = {v[static_cast<std::size_t>(corners[0])],
                                    v[static_cast<std::size_t>(corners[1])],
                                    v[static_cast<std::size_t>(corners[2])]};
        if (const double depth = least(inside(candidate, p)); depth > best)
            best = depth, cell = f, triangle = candidate;
    }
    for (int level = 0; level < refinements; ++level) {
        const auto [a, b, c] = triangle;
        const Vec3 ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        const Triangle parts[4] = {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}};
        // p is in the middle part unless one of the three edges separates it.
        std::size_t part = 3;
        if (determinant(ca, ab, p) < 0) part = 0;
        if (determinant(ab, bc, p) < 0) part = 1;
        if (determinant(bc, ca, p) < 0) part = 2;
        cell = 4 * cell + part;
        triangle = parts[part];
    }
    const Vec3 share = inside(triangle, p);
    const double sum = share.x + share.y + share.z;
    return {cell, {share.y / sum, share.z / sum, 0}};
}

} // namespace

SurfaceMesh sphere_mesh(const SphereGrid& grid) {
    GASPARD_CHECK(grid.resolution >= (grid.cells == SphereCells::cubed ? 1 : 0));
    if (grid.cells == SphereCells::cubed) return cubed_sphere(grid.resolution, grid.mid_nodes);
    return icosahedral_sphere(grid.resolution);
}

Mesh straightened(const SurfaceMesh& surface) {
    const Mesh& curved = surface.quadratic;
    Mesh mesh{.kind = {curved.kind.shape, 1},
              .space_dimension = curved.space_dimension,
              .nodes = curved.nodes,
              .cells = {}};
    mesh.nodes.resize(surface.vertex_count);
    const auto corners = static_cast<std::size_t>(corners_per_cell(curved.kind));
    for (std::size_t c = 0; c < curved.cell_count(); ++c)
        mesh.cells.insert(mesh.cells.end(), curved.cell(c).begin(),
                          curved.cell(c).begin() + static_cast<std::ptrdiff_t>(corners));
    return mesh;
}

CellPlace locate(const SphereGrid& grid, Vec3 direction) {
    const Vec3 p = onto_sphere(direction);
    return grid.cells == SphereCells::cubed ? locate_in_cube(grid.resolution, p)
                                            : locate_in_icosahedron(grid.resolution, p);
}

} // namespace gaspard
