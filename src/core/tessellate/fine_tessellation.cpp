#include "core/tessellate/fine_tessellation.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <unordered_map>

namespace gaspard {

namespace {

constexpr std::size_t most_triangles = std::size_t{4} << 20;
constexpr std::size_t most_work_of_cell = 1'000'000; // about 10 ms

/// A point of the coarsest tessellation, seen from a cell.
struct Corner {
    std::uint32_t point = 0;
    Vec3 where; ///< reference coordinates
};

struct CutFace {
    std::uint32_t cell = 0;
    std::vector<Corner> corners; ///< in order around it
};

double longest_side(std::initializer_list<const Points*> sets) {
    double longest = 0;
    for (const auto coordinate : {&Points::x, &Points::y, &Points::z}) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Points* points : sets)
            for (const double value : points->*coordinate) {
                GASPARD_CHECK(std::isfinite(value));
                low = std::min(low, value), high = std::max(high, value);
            }
        longest = std::max(longest, high - low);
    }
    return longest;
}

/// The vector from a segment to a point, relative to the start of the segment.
double distance_to_chord(Vec3 point, Vec3 chord) {
    const double square = dot(chord, chord);
    return square > 0 ? norm(point - std::clamp(dot(point, chord) / square, 0.0, 1.0) * chord) : norm(point);
}

/// Subdivision of a face: squares along sides 0-1 and 0-3, or triangles along each side.
struct Grid {
    const CutFace& face;
    std::size_t columns = 1, rows = 1;

    bool triangle() const { return face.corners.size() == 3; }
    /// The last position of a row.
    std::size_t end(std::size_t j) const { return triangle() ? columns - j : columns; }

    Vec3 where(std::size_t i, std::size_t j) const {
        const double s = static_cast<double>(i) / static_cast<double>(columns),
                     t = static_cast<double>(j) / static_cast<double>(rows);
        const auto& k = face.corners;
        if (triangle()) return (1 - s - t) * k[0].where + s * k[1].where + t * k[2].where;
        return (1 - s) * (1 - t) * k[0].where + s * (1 - t) * k[1].where + s * t * k[2].where +
               (1 - s) * t * k[3].where;
    }

    /// The side of the face on which a grid position lies, and its step along that side; side -1: interior.
    struct OnSide {
        int side = -1;
        std::size_t step = 0, of = 1;
    };
    OnSide on_side(std::size_t i, std::size_t j) const {
        if (j == 0) return {0, i, columns};
        if (i == end(j)) return {1, j, rows};
        if (triangle()) return i == 0 ? OnSide{2, rows - j, rows} : OnSide{};
        if (j == rows) return {2, columns - i, columns};
        return i == 0 ? OnSide{3, rows - j, rows} : OnSide{};
    }
};

/// Subdivides the edges and faces of the coarsest tessellation.
class Cutter {
  public:
    Cutter(const Mesh& mesh, const Points& x, double tolerance, std::size_t most_work)
        : mesh_(mesh), coarse_(tessellate(mesh, 1)), fine_(coarse_), node_positions_{&mesh.nodes, &x},
          tolerance_(tolerance * longest_side({&mesh.nodes, &x})),
          values_(static_cast<std::size_t>(nodes_per_cell(mesh.kind))), gradients_(values_.size()),
          work_left_(most_work + most_work_of_cell * mesh.cell_count()) {
        fine_.cuts = 0;
        for (auto* array : {&fine_.triangles, &fine_.triangle_cells, &fine_.segments, &fine_.segment_cells,
                            &fine_.segment_sides})
            array->clear();
    }

    Tessellation cut() {
        for (const CutFace& face : faces()) fill(face);
        for (std::size_t i = 0; i < coarse_.segments.size() / 2; ++i) draw_segment(i);
        return std::move(fine_);
    }

  private:
    using EdgePoints = std::vector<std::uint32_t>; ///< in order along the edge

    Corner corner(std::uint32_t cell, std::uint32_t point) const {
        const std::uint32_t node = coarse_.starts.empty() ? point : coarse_.nodes[coarse_.starts[point]];
        const auto nodes = mesh_.cell(cell);
        const auto found = std::find(nodes.begin(), nodes.end(), static_cast<std::int32_t>(node));
        GASPARD_CHECK(found != nodes.end());
        return {point, reference_nodes(mesh_.kind)[static_cast<std::size_t>(found - nodes.begin())]};
    }

    std::vector<CutFace> faces() const {
        const bool triangles = mesh_.kind.shape == CellShape::triangle;
        std::vector<CutFace> found;
        for (std::size_t i = 0; i < coarse_.triangle_cells.size(); i += triangles ? 1 : 2) {
            const std::uint32_t cell = coarse_.triangle_cells[i], *t = &coarse_.triangles[3 * i];
            CutFace face{cell, {corner(cell, t[0]), corner(cell, t[1])}};
            if (!triangles) { // two triangles along the diagonal from corner 1 to corner 3
                GASPARD_CHECK(t[3] == t[1] && t[5] == t[2]);
                face.corners.push_back(corner(cell, t[4]));
            }
            face.corners.push_back(corner(cell, t[2]));
            found.push_back(std::move(face));
        }
        return found;
    }

