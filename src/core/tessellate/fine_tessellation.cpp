#include "core/tessellate/fine_tessellation.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

namespace gaspard {

namespace {

constexpr std::uint32_t whole = 0xffffffff; ///< of a piece that is not cut

/// A point as a cell knows it.
struct Corner {
    std::uint32_t point = 0;
    Vec3 where; ///< in the reference cell
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

/// From a point to a straight piece; both seen from where the piece begins.
double distance_to_chord(Vec3 point, Vec3 chord) {
    const double square = dot(chord, chord);
    return square > 0 ? norm(point - std::clamp(dot(point, chord) / square, 0.0, 1.0) * chord) : norm(point);
}

/// Cuts the triangles and segments of the coarsest tessellation.
class Cutter {
  public:
    Cutter(const Mesh& mesh, const Points& x, double tolerance)
        : mesh_(mesh), coarse_(tessellate(mesh, 1)), fine_(coarse_), node_positions_{&mesh.nodes, &x},
          allowed_(0.75 * tolerance * longest_side({&mesh.nodes, &x})),
          values_(static_cast<std::size_t>(nodes_per_cell(mesh.kind))), gradients_(values_.size()) {
        for (std::size_t i = 0; i < 2; ++i) points_[i] = shown_points(coarse_, *node_positions_[i]);
        fine_.cuts = 0;
        for (auto* array : {&fine_.triangles, &fine_.triangle_cells, &fine_.segments, &fine_.segment_cells,
                            &fine_.segment_sides})
            array->clear();
    }

    Tessellation cut() {
        for (std::size_t i = 0; i < coarse_.triangle_cells.size(); ++i) cut_face_triangle(i);
        for (std::size_t i = 0; i < coarse_.segments.size() / 2; ++i) cut_segment(i);
        return std::move(fine_);
    }

  private:
    /// The point in the middle of each piece that was looked at, or `whole`; by the points at the ends.
    using Middles = std::unordered_map<std::uint64_t, std::uint32_t>;

    static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
        return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    }

    /// Which of the cell's corners a point of the coarsest tessellation is.
    std::size_t local_corner(std::uint32_t cell, std::uint32_t point) const {
        const std::uint32_t node = coarse_.starts.empty() ? point : coarse_.nodes[coarse_.starts[point]];
        const auto nodes = mesh_.cell(cell);
        const auto found = std::find(nodes.begin(), nodes.end(), static_cast<std::int32_t>(node));
        GASPARD_CHECK(found != nodes.end());
        return static_cast<std::size_t>(found - nodes.begin());
    }

    bool is_edge(std::size_t a, std::size_t b) const {
        const auto edges = cell_edges(mesh_.kind);
        const auto joins = [&](int from, int to) {
            return static_cast<std::size_t>(from) == a && static_cast<std::size_t>(to) == b;
        };
        return std::any_of(edges.begin(), edges.end(), [&](const std::vector<int>& edge) {
            return joins(edge[0], edge[1]) || joins(edge[1], edge[0]);
        });
    }

    void cut_face_triangle(std::size_t i) {
        const std::uint32_t cell = coarse_.triangle_cells[i];
        if (i > 0 && cell != coarse_.triangle_cells[i - 1]) inside_.clear();
        std::array<std::size_t, 3> local{};
        std::array<Corner, 3> corners;
        std::array<bool, 3> edge{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t point = coarse_.triangles[3 * i + k];
            local[k] = local_corner(cell, point);
            corners[k] = {point, reference_nodes(mesh_.kind)[local[k]]};
        }
        for (std::size_t k = 0; k < 3; ++k) edge[k] = is_edge(local[k], local[(k + 1) % 3]);
        cut_triangle(cell, corners, edge);
    }

    /// Side k goes from corner k to the next; `edge` says which sides lie on the cell's edges.
    void cut_triangle(std::uint32_t cell, const std::array<Corner, 3>& corners, std::array<bool, 3> edge) {
        std::uint32_t middle = whole;
        std::size_t side = 0;
        double longest = -1;
        for (std::size_t k = 0; k < 3; ++k) {
            const Corner &a = corners[k], &b = corners[(k + 1) % 3];
            const std::uint32_t found = middle_of(cell, a, b, edge[k] ? edges_ : inside_);
            const double length = norm(points_[1][b.point] - points_[1][a.point]);
            if (found != whole && length > longest) side = k, longest = length, middle = found;
        }
        if (middle == whole) {
            for (const Corner& corner : corners) fine_.triangles.push_back(corner.point);
            fine_.triangle_cells.push_back(cell);
            return;
        }
        const std::size_t next = (side + 1) % 3, last = (side + 2) % 3;
        const Corner &a = corners[side], &b = corners[next], &c = corners[last];
        const Corner m = {middle, 0.5 * (a.where + b.where)};
        cut_triangle(cell, {a, m, c}, {edge[side], false, edge[last]});
        cut_triangle(cell, {m, b, c}, {edge[side], edge[next], false});
    }

