#include "core/tessellate/tessellation.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace gaspard {

namespace {

using SortedCorner = std::int32_t;

/// A visible face: a surface cell, or a boundary face of a solid; corners are local numbers of the cell.
struct Face {
    std::uint32_t cell = 0;
    std::span<const int> corners;
};

/// Boundary faces of a solid: those that belong to exactly one cell.
std::vector<Face> boundary_faces(const Mesh& mesh) {
    struct Candidate {
        std::array<SortedCorner, 4> corners; ///< sorted; -1 if there are only three
        Face face;
    };
    std::vector<Candidate> candidates;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        for (const auto& corners : cell_faces(mesh.kind)) {
            Candidate candidate{{-1, -1, -1, -1}, {static_cast<std::uint32_t>(c), corners}};
            for (std::size_t k = 0; k < corners.size(); ++k)
                candidate.corners[k] = mesh.cell(c)[static_cast<std::size_t>(corners[k])];
            std::sort(candidate.corners.begin(), candidate.corners.end());
            candidates.push_back(candidate);
        }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.corners < b.corners; });
    const auto same = [&](std::size_t i, std::size_t j) {
        return j < candidates.size() && candidates[i].corners == candidates[j].corners;
    };
    std::vector<Face> faces;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (!same(i, i + 1) && (i == 0 || !same(i, i - 1))) faces.push_back(candidates[i].face);
    return faces;
}

std::vector<Face> shown_faces(const Mesh& mesh) {
    static constexpr std::array<int, 4> all_corners = {0, 1, 2, 3};
    if (cell_dimension(mesh.kind) == 1) return {};
    if (cell_dimension(mesh.kind) == 3) return boundary_faces(mesh);
    std::vector<Face> faces(mesh.cell_count());
    for (std::size_t c = 0; c < faces.size(); ++c)
        faces[c] = {static_cast<std::uint32_t>(c),
                    std::span(all_corners).first(static_cast<std::size_t>(corners_per_cell(mesh.kind)))};
    return faces;
}

/// Creates the shown points, once per corner and once per edge.
class PointMaker {
  public:
    PointMaker(const Mesh& mesh, int cuts, Tessellation& out)
        : mesh_(mesh), cuts_(cuts), out_(out), corner_points_(mesh.node_count(), unmade),
          values_(static_cast<std::size_t>(nodes_per_cell(mesh.kind))), gradients_(values_.size()) {
        if (mesh.kind.order == 1)
            out_.point_count = mesh.node_count();
        else
            out_.starts.push_back(0);
    }

    std::uint32_t node(std::uint32_t cell, int local) const {
        return static_cast<std::uint32_t>(
            mesh_.cells[cell * values_.size() + static_cast<std::size_t>(local)]);
    }
    Vec3 reference(int local) const { return reference_nodes(mesh_.kind)[static_cast<std::size_t>(local)]; }

    std::uint32_t corner(std::uint32_t cell, int local) {
        const std::uint32_t number = node(cell, local);
        if (mesh_.kind.order == 1) return number;
        auto& point = corner_points_[number];
        if (point == unmade) point = make(cell, reference(local));
        return point;
    }

    /// Point `step` of `cuts` on the edge from local corner a to local corner b.
    std::uint32_t on_edge(std::uint32_t cell, int a, int b, int step) {
        if (step == 0) return corner(cell, a);
        if (step == cuts_) return corner(cell, b);
        if (node(cell, a) > node(cell, b)) return on_edge(cell, b, a, cuts_ - step);
        const std::uint64_t key = std::uint64_t{node(cell, a)} << 32 | node(cell, b);
        const auto inside = static_cast<std::size_t>(cuts_ - 1);
        const auto [entry, fresh] = edges_.try_emplace(key, edge_points_.size());
        if (fresh) edge_points_.resize(edge_points_.size() + inside, unmade);
        std::uint32_t& point = edge_points_[entry->second + static_cast<std::size_t>(step - 1)];
        const double t = static_cast<double>(step) / cuts_;
        if (point == unmade) point = make(cell, (1 - t) * reference(a) + t * reference(b));
        return point;
    }

    std::uint32_t make(std::uint32_t cell, Vec3 where) {
        shape_functions(mesh_.kind, where, values_, gradients_);
        for (std::size_t j = 0; j < values_.size(); ++j) {
            if (std::abs(values_[j]) < rounding) continue;
            out_.nodes.push_back(node(cell, static_cast<int>(j)));
            out_.weights.push_back(std::abs(values_[j] - 1) < rounding ? 1 : values_[j]);
        }
        out_.starts.push_back(static_cast<std::uint32_t>(out_.nodes.size()));
        return static_cast<std::uint32_t>(out_.point_count++);
    }

