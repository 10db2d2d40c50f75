#include "core/tessellate/section.hpp"

#include "core/base/box.hpp"
#include "core/base/check.hpp"
#include "core/tessellate/clip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

enum class CellState : char { hidden, untouched, cut };

std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// The state of every cell. Curved cells may reach a little farther than their nodes.
std::vector<CellState> states_of(const Mesh& mesh, const Points& x, std::span<const char> visible,
                                 const Clipper& clipper, double shrink, double tolerance) {
    std::vector<CellState> states(mesh.cell_count());
    for (std::size_t c = 0; c < states.size(); ++c)
        states[c] = visible[c] != 0 ? CellState::untouched : CellState::hidden;
    const double further = mesh.kind.order > 1 ? 0.15 : 0;
    const auto planes = clipper.planes();
    std::vector<std::vector<double>> away(planes.size(), std::vector<double>(x.size()));
    for (std::size_t k = 0; k < planes.size(); ++k)
        for (std::size_t i = 0; i < x.size(); ++i) away[k][i] = planes[k].distance(x[i]);
    for (std::size_t c = 0; c < states.size(); ++c) {
        if (states[c] == CellState::hidden) continue;
        for (const Clipper::Wedge& wedge : clipper.wedges()) {
            bool before = false, beyond = true;
            for (std::uint32_t k = wedge.begin; k < wedge.end; ++k) {
                double low = 1e300, high = -1e300, middle = 0;
                const auto nodes = mesh.cell(c);
                for (std::size_t n = 0; n < nodes.size(); ++n) {
                    const double d = away[k][static_cast<std::size_t>(nodes[n])];
                    low = std::min(low, d), high = std::max(high, d);
                    if (n < 8) middle += d / 8;
                }
                low = low + shrink * (middle - low) - further * (high - low);
                high = high + shrink * (middle - high) + further * (high - low);
                before = before || high < -tolerance;
                beyond = beyond && low >= -tolerance;
            }
            if (beyond) states[c] = CellState::hidden;
            if (beyond) break;
            if (!before) states[c] = CellState::cut;
        }
    }
    return states;
}

/// A segment with the points that are far from it in the one or two cells or faces beside it.
struct LineBetween {
    std::uint32_t from = 0, to = 0, first = 0, second = 0;
};

class SectionBuilder {
  public:
    SectionBuilder(const Mesh& mesh, const SolidFaces& faces, const LatticeTable& table, const Points& x,
                   std::span<const char> visible, const InsideChoice& choice, double tolerance)
        : mesh_(mesh), faces_(faces), visible_(visible), points_(mesh, faces, table, x, choice.explode),
          clipper_(choice.whole_cells ? std::vector<CutWedge>() : choice.cut, tolerance, points_),
          states_(states_of(mesh, x, visible, clipper_, choice.explode, tolerance)), pieces_(table.pieces()),
          apart_(choice.explode > 0) {}

    Tessellation build() {
        for (std::uint32_t c = 0; c < states_.size(); ++c) {
            if (states_[c] == CellState::hidden) continue;
            points_.begin_cell(c);
            for (int f = 0; f < 6; ++f)
                if (is_outer(c, f)) add_face(c, f);
            if (states_[c] == CellState::cut) add_caps(c);
            if (apart_) draw_edges();
        }
        draw_edges();
        for (const LineBetween& line : cap_lines_) put_line(line);
        out_.caps = cap_cells_.size();
        out_.triangles.insert(out_.triangles.end(), caps_.begin(), caps_.end());
        out_.triangle_cells.insert(out_.triangle_cells.end(), cap_cells_.begin(), cap_cells_.end());
        out_.cuts = pieces_;
        points_.move_into(out_);
        return std::move(out_);
    }

