#include "core/tessellate/cell_lattice.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr std::uint32_t unmade_point = 0xffffffff;
// Nodes are below 2^28, edges between 2^34 and 2^63.
constexpr std::uint64_t on_face = std::uint64_t{1} << 63, inside_cell = on_face | std::uint64_t{1} << 62;

LatticePlace corner_place(CellKind kind, int corner) {
    const Vec3 p = reference_nodes(kind)[static_cast<std::size_t>(corner)];
    return {static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z)};
}

LatticePlace difference(const LatticePlace& a, const LatticePlace& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Of the corner where every coordinate is 0 or m.
std::uint32_t corner_number(const LatticePlace& p) {
    const std::uint32_t square[2][2] = {{0, 1}, {3, 2}};
    return square[p[1] > 0 ? 1 : 0][p[0] > 0 ? 1 : 0] + (p[2] > 0 ? 4U : 0U);
}

} // namespace

LatticeTable::LatticeTable(CellKind kind, int pieces) : kind_(kind), pieces_(pieces) {
    GASPARD_CHECK(kind.shape == CellShape::hexahedron && pieces >= 1 && pieces <= 16);
    constexpr double rounding = 1e-13; // of shape functions at nodes, where they are 0 or 1
    const auto count = static_cast<std::size_t>(nodes_per_cell(kind));
    std::vector<double> values(count);
    std::vector<Vec3> gradients(count);
    for (int k = 0; k <= pieces; ++k)
        for (int j = 0; j <= pieces; ++j)
            for (int i = 0; i <= pieces; ++i) {
                shape_functions(kind, (1.0 / pieces) * Vec3{1.0 * i, 1.0 * j, 1.0 * k}, values, gradients);
                auto& weights = weights_.emplace_back();
                for (std::uint32_t n = 0; n < count; ++n)
                    if (std::abs(values[n]) > rounding)
                        weights.push_back({n, std::abs(values[n] - 1) < rounding ? 1 : values[n]});
            }
    for (std::size_t f = 0; f < 6; ++f) {
        const auto& corners = cell_faces(kind)[f];
        const LatticePlace origin = corner_place(kind, corners[0]);
        frames_[f] = {origin, difference(corner_place(kind, corners[1]), origin),
                      difference(corner_place(kind, corners[3]), origin)};
    }
}

LatticePlace LatticeTable::on_face(int face, int s, int t) const {
    const Frame& frame = frames_[static_cast<std::size_t>(face)];
    LatticePlace place{};
    for (std::size_t d = 0; d < 3; ++d)
        place[d] = pieces_ * frame.origin[d] + s * frame.along[d] + t * frame.across[d];
    return place;
}

std::array<int, 2> LatticeTable::in_face(int face, const LatticePlace& p) const {
    const Frame& frame = frames_[static_cast<std::size_t>(face)];
    int s = 0, t = 0;
    for (std::size_t d = 0; d < 3; ++d) {
        s += (p[d] - pieces_ * frame.origin[d]) * frame.along[d];
        t += (p[d] - pieces_ * frame.origin[d]) * frame.across[d];
    }
    return {s, t};
}

LatticePlace LatticeTable::on_edge(int a, int b, int step) const {
    const LatticePlace from = corner_place(kind_, a), to = corner_place(kind_, b);
    LatticePlace place{};
    for (std::size_t d = 0; d < 3; ++d) place[d] = (pieces_ - step) * from[d] + step * to[d];
    return place;
}

std::uint32_t LatticeTable::faces_of(const LatticePlace& p) const {
    // cell_faces(): bottom, top, front (y = 0), right (x = 1), back, left
    constexpr std::array<std::array<std::uint32_t, 2>, 3> faces = {{{5, 3}, {2, 4}, {0, 1}}};
    std::uint32_t bits = 0;
    for (std::size_t d = 0; d < 3; ++d) {
        if (p[d] == 0) bits |= 1U << faces[d][0];
        if (p[d] == pieces_) bits |= 1U << faces[d][1];
    }
    return bits;
}

LatticePoints::LatticePoints(const Mesh& mesh, const SolidFaces& faces, const LatticeTable& table,
                             const Points& x, double shrink)
    : mesh_(mesh), faces_(faces), table_(table), x_(x), shrink_(shrink),
      nodes_each_(static_cast<std::size_t>(nodes_per_cell(mesh.kind))), own_(table.size(), unmade_point),
      corners_(mesh.node_count(), unmade_point) {
    GASPARD_CHECK(table.kind() == mesh.kind && x.size() == mesh.node_count());
    GASPARD_CHECK(mesh.node_count() < std::size_t{1} << 28);
}

void LatticePoints::begin_cell(std::uint32_t cell) {
    if (cell == cell_) return;
    cell_ = cell;
    std::fill(own_.begin(), own_.end(), unmade_point);
}