    std::uint32_t middle_of(std::uint32_t cell, const Corner& a, const Corner& b, Middles& known) {
        const auto [entry, fresh] = known.try_emplace(key(a.point, b.point), whole);
        if (fresh && bends(cell, a, b)) entry->second = add_point(cell, 0.5 * (a.where + b.where));
        return entry->second;
    }

    bool bends(std::uint32_t cell, const Corner& a, const Corner& b) {
        for (const double t : {0.25, 0.5, 0.75}) {
            shape_functions(mesh_.kind, (1 - t) * a.where + t * b.where, values_, gradients_);
            for (std::size_t i = 0; i < 2; ++i) {
                const Vec3 from = points_[i][a.point];
                if (distance_to_chord(shaped(cell, i) - from, points_[i][b.point] - from) > allowed_)
                    return true;
            }
        }
        return false;
    }

    /// Where the shape functions' values put a point, at xi (0) or at x (1).
    Vec3 shaped(std::uint32_t cell, std::size_t i) const {
        Vec3 sum;
        const auto nodes = mesh_.cell(cell);
        for (std::size_t k = 0; k < nodes.size(); ++k)
            sum = sum + values_[k] * (*node_positions_[i])[static_cast<std::size_t>(nodes[k])];
        return sum;
    }

    std::uint32_t add_point(std::uint32_t cell, Vec3 where) {
        if (fine_.starts.empty()) // so far every point was a node
            for (std::uint32_t node = 0; node <= fine_.point_count; ++node) {
                fine_.starts.push_back(node);
                if (node == fine_.point_count) break;
                fine_.nodes.push_back(node);
                fine_.weights.push_back(1);
            }
        shape_functions(mesh_.kind, where, values_, gradients_);
        for (std::size_t k = 0; k < values_.size(); ++k) {
            if (values_[k] == 0) continue;
            fine_.nodes.push_back(static_cast<std::uint32_t>(mesh_.cell(cell)[k]));
            fine_.weights.push_back(values_[k]);
        }
        GASPARD_CHECK(fine_.nodes.size() < whole);
        fine_.starts.push_back(static_cast<std::uint32_t>(fine_.nodes.size()));
        for (std::size_t i = 0; i < 2; ++i) {
            points_[i].resize(fine_.point_count + 1);
            points_[i].set(fine_.point_count, shaped(cell, i));
        }
        return static_cast<std::uint32_t>(fine_.point_count++);
    }

    void cut_segment(std::size_t i) {
        const std::uint32_t a = coarse_.segments[2 * i], b = coarse_.segments[2 * i + 1];
        if (!coarse_.segment_cells.empty()) { // no triangle has looked at it
            const std::uint32_t cell = coarse_.segment_cells[i];
            const auto nodes = reference_nodes(mesh_.kind);
            cut_line(cell, {a, nodes[local_corner(cell, a)]}, {b, nodes[local_corner(cell, b)]});
        }
        draw(i, a, b);
    }

    void cut_line(std::uint32_t cell, const Corner& a, const Corner& b) {
        const std::uint32_t middle = middle_of(cell, a, b, edges_);
        if (middle == whole) return;
        const Corner m = {middle, 0.5 * (a.where + b.where)};
        cut_line(cell, a, m);
        cut_line(cell, m, b);
    }

    /// The pieces of segment i between two of its points.
    void draw(std::size_t i, std::uint32_t a, std::uint32_t b) {
        const std::uint32_t middle = edges_.at(key(a, b));
        if (middle != whole) {
            draw(i, a, middle);
            draw(i, middle, b);
            return;
        }
        fine_.segments.insert(fine_.segments.end(), {a, b});
        if (!coarse_.segment_cells.empty()) fine_.segment_cells.push_back(coarse_.segment_cells[i]);
        for (std::size_t side = 2 * i; side < 2 * i + 2; ++side) // its own first point: nothing lies beside
            fine_.segment_sides.push_back(
                coarse_.segment_sides[side] == coarse_.segments[2 * i] ? a : coarse_.segment_sides[side]);
    }

    const Mesh& mesh_;
    const Tessellation coarse_;
    Tessellation fine_;
    std::array<const Points*, 2> node_positions_; ///< xi and x
    std::array<Points, 2> points_;                ///< the shown points there
    double allowed_;
    Middles edges_;              ///< on the edges of cells, which neighbours share
    Middles inside_;             ///< of the present cell
    std::vector<double> values_; ///< of the shape functions, at the last point that was asked for
    std::vector<Vec3> gradients_;
};

} // namespace

Tessellation tessellate_within(const Mesh& mesh, const Points& x, double tolerance) {
    GASPARD_CHECK(tolerance > 0 && x.size() == mesh.node_count());
    if (mesh.kind.order == 1 && mesh.space_dimension < 3) return tessellate(mesh); // straight and flat
    return Cutter(mesh, x, tolerance).cut();
}

} // namespace gaspard