  private:
    struct CellEdge {
        std::uint32_t cell = 0;
        int a = 0, b = 0; ///< local corners
        /// The opposite side of an adjacent face, in the same direction.
        struct Opposite {
            std::uint32_t cell = 0;
            int a = 0, b = 0;
        };
        Opposite sides[2]{};
    };
    using Quadrilateral = std::array<std::uint32_t, 4>;

    bool is_outer(std::uint32_t cell, int face) const {
        if (apart_) return true;
        const std::uint32_t beyond = faces_.cell_beyond(6 * cell + static_cast<std::uint32_t>(face));
        return beyond == SolidFaces::none || visible_[beyond] == 0;
    }
    std::uint32_t node(std::uint32_t cell, int local) const {
        return static_cast<std::uint32_t>(mesh_.cell(cell)[static_cast<std::size_t>(local)]);
    }

    void add_face(std::uint32_t cell, int face) {
        const auto at = [&](int s, int t) { return points_.at(points_.table().on_face(face, s, t)); };
        for (int t = 0; t < pieces_; ++t)
            for (int s = 0; s < pieces_; ++s)
                add_quadrilateral(cell, {at(s, t), at(s + 1, t), at(s + 1, t + 1), at(s, t + 1)});
        const auto& k = cell_faces(mesh_.kind)[static_cast<std::size_t>(face)];
        for (std::size_t e = 0; e < 4; ++e) {
            const int a = k[e], b = k[(e + 1) % 4];
            const CellEdge::Opposite side{cell, k[(e + 3) % 4], k[(e + 2) % 4]};
            std::uint32_t& number = edge_numbers_[pair_key(node(cell, a), node(cell, b))];
            if (number == KeyTable::missing) {
                number = static_cast<std::uint32_t>(edges_.size());
                edges_.push_back({cell, a, b, {side, side}});
                continue;
            }
            CellEdge& edge = edges_[number];
            edge.sides[1] = side;
            if (node(edge.cell, edge.a) != node(cell, a)) std::swap(edge.sides[1].a, edge.sides[1].b);
        }
    }

    /// Starts at a neighbour of the corner of the lowest rank, through which the diagonal goes.
    Quadrilateral turned(const Quadrilateral& q) const {
        const auto lower = [&](auto a, auto b) { return points_.rank(a) < points_.rank(b); };
        const auto lowest = static_cast<std::size_t>(std::min_element(q.begin(), q.end(), lower) - q.begin());
        return {q[(lowest + 3) % 4], q[lowest], q[(lowest + 1) % 4], q[(lowest + 2) % 4]};
    }

    void add_quadrilateral(std::uint32_t cell, const Quadrilateral& corners) {
        const Quadrilateral q = turned(corners);
        if (states_[cell] == CellState::untouched) {
            put_triangle(cell, q[0], q[1], q[3]);
            put_triangle(cell, q[1], q[2], q[3]);
            return;
        }
        for (const auto& [a, b, c] : {std::array{q[0], q[1], q[3]}, std::array{q[1], q[2], q[3]}})
            clipper_.outside({{a}, {b}, {c}}, [&](const ClipPolygon& part) {
                for (std::size_t i = 1; i + 1 < part.size(); ++i)
                    put_triangle(cell, part[0].point, part[i].point, part[i + 1].point);
            });
    }

    void put_triangle(std::uint32_t cell, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        out_.triangles.insert(out_.triangles.end(), {a, b, c});
        out_.triangle_cells.push_back(cell);
    }

    /// Caps of one cell, plane by plane.
    void add_caps(std::uint32_t cell) {
        for (std::uint32_t wedge = 0; wedge < clipper_.wedges().size(); ++wedge)
            for (std::uint32_t plane = clipper_.wedges()[wedge].begin; plane < clipper_.wedges()[wedge].end;
                 ++plane) {
                outline_.clear();
                for (int k = 0; k < pieces_; ++k)
                    for (int j = 0; j < pieces_; ++j)
                        for (int i = 0; i < pieces_; ++i) cut_part(cell, {i, j, k}, wedge, plane);
                put_outline();
            }
    }