std::uint32_t LatticePoints::at(const LatticePlace& place) {
    const std::size_t index = table_.index(place);
    if (own_[index] != unmade_point) return own_[index];
    const std::uint64_t key = key_of(place);
    if (shrink_ > 0 || key >= inside_cell) return own_[index] = make(place, key);
    std::uint32_t& point = key < mesh_.node_count() ? corners_[static_cast<std::size_t>(key)] : inner_[key];
    if (point == unmade_point) point = make(place, key);
    return own_[index] = point;
}

/// The same in all cells that share the point: a node, or what edge_key() and face_key() say.
std::uint64_t LatticePoints::key_of(const LatticePlace& place) const {
    const int m = table_.pieces();
    const auto inside = std::count_if(place.begin(), place.end(), [m](int i) { return i > 0 && i < m; });
    if (inside == 0) return node(corner_number(place));
    if (inside == 1) return edge_key(place);
    return inside == 2 ? face_key(place) : inside_cell + cell_ * table_.size() + table_.index(place);
}

/// The ends of the edge, the smaller first, and the step from there.
std::uint64_t LatticePoints::edge_key(const LatticePlace& place) const {
    const int m = table_.pieces();
    LatticePlace from = place, to = place;
    int step = 0;
    for (std::size_t d = 0; d < 3; ++d)
        if (place[d] > 0 && place[d] < m) from[d] = 0, to[d] = m, step = place[d];
    std::uint64_t a = node(corner_number(from)), b = node(corner_number(to));
    if (a > b) std::swap(a, b), step = m - step;
    return (a + 1) << 34 | b << 4 | static_cast<std::uint64_t>(step);
}

/// The face and the place in it, counted from its corner of the smallest number towards the smaller one of
/// the two corners beside that.
std::uint64_t LatticePoints::face_key(const LatticePlace& place) const {
    const int m = table_.pieces();
    int face = 0;
    while ((table_.faces_of(place) >> face & 1U) == 0) ++face;
    const auto& corners = cell_faces(mesh_.kind)[static_cast<std::size_t>(face)];
    std::array<std::uint32_t, 4> numbers{};
    for (std::size_t k = 0; k < 4; ++k) numbers[k] = node(static_cast<std::uint32_t>(corners[k]));
    const auto first =
        static_cast<std::size_t>(std::min_element(numbers.begin(), numbers.end()) - numbers.begin());
    const auto [s, t] = table_.in_face(face, place);
    const std::array<std::array<int, 2>, 4> turned = {{{s, t}, {t, m - s}, {m - s, m - t}, {m - t, s}}};
    auto [u, v] = turned[first];
    if (numbers[(first + 3) % 4] < numbers[(first + 1) % 4]) std::swap(u, v);
    const auto own = static_cast<std::uint32_t>(6 * cell_) + static_cast<std::uint32_t>(face);
    const std::uint64_t number = std::min(own, faces_.partners[own]);
    return on_face | number << 8 | static_cast<std::uint64_t>(u) << 4 | static_cast<std::uint64_t>(v);
}

std::uint32_t LatticePoints::make(const LatticePlace& place, std::uint64_t rank) {
    ranks_.resize(places_.size()); // points between others have none
    ranks_.push_back(rank);
    Vec3 sum;
    const auto add = [&](std::uint32_t local, double weight) {
        const std::uint32_t number = node(local);
        nodes_.push_back(number);
        weights_.push_back(weight);
        sum = sum + weight * x_[number];
    };
    for (const auto& [local, weight] : table_.weights(table_.index(place)))
        add(local, (1 - shrink_) * weight);
    for (std::uint32_t k = 0; shrink_ > 0 && k < 8; ++k) add(k, shrink_ / 8);
    starts_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    places_.push_back(sum);
    return static_cast<std::uint32_t>(places_.size() - 1);
}

std::uint32_t LatticePoints::between(std::uint32_t a, std::uint32_t b, double t, std::uint32_t label) {
    if (a > b) std::swap(a, b), t = 1 - t;
    std::uint32_t& point = cuts_[std::uint64_t{a} << 34 | std::uint64_t{b} << 4 | label];
    if (point != KeyTable::missing) return point;
    point = static_cast<std::uint32_t>(places_.size());
    for (const auto& [from, part] : {std::pair(a, 1 - t), std::pair(b, t)})
        for (std::uint32_t i = starts_[from]; i < starts_[from + 1]; ++i) {
            nodes_.push_back(nodes_[i]);
            weights_.push_back(part * weights_[i]);
        }
    starts_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    places_.push_back((1 - t) * places_[a] + t * places_[b]);
    return point;
}

void LatticePoints::move_into(Tessellation& out) {
    out.point_count = places_.size();
    out.starts = std::move(starts_);
    out.nodes = std::move(nodes_);
    out.weights = std::move(weights_);
}

} // namespace gaspard