    /// A point of a cell, at xi and at x.
    std::array<Vec3, 2> at(std::uint32_t cell, Vec3 where) {
        shape_functions(mesh_.kind, where, values_, gradients_);
        const auto nodes = mesh_.cell(cell);
        if (work_left_ < nodes.size())
            throw MachineError("a tessellation within output.curve_tolerance would take too long, because "
                               "cells fold or bend strongly; increase the tolerance");
        work_left_ -= nodes.size();
        std::array<Vec3, 2> sum;
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t k = 0; k < nodes.size(); ++k)
                sum[i] = sum[i] + values_[k] * (*node_positions_[i])[static_cast<std::size_t>(nodes[k])];
        return sum;
    }

    bool bends(std::uint32_t cell, Vec3 a, Vec3 b, double allowed) {
        const auto from = at(cell, a), to = at(cell, b);
        const int parts = mesh_.kind.order > 2 ? 2 * (mesh_.kind.order + 1) : 4;
        for (int k = 1; k < parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            const auto between = at(cell, (1 - t) * a + t * b);
            for (std::size_t i = 0; i < 2; ++i)
                if (distance_to_chord(between[i] - from[i], to[i] - from[i]) > allowed) return true;
        }
        return false;
    }

    double allowed_along_lines() const {
        if (cell_dimension(mesh_.kind) == 1) return tolerance_;
        return (mesh_.kind.shape == CellShape::triangle ? 0.75 : 0.5) * tolerance_;
    }

    std::uint32_t add_point(std::uint32_t cell, Vec3 where) {
        if (fine_.starts.empty()) { // so far every point was a node
            fine_.starts.push_back(0);
            for (std::uint32_t node = 0; node < fine_.point_count; ++node) {
                fine_.nodes.push_back(node);
                fine_.weights.push_back(1);
                fine_.starts.push_back(node + 1);
            }
        }
        shape_functions(mesh_.kind, where, values_, gradients_);
        for (std::size_t k = 0; k < values_.size(); ++k) {
            if (values_[k] == 0) continue;
            fine_.nodes.push_back(static_cast<std::uint32_t>(mesh_.cell(cell)[k]));
            fine_.weights.push_back(values_[k]);
        }
        fine_.starts.push_back(static_cast<std::uint32_t>(fine_.nodes.size()));
        return static_cast<std::uint32_t>(fine_.point_count++);
    }

    /// The points of the edge from corner a to corner b; created on first use.
    EdgePoints edge(std::uint32_t cell, const Corner& a, const Corner& b) {
        if (a.point > b.point) {
            const EdgePoints backward = edge(cell, b, a);
            return {backward.rbegin(), backward.rend()};
        }
        const auto [entry, fresh] = edges_.try_emplace(std::uint64_t{a.point} << 32 | b.point);
        if (fresh) {
            EdgePoints& points = entry->second;
            const std::size_t pieces = pieces_of_edge(cell, a.where, b.where);
            points.push_back(a.point);
            for (std::size_t i = 1; i < pieces; ++i) {
                const double t = static_cast<double>(i) / static_cast<double>(pieces);
                points.push_back(add_point(cell, (1 - t) * a.where + t * b.where));
            }
            points.push_back(b.point);
        }
        return entry->second;
    }

    std::size_t pieces_of_edge(std::uint32_t cell, Vec3 a, Vec3 b) {
        // A value of the nodes varies along an edge that is straight, too.
        const int order = mesh_.kind.order;
        for (std::size_t pieces = order > 2 ? std::bit_ceil(static_cast<unsigned>(order)) : 1;; pieces *= 2) {
            check_number(pieces);
            bool fine = true;
            for (std::size_t i = 0; i < pieces && fine; ++i) {
                const double s = static_cast<double>(i) / static_cast<double>(pieces),
                             t = static_cast<double>(i + 1) / static_cast<double>(pieces);
                fine = !bends(cell, (1 - s) * a + s * b, (1 - t) * a + t * b, allowed_along_lines());
            }
            if (fine) return pieces;
        }
    }

    void check_number(std::size_t more) const {
        if (fine_.triangle_cells.size() + more > most_triangles)
            throw MachineError("a tessellation within output.curve_tolerance would take more than 4 million "
                               "triangles; increase the tolerance");
    }

    void fill(const CutFace& face) {
        std::vector<EdgePoints> sides;
        for (std::size_t k = 0; k < face.corners.size(); ++k)
            sides.push_back(edge(face.cell, face.corners[k], face.corners[(k + 1) % face.corners.size()]));
        const auto pieces = [&](std::size_t side) { return sides[side].size() - 1; };
        Grid grid{face, std::max(pieces(0), pieces(2)), std::max(pieces(1), pieces(sides.size() - 1))};
        if (grid.triangle()) grid.columns = grid.rows = std::max(grid.columns, grid.rows);
        while (refine(grid)) check_number(2 * grid.columns * grid.rows);

        std::vector<std::uint32_t> below, row;
        for (std::size_t j = 0; j <= grid.rows; ++j) {
            row.clear();
            for (std::size_t i = 0; i <= grid.end(j); ++i) row.push_back(point(grid, sides, i, j));
            for (std::size_t i = 0; i + 1 < below.size(); ++i) {
                add_triangle(face.cell, below[i], below[i + 1], row[i]);
                if (i + 1 < row.size()) add_triangle(face.cell, below[i + 1], row[i + 1], row[i]);
            }
            below = row;
        }
    }

    /// Doubles the grid in a direction where its interior lines exceed the tolerance; false if none does.
    bool refine(Grid& grid) {
        bool along_rows = false, along_columns = false, across = false;
        const auto check = [&](bool& found, std::size_t i, std::size_t j, std::size_t k, std::size_t l,
                               double allowed) {
            if (!found) found = bends(grid.face.cell, grid.where(i, j), grid.where(k, l), allowed);
        };
        const double allowed = allowed_along_lines(), diagonal = grid.triangle() ? allowed : tolerance_;
        for (std::size_t j = 0; j < grid.rows; ++j)
            for (std::size_t i = 0; i < grid.end(j); ++i) {
                if (j > 0) check(along_rows, i, j, i + 1, j, allowed);
                if (i > 0) check(along_columns, i, j, i, j + 1, allowed);
                if (!grid.triangle() || i + 1 < grid.end(j)) check(across, i + 1, j, i, j + 1, diagonal);
            }
        const bool all = across || (grid.triangle() && (along_rows || along_columns));
        if (all || along_rows) grid.columns *= 2;
        if (all || along_columns) grid.rows *= 2;
        return all || along_rows || along_columns;
    }

    /// The edge point that replaces a grid position on the boundary: the nearest, or the next around the face
    /// if two are equally near; so at most one of the two sides of a corner collapses.
    std::uint32_t point(const Grid& grid, const std::vector<EdgePoints>& sides, std::size_t i,
                        std::size_t j) {
        const auto [side, step, of] = grid.on_side(i, j);
        if (side < 0) return add_point(grid.face.cell, grid.where(i, j));
        const EdgePoints& edge = sides[static_cast<std::size_t>(side)];
        return edge[(2 * step * (edge.size() - 1) + of) / (2 * of)];
    }

    void add_triangle(std::uint32_t cell, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a == b || b == c || c == a) return; // degenerate: the edge has fewer points than the grid
        fine_.triangles.insert(fine_.triangles.end(), {a, b, c});
        fine_.triangle_cells.push_back(cell);
    }

    void draw_segment(std::size_t i) {
        const std::uint32_t a = coarse_.segments[2 * i], b = coarse_.segments[2 * i + 1];
        const bool lines = !coarse_.segment_cells.empty();
        const std::uint32_t cell = lines ? coarse_.segment_cells[i] : 0;
        // Faces of surfaces and solids have created all edges, so no cell is needed any more.
        const EdgePoints points =
            lines ? edge(cell, corner(cell, a), corner(cell, b)) : edge(cell, {a, {}}, {b, {}});
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            fine_.segments.insert(fine_.segments.end(), {points[k], points[k + 1]});
            if (lines) fine_.segment_cells.push_back(cell);
            for (std::size_t side = 2 * i; side < 2 * i + 2; ++side) // its own first point: no neighbour
                fine_.segment_sides.push_back(coarse_.segment_sides[side] == a ? points[k]
                                                                               : coarse_.segment_sides[side]);
        }
    }

    const Mesh& mesh_;
    const Tessellation coarse_;
    Tessellation fine_;
    std::array<const Points*, 2> node_positions_; ///< xi and x
    double tolerance_;
    std::unordered_map<std::uint64_t, EdgePoints> edges_; ///< keyed by the end points, smaller first
    std::vector<double> values_;                          ///< of the shape functions
    std::vector<Vec3> gradients_;
    std::size_t work_left_;
};

} // namespace

Tessellation tessellate_within(const Mesh& mesh, const Points& x, double tolerance, std::size_t most_work) {
    GASPARD_CHECK(tolerance > 0 && x.size() == mesh.node_count());
    if (mesh.kind.order == 1 && mesh.space_dimension < 3) return tessellate(mesh); // straight and flat
    return Cutter(mesh, x, tolerance, most_work).cut();
}

} // namespace gaspard