    void cut_part(std::uint32_t cell, const LatticePlace& place, std::uint32_t wedge, std::uint32_t plane) {
        std::array<ClipCorner, 8> corners;
        bool before = false, beyond = false;
        for (int n = 0; n < 8; ++n) {
            LatticePlace at = points_.table().on_edge(n, n, 0);
            for (std::size_t d = 0; d < 3; ++d) at[d] = place[d] + (at[d] > 0 ? 1 : 0);
            ClipCorner& corner = corners[static_cast<std::size_t>(n)];
            corner = {points_.at(at), points_.table().faces_of(at)};
            (clipper_.distance(corner.point, plane) < 0 ? before : beyond) = true;
        }
        if (!before || !beyond) return;
        const auto lower = [&](int a, int b) {
            return points_.rank(corners[static_cast<std::size_t>(a)].point) <
                   points_.rank(corners[static_cast<std::size_t>(b)].point);
        };
        int lowest = 0;
        for (int n = 1; n < 8; ++n)
            if (lower(n, lowest)) lowest = n;
        for (const auto& face : cell_faces(mesh_.kind)) {
            if (std::find(face.begin(), face.end(), lowest) != face.end()) continue;
            const auto first =
                static_cast<std::size_t>(std::min_element(face.begin(), face.end(), lower) - face.begin());
            const auto corner = [&](std::size_t k) {
                return corners[static_cast<std::size_t>(face[(first + k) % 4])];
            };
            const ClipCorner apex = corners[static_cast<std::size_t>(lowest)];
            cut_tetrahedron(cell, {apex, corner(0), corner(1), corner(2)}, wedge, plane);
            cut_tetrahedron(cell, {apex, corner(0), corner(2), corner(3)}, wedge, plane);
        }
    }

    void cut_tetrahedron(std::uint32_t cell, const std::array<ClipCorner, 4>& corners, std::uint32_t wedge,
                         std::uint32_t plane) {
        std::array<ClipCorner, 4> before, beyond;
        std::size_t b = 0, h = 0;
        for (const ClipCorner& corner : corners)
            if (clipper_.distance(corner.point, plane) < 0)
                before[b++] = corner;
            else
                beyond[h++] = corner;
        if (b == 0 || h == 0) return;
        ClipPolygon cap;
        const auto cross = [&](std::size_t i, std::size_t j) {
            cap.add(clipper_.cross(before[i], beyond[j], plane));
        };
        if (b == 2)
            cross(0, 0), cross(0, 1), cross(1, 1), cross(1, 0);
        else
            for (std::size_t i = 0; i < 3; ++i) cross(b == 1 ? 0 : i, b == 1 ? i : 0);
        cap.close();
        if (cap.size() < 3) return;
        if (dot(normal_of(cap), clipper_.planes()[plane].normal) < 0) cap.reverse();
        cap = clipper_.within_wedge(cap, wedge, plane);
        if (cap.size() < 3) return;
        clipper_.outside(
            cap, [&](const ClipPolygon& part) { put_cap(cell, part); }, 0, wedge, plane);
    }

    /// Twice the area long.
    Vec3 normal_of(const ClipPolygon& polygon) const {
        Vec3 sum;
        const Vec3 first = points_.place(polygon[0].point);
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            sum = sum +
                  cross(points_.place(polygon[i].point) - first, points_.place(polygon[i + 1].point) - first);
        return sum;
    }

    void put_cap(std::uint32_t cell, const ClipPolygon& cap) {
        for (std::size_t i = 1; i + 1 < cap.size(); ++i) {
            caps_.insert(caps_.end(), {cap[0].point, cap[i].point, cap[i + 1].point});
            cap_cells_.push_back(cell);
        }
        std::uint32_t all = ~0U; // what the whole piece lies on: its plane, or a face
        for (const ClipCorner& corner : cap.corners()) all &= corner.marks;
        for (std::size_t i = 0; i < cap.size(); ++i)
            if ((cap[i].marks & cap[i + 1].marks & ~all) != 0)
                outline_.emplace_back(cap[i].point, cap[i + 1].point);
    }