  private:
    static constexpr std::uint32_t unmade = 0xffffffff;
    static constexpr double rounding = 1e-13; ///< of shape functions at nodes, where they are 0 or 1

    const Mesh& mesh_;
    int cuts_;
    Tessellation& out_;
    std::vector<std::uint32_t> corner_points_;
    std::unordered_map<std::uint64_t, std::size_t> edges_; ///< key: its corners; value: offset of its points
    std::vector<std::uint32_t> edge_points_;               ///< those between the corners
    std::vector<double> values_;
    std::vector<Vec3> gradients_;
};

void add_triangle(Tessellation& out, std::uint32_t cell, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    out.triangles.insert(out.triangles.end(), {a, b, c});
    out.triangle_cells.push_back(cell);
}

/// Divides a quadrilateral face into cuts x cuts squares, a triangular one into cuts^2 triangles.
void fill_face(const Face& face, int cuts, PointMaker& points, Tessellation& out) {
    const auto& k = face.corners;
    const bool triangle = k.size() == 3;
    const auto point = [&](int i, int j) {
        if (j == 0) return points.on_edge(face.cell, k[0], k[1], i);
        if (i == 0) return points.on_edge(face.cell, k[0], k.back(), j);
        if (triangle && i + j == cuts) return points.on_edge(face.cell, k[1], k[2], j);
        if (!triangle && i == cuts) return points.on_edge(face.cell, k[1], k[2], j);
        if (!triangle && j == cuts) return points.on_edge(face.cell, k[3], k[2], i);
        const double s = static_cast<double>(i) / cuts, t = static_cast<double>(j) / cuts;
        const Vec3 a = points.reference(k[0]), b = points.reference(k[1]), d = points.reference(k.back());
        if (triangle) return points.make(face.cell, (1 - s - t) * a + s * b + t * d);
        const Vec3 c = points.reference(k[2]);
        return points.make(face.cell, (1 - s) * (1 - t) * a + s * (1 - t) * b + s * t * c + (1 - s) * t * d);
    };
    std::vector<std::uint32_t> below, row;
    for (int j = 0; j <= cuts; ++j) {
        row.clear();
        for (int i = 0; i <= (triangle ? cuts - j : cuts); ++i) row.push_back(point(i, j));
        for (std::size_t i = 0; i + 1 < below.size() && i < row.size(); ++i) {
            add_triangle(out, face.cell, below[i], below[i + 1], row[i]);
            if (i + 1 < row.size()) add_triangle(out, face.cell, below[i + 1], row[i + 1], row[i]);
        }
        below = row;
    }
}

/// An edge of a visible face, identified by its two corners.
struct Edge {
    std::pair<std::uint32_t, std::uint32_t> corners; ///< nodes, smaller first
    std::uint32_t cell = 0;
    int a = 0, b = 0; ///< local corners
    /// The opposite edge of an adjacent cell, in the same direction, or twice the opposite corner.
    struct Opposite {
        std::uint32_t cell = 0;
        int a = 0, b = 0;
    };
    Opposite sides[2]{};
    bool alone = false; ///< no adjacent cell
};

void collect_edges(const Face& face, PointMaker& points, std::vector<Edge>& edges) {
    const auto& k = face.corners;
    for (std::size_t e = 0; e < k.size(); ++e) {
        const int a = k[e], b = k[(e + 1) % k.size()];
        const Edge::Opposite side{face.cell, k[(e + k.size() - 1) % k.size()], k[(e + 2) % k.size()]};
        edges.push_back({std::minmax({points.node(face.cell, a), points.node(face.cell, b)}),
                         face.cell,
                         a,
                         b,
                         {side, side},
                         false});
    }
}

/// Sorted by their corners; stable.
std::vector<Edge> sorted_edges(const std::vector<Edge>& edges, std::size_t node_count) {
    // Counting sort by the smaller corner; each corner has few edges.
    std::vector<std::size_t> ends(node_count + 1, 0);
    for (const Edge& edge : edges) ++ends[edge.corners.first + 1];
    for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
    std::vector<Edge> sorted(edges.size());
    for (const Edge& edge : edges) sorted[ends[edge.corners.first]++] = edge;
    std::size_t begin = 0;
    for (std::size_t node = 0; node < node_count; ++node) {
        for (std::size_t i = begin + 1; i < ends[node]; ++i)
            for (std::size_t j = i; j > begin && sorted[j].corners.second < sorted[j - 1].corners.second; --j)
                std::swap(sorted[j], sorted[j - 1]);
        begin = ends[node];
    }
    return sorted;
}

/// Merges equal edges and records what lies on both sides.
void merge_edges(std::vector<Edge>& edges, const PointMaker& points, std::size_t node_count) {
    edges = sorted_edges(edges, node_count);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (kept > 0 && edges[kept - 1].corners == edges[i].corners) {
            Edge& edge = edges[kept - 1];
            edge.sides[1] = edges[i].sides[0];
            const bool same_way = points.node(edge.cell, edge.a) == points.node(edges[i].cell, edges[i].a);
            if (!same_way) std::swap(edge.sides[1].a, edge.sides[1].b);
        } else {
            edges[kept++] = edges[i];
        }
    }
    edges.resize(kept);
}

void draw_edge(const Edge& edge, int cuts, PointMaker& points, Tessellation& out) {
    const auto beside = [&](const Edge::Opposite& side, int i) {
        return side.a == side.b ? points.corner(side.cell, side.a)
                                : points.on_edge(side.cell, side.a, side.b, i);
    };
    for (int i = 0; i < cuts; ++i) {
        const std::uint32_t first = points.on_edge(edge.cell, edge.a, edge.b, i);
        out.segments.insert(out.segments.end(), {first, points.on_edge(edge.cell, edge.a, edge.b, i + 1)});
        if (edge.alone)
            out.segment_sides.insert(out.segment_sides.end(), {first, first});
        else
            out.segment_sides.insert(out.segment_sides.end(),
                                     {beside(edge.sides[0], i + 1), beside(edge.sides[1], i + 1)});
    }
}

void draw_line_cells(const Mesh& mesh, int cuts, PointMaker& points, Tessellation& out) {
    Edge edge;
    edge.b = 1;
    edge.alone = true;
    for (; edge.cell < mesh.cell_count(); ++edge.cell) {
        draw_edge(edge, cuts, points, out);
        out.segment_cells.resize(out.segments.size() / 2, edge.cell);
    }
}

} // namespace

/// The largest distance of a node on an edge from its place on the chord, relative to the edge's length, over
/// all edges that are not folded. With c pieces per edge the error is smaller by a factor c^2. An edge that
/// is almost a point, at the tip of a patch, counts by the size of its cell.
static double largest_bulge(const Mesh& mesh, const Points& x) {
    constexpr double short_edge = 0.01; // of the cell's longest
    double largest = 0;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        const auto chord = [&](const std::vector<int>& edge) { // its length, and the largest distance from it
            const auto node = [&](std::size_t k) {
                return x[static_cast<std::size_t>(mesh.cell(c)[static_cast<std::size_t>(edge[k])])];
            };
            const Vec3 a = node(0), b = node(1);
            double away = 0;
            for (std::size_t k = 2; k < edge.size(); ++k) {
                const double t = static_cast<double>(k - 1) / static_cast<double>(edge.size() - 1);
                away = std::max(away, norm(node(k) - ((1 - t) * a + t * b)));
            }
            return std::pair(norm(b - a), away);
        };
        double longest = 0;
        for (const auto& edge : cell_edges(mesh.kind)) longest = std::max(longest, chord(edge).first);
        for (const auto& edge : cell_edges(mesh.kind)) {
            const auto [length, away] = chord(edge);
            const double bulge = away / std::max(length, short_edge * longest);
            if (bulge > largest && bulge < 0.5) largest = bulge;
        }
    }
    return largest;
}

int cuts_for(const Mesh& mesh, const Points& x) {
    if (mesh.kind.order == 1) return 1;
    constexpr double tolerance = 1e-3;         // relative to the edge's length
    constexpr double few = 60e3, many = 600e3; // numbers of triangles
    constexpr std::array<int, 8> steps = {1, 2, 3, 4, 6, 8, 12, 16};
    const int order = mesh.kind.order;
    const int pieces = corners_per_cell(mesh.kind) == 3 ? 1 : 2; // triangles per undivided cell
    const double cells = static_cast<double>(mesh.cell_count()) * pieces;
    const double needed = std::sqrt(largest_bulge(mesh, x) / tolerance);
    int cuts = 2;
    for (int step : steps) {
        if (order > 2) step *= order; // shows every node of an edge
        const double triangles = cells * step * step;
        const bool wanted = step <= 8 && triangles <= few;
        if (step > cuts && (wanted || cuts < needed) && triangles <= many) cuts = step;
    }
    return cuts;
}