    /// The outline of one cell's cap, each line once for the two cells or caps that it lies between.
    void put_outline() {
        for (const auto& [from, to] : outline_) {
            const Vec3 start = points_.place(from), along = points_.place(to) - start;
            std::uint32_t far = from;
            double farthest = 0;
            for (const auto& [other, unused] : outline_) {
                const Vec3 away = cross(points_.place(other) - start, along);
                if (dot(away, away) > farthest) farthest = dot(away, away), far = other;
            }
            std::uint32_t& number = line_numbers_[pair_key(from, to)];
            if (number == KeyTable::missing) {
                number = static_cast<std::uint32_t>(cap_lines_.size());
                cap_lines_.push_back({from, to, far, far});
            } else {
                cap_lines_[number].second = far;
            }
        }
    }

    void put_line(const LineBetween& line) {
        out_.segments.insert(out_.segments.end(), {line.from, line.to});
        out_.segment_sides.insert(out_.segment_sides.end(), {line.first, line.second});
    }

    /// Those of the outer faces found so far.
    void draw_edges() {
        std::vector<LineBetween> lines(static_cast<std::size_t>(pieces_));
        const auto along = [&](std::uint32_t cell, int a, int b, int step) {
            points_.begin_cell(cell);
            return points_.at(points_.table().on_edge(a, b, step));
        };
        for (const CellEdge& edge : edges_) {
            for (int i = 0; i < pieces_; ++i) {
                LineBetween line{along(edge.cell, edge.a, edge.b, i),
                                 along(edge.cell, edge.a, edge.b, i + 1)};
                line.first = along(edge.sides[0].cell, edge.sides[0].a, edge.sides[0].b, i + 1);
                line.second = along(edge.sides[1].cell, edge.sides[1].a, edge.sides[1].b, i + 1);
                if (states_[edge.cell] == CellState::untouched)
                    put_line(line);
                else
                    clipper_.outside({{line.from}, {line.to}}, [&](const ClipPolygon& part) {
                        put_line({part[0].point, part[1].point, line.first, line.second});
                    });
            }
        }
        edges_.clear();
        edge_numbers_.clear();
    }

    const Mesh& mesh_;
    const SolidFaces& faces_;
    std::span<const char> visible_;
    LatticePoints points_;
    Clipper clipper_;
    std::vector<CellState> states_;
    int pieces_;
    bool apart_; ///< cells do not touch
    Tessellation out_;
    std::vector<std::uint32_t> caps_, cap_cells_;
    std::vector<CellEdge> edges_;
    KeyTable edge_numbers_, line_numbers_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> outline_;
    std::vector<LineBetween> cap_lines_;
};

} // namespace

SectionMaker::SectionMaker(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const SolidFaces> faces)
    : mesh_(std::move(mesh)), faces_(std::move(faces)), tolerance_(1e-9 * bounding_box(mesh_->nodes).size()) {
}

Tessellation SectionMaker::make(const Points& x, std::span<const char> visible, const InsideChoice& choice,
                                int pieces) {
    GASPARD_CHECK(visible.size() == mesh_->cell_count());
    const int order = mesh_->kind.order;
    if (order != 2) pieces = order;
    constexpr auto most = std::size_t{600000}; // triangles of cells that stand apart
    const auto triangles = [&] { return 12 * visible.size() * static_cast<std::size_t>(pieces * pieces); };
    while (order == 2 && choice.explode > 0 && pieces > 2 && triangles() > most) --pieces;
    if (table_.pieces() != pieces) table_ = LatticeTable(mesh_->kind, pieces);
    return SectionBuilder(*mesh_, *faces_, table_, x, visible, choice, tolerance_).build();
}

} // namespace gaspard