Tessellation tessellate(const Mesh& mesh, int cuts) {
    GASPARD_CHECK(cuts >= 1);
    if (mesh.kind.order == 1) cuts = 1;
    Tessellation out;
    out.cuts = cuts;
    PointMaker points(mesh, cuts, out);
    std::vector<Edge> edges;
    for (const Face& face : shown_faces(mesh)) {
        fill_face(face, cuts, points, out);
        collect_edges(face, points, edges);
    }
    merge_edges(edges, points, mesh.node_count());
    for (const Edge& edge : edges) draw_edge(edge, cuts, points, out);
    if (cell_dimension(mesh.kind) == 1) draw_line_cells(mesh, cuts, points, out);
    return out;
}

std::optional<std::uint32_t> Tessellation::node_of(std::uint32_t point) const {
    if (base) return point < base->point_count ? base->node_of(point) : std::nullopt;
    if (starts.empty()) return point;
    if (starts[point + 1] - starts[point] != 1) return std::nullopt;
    return nodes[starts[point]];
}

namespace {

void put_shown_values(const Tessellation& tessellation, std::span<const double> nodes,
                      std::vector<double>& shown) {
    if (tessellation.starts.empty()) {
        GASPARD_CHECK(nodes.size() == tessellation.point_count);
        shown.assign(nodes.begin(), nodes.end());
        return;
    }
    shown.assign(tessellation.point_count, 0);
    for (std::size_t p = 0; p < shown.size(); ++p)
        for (std::size_t k = tessellation.starts[p]; k < tessellation.starts[p + 1]; ++k)
            shown[p] += tessellation.weights[k] * nodes[tessellation.nodes[k]];
}

} // namespace

std::vector<double> shown_values(const Tessellation& tessellation, std::span<const double> nodes) {
    std::vector<double> shown;
    put_shown_values(tessellation, nodes, shown);
    return shown;
}

std::vector<std::vector<std::uint32_t>> cell_outlines(const Tessellation& tessellation,
                                                      std::span<const std::uint32_t> cells) {
    using Side = std::pair<std::uint32_t, std::uint32_t>;
    std::vector<std::vector<Side>> sides(cells.size());
    for (std::size_t i = 0; i < tessellation.triangle_cells.size(); ++i) {
        const auto found = std::lower_bound(cells.begin(), cells.end(), tessellation.triangle_cells[i]);
        if (found == cells.end() || *found != tessellation.triangle_cells[i]) continue;
        for (std::size_t k = 0; k < 3; ++k)
            sides[static_cast<std::size_t>(found - cells.begin())].emplace_back(
                tessellation.triangles[3 * i + k], tessellation.triangles[3 * i + (k + 1) % 3]);
    }
    std::vector<std::vector<std::uint32_t>> outlines;
    for (const auto& all : sides) {
        // An edge that two triangles traverse in opposite directions is interior.
        std::unordered_map<std::uint32_t, std::uint32_t> next;
        std::unordered_map<std::uint64_t, int> seen;
        const auto key = [](std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; };
        for (const auto& [a, b] : all) ++seen[key(a, b)];
        for (const auto& [a, b] : all)
            if (!seen.contains(key(b, a))) next.emplace(a, b);
        while (!next.empty()) {
            auto& loop = outlines.emplace_back();
            for (auto at = next.begin(); at != next.end();) {
                loop.push_back(at->first);
                const std::uint32_t to = at->second;
                next.erase(at);
                at = next.find(to);
            }
        }
    }
    return outlines;
}

std::vector<double> point_means(const Tessellation& tessellation, std::span<const double> cells) {
    std::vector<double> sums(tessellation.point_count, 0);
    std::vector<std::uint32_t> counts(tessellation.point_count, 0);
    const auto add = [&](std::span<const std::uint32_t> corners, std::span<const std::uint32_t> owners) {
        const std::size_t each = owners.empty() ? 0 : corners.size() / owners.size();
        for (std::size_t i = 0; i < owners.size(); ++i)
            for (std::size_t k = 0; k < each; ++k) {
                sums[corners[each * i + k]] += cells[owners[i]];
                ++counts[corners[each * i + k]];
            }
    };
    add(tessellation.triangles, tessellation.triangle_cells);
    add(tessellation.segments, tessellation.segment_cells);
    for (std::size_t p = 0; p < sums.size(); ++p) sums[p] /= std::max(1U, counts[p]);
    return sums;
}

void put_shown_points(const Tessellation& tessellation, const Points& nodes, Points& shown) {
    put_shown_values(tessellation, nodes.x, shown.x);
    put_shown_values(tessellation, nodes.y, shown.y);
    put_shown_values(tessellation, nodes.z, shown.z);
}

Points shown_points(const Tessellation& tessellation, const Points& nodes) {
    Points shown;
    put_shown_points(tessellation, nodes, shown);
    return shown;
}

} // namespace gaspard
