// One source for OpenMesh's headers: they are large, and their types stay here.
#include "core/mesh/half_edges.hpp"

#include "core/base/check.hpp"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <array>

namespace gaspard {

namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
std::size_t index(OpenMesh::BaseHandle handle) { return static_cast<std::size_t>(handle.idx()); }

} // namespace

FaceOrientations orient_faces(const PolygonFaces& faces, std::span<const std::int32_t> face_of_side,
                              const SurfaceEdges& edges) {
    constexpr auto none = ~std::uint32_t{0};
    std::vector<std::uint32_t> partner(faces.corners.size(), none); // the other side of a manifold edge
    for (const SurfaceEdge& edge : edges.edges)
        if (edge.count == 2) {
            const auto sides = edges.sides_of(edge);
            partner[sides[0]] = sides[1], partner[sides[1]] = sides[0];
        }
    FaceOrientations result{std::vector<bool>(faces.size()), std::vector<bool>(faces.size(), true)};
    std::vector<bool> reached(faces.size(), false);
    for (std::size_t first = 0; first < faces.size(); ++first) {
        if (reached[first]) continue;
        reached[first] = true;
        std::vector<std::size_t> part = {first};
        bool orientable = true;
        for (std::size_t i = 0; i < part.size(); ++i)
            for (std::uint32_t s = faces.starts[part[i]]; s < faces.starts[part[i] + 1]; ++s) {
                if (partner[s] == none) continue;
                const auto other = index(face_of_side[partner[s]]);
                const bool same_direction = faces.corners[s] == faces.corners[partner[s]];
                const bool reversed = result.reversed[part[i]] != same_direction;
                if (reached[other]) {
                    orientable &= result.reversed[other] == reversed;
                    continue;
                }
                reached[other] = true;
                result.reversed[other] = reversed;
                part.push_back(other);
            }
        if (!orientable)
            for (const auto f : part) result.orientable[f] = false;
    }
    return result;
}

struct HalfEdges::Data {
    OpenMesh::PolyConnectivity mesh;
    std::vector<std::int32_t> vertex_of;   ///< of OpenMesh's vertices, the one in the input
    std::vector<std::int32_t> face_of;     ///< of OpenMesh's faces
    std::vector<std::uint32_t> side_of;    ///< of both half-edges of a boundary edge: its side in the input
    std::vector<std::uint32_t> fan_starts; ///< fans of vertex v are fans[fan_starts[v] .. fan_starts[v + 1])
    std::vector<VertexHandle> fans;
    std::size_t side_count = 0;
};

namespace {

constexpr auto no_side = ~std::uint32_t{0};

/// Fills Data from the input, whose parts it refers to.
template <class Data>
class Builder {
  public:
    Builder(Data& data, const PolygonFaces& faces, std::span<const std::uint32_t> next,
            std::span<const std::int32_t> face_of_side, const SurfaceEdges& edges,
            const FaceOrientations& orientations)
        : data_(data), mesh_(data.mesh), faces_(faces), next_(next), face_of_side_(face_of_side),
          edges_(edges), orientations_(orientations), inside_(2 * faces.corners.size()) {}

    void build(std::size_t vertex_count) {
        mesh_.reserve(vertex_count, edges_.edges.size(), faces_.size());
        for (const SurfaceEdge& edge : edges_.edges) add_edge(edge);
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (const bool sheet : sheets(f)) add_face(f, sheet);
        close_boundaries();
        add_vertices(vertex_count);
    }

  private:
    /// As which the face is there: true is reversed.
    std::span<const bool> sheets(std::size_t face) const {
        static constexpr std::array both = {false, true};
        if (!orientations_.orientable[face]) return both;
        return std::span(both).subspan(orientations_.reversed[face] ? 1 : 0, 1);
    }
    HalfedgeHandle& inside(std::uint32_t side, bool sheet) { return inside_[2 * side + (sheet ? 1 : 0)]; }
    std::size_t face(std::uint32_t side) const { return index(face_of_side_[side]); }

    HalfedgeHandle new_edge() {
        const HalfedgeHandle made = mesh_.new_edge(VertexHandle(0), VertexHandle(0)); // vertices come later
        data_.side_of.resize(mesh_.n_halfedges(), no_side);
        return made;
    }

    void add_edge(const SurfaceEdge& edge) {
        const auto sides = edges_.sides_of(edge);
        if (sides.size() == 2) {
            const bool same = faces_.corners[sides[0]] == faces_.corners[sides[1]];
            for (const bool sheet : sheets(face(sides[0]))) {
                inside(sides[0], sheet) = new_edge();
                inside(sides[1], sheet != same) = mesh_.opposite_halfedge_handle(inside(sides[0], sheet));
            }
            return;
        }
        for (const auto side : sides)
            for (const bool sheet : sheets(face(side))) {
                inside(side, sheet) = new_edge();
                data_.side_of[index(inside(side, sheet))] = side;
                data_.side_of[index(mesh_.opposite_halfedge_handle(inside(side, sheet)))] = side;
            }
    }

    void add_face(std::size_t f, bool sheet) {
        const FaceHandle made = mesh_.new_face();
        data_.face_of.push_back(static_cast<std::int32_t>(f));
        mesh_.set_halfedge_handle(made, inside(faces_.starts[f], sheet));
        for (std::uint32_t s = faces_.starts[f]; s < faces_.starts[f + 1]; ++s) {
            const HalfedgeHandle here = inside(s, sheet), after = inside(next_[s], sheet);
            mesh_.set_face_handle(here, made);
            if (sheet)
                mesh_.set_next_halfedge_handle(after, here);
            else
                mesh_.set_next_halfedge_handle(here, after);
        }
    }

    void close_boundaries() {
        for (const auto h : mesh_.halfedges()) {
            if (!mesh_.is_boundary(h)) continue;
            HalfedgeHandle leaving = mesh_.opposite_halfedge_handle(h);
            while (!mesh_.is_boundary(leaving))
                leaving = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(leaving));
            mesh_.set_next_halfedge_handle(h, leaving);
        }
    }

    /// One per fan; of the two copies of a fan in a double cover only the first is listed.
    void add_vertices(std::size_t vertex_count) {
        std::vector<bool> listed(faces_.corners.size(), false), done(mesh_.n_halfedges(), false);
        std::vector<VertexHandle> found;
        data_.fan_starts.assign(vertex_count + 1, 0);
        for (std::uint32_t corner = 0; corner < faces_.corners.size(); ++corner)
            for (const bool sheet : sheets(face(corner))) {
                // The half-edge of this copy of the face that leaves the corner.
                const HalfedgeHandle leaving =
                    sheet ? mesh_.next_halfedge_handle(inside(corner, true)) : inside(corner, false);
                if (done[index(leaving)]) continue;
                const VertexHandle made = mesh_.new_vertex();
                data_.vertex_of.push_back(faces_.corners[corner]);
                go_around(made, leaving, done);
                if (!listed[corner]) found.push_back(made);
                mark_corners(leaving, listed);
            }
        for (const auto fan : found) ++data_.fan_starts[index(data_.vertex_of[index(fan)]) + 1];
        for (std::size_t v = 0; v < vertex_count; ++v) data_.fan_starts[v + 1] += data_.fan_starts[v];
        data_.fans.resize(found.size());
        auto place = data_.fan_starts;
        for (const auto fan : found) data_.fans[place[index(data_.vertex_of[index(fan)])]++] = fan;
    }

    void go_around(VertexHandle vertex, HalfedgeHandle first, std::vector<bool>& done) {
        mesh_.set_halfedge_handle(vertex, first);
        HalfedgeHandle h = first;
        do {
            done[index(h)] = true;
            mesh_.set_vertex_handle(mesh_.opposite_halfedge_handle(h), vertex);
            if (mesh_.is_boundary(h)) mesh_.set_halfedge_handle(vertex, h); // where an open fan ends
            h = mesh_.ccw_rotated_halfedge_handle(h);
        } while (h != first);
    }

    void mark_corners(HalfedgeHandle first, std::vector<bool>& listed) {
        if (corner_at_.empty()) number_corners();
        HalfedgeHandle h = first;
        do {
            if (!mesh_.is_boundary(h)) listed[corner_at_[index(h)]] = true;
            h = mesh_.ccw_rotated_halfedge_handle(h);
        } while (h != first);
    }
    void number_corners() {
        corner_at_.assign(mesh_.n_halfedges(), no_side);
        for (std::uint32_t corner = 0; corner < faces_.corners.size(); ++corner)
            for (const bool sheet : sheets(face(corner)))
                corner_at_[index(sheet ? mesh_.next_halfedge_handle(inside(corner, true))
                                       : inside(corner, false))] = corner;
    }

    Data& data_;
    OpenMesh::PolyConnectivity& mesh_;
    const PolygonFaces& faces_;
    std::span<const std::uint32_t> next_;
    std::span<const std::int32_t> face_of_side_;
    const SurfaceEdges& edges_;
    const FaceOrientations& orientations_;
    std::vector<HalfedgeHandle> inside_;   ///< of each side and sheet, the half-edge in its face
    std::vector<std::uint32_t> corner_at_; ///< of each half-edge in a face, the corner that it leaves
};

} // namespace

HalfEdges::HalfEdges(std::size_t vertex_count, const PolygonFaces& faces, std::span<const std::uint32_t> next,
                     std::span<const std::int32_t> face_of_side, const SurfaceEdges& edges,
                     const FaceOrientations& orientations) {
    auto data = std::make_unique<Data>();
    data->side_count = faces.corners.size();
    Builder(*data, faces, next, face_of_side, edges, orientations).build(vertex_count);
    data_ = std::move(data);
}
HalfEdges::~HalfEdges() = default;

std::size_t HalfEdges::fan_count(std::int32_t vertex) const {
    return data_->fan_starts[index(vertex) + 1] - data_->fan_starts[index(vertex)];
}

std::vector<VertexFan> HalfEdges::one_rings(std::int32_t vertex) const {
    const auto& mesh = data_->mesh;
    std::vector<VertexFan> rings;
    for (std::size_t i = data_->fan_starts[index(vertex)]; i < data_->fan_starts[index(vertex) + 1]; ++i) {
        const HalfedgeHandle last = mesh.halfedge_handle(data_->fans[i]);
        VertexFan& fan = rings.emplace_back();
        fan.closed = !mesh.is_boundary(last);
        HalfedgeHandle h = last;
        do {
            h = mesh.ccw_rotated_halfedge_handle(h);
            fan.neighbours.push_back(data_->vertex_of[index(mesh.to_vertex_handle(h))]);
            if (!mesh.is_boundary(h)) fan.faces.push_back(data_->face_of[index(mesh.face_handle(h))]);
        } while (h != last);
        if (!fan.closed) continue;
        const auto smallest = std::min_element(fan.neighbours.begin(), fan.neighbours.end());
        std::rotate(fan.faces.begin(), fan.faces.begin() + (smallest - fan.neighbours.begin()),
                    fan.faces.end());
        std::rotate(fan.neighbours.begin(), smallest, fan.neighbours.end());
    }
    return rings;
}

std::vector<std::vector<std::int32_t>> HalfEdges::boundary_loops() const {
    const auto& mesh = data_->mesh;
    std::vector<bool> used(data_->side_count, false);
    std::vector<std::vector<std::int32_t>> loops;
    for (const auto first : mesh.halfedges()) {
        if (!mesh.is_boundary(first) || used[data_->side_of[index(first)]]) continue;
        auto& loop = loops.emplace_back();
        HalfedgeHandle h = first; // runs with the surface on the right
        do {
            used[data_->side_of[index(h)]] = true;
            loop.push_back(data_->vertex_of[index(mesh.to_vertex_handle(h))]);
            h = mesh.next_halfedge_handle(h);
        } while (h != first);
        std::reverse(loop.begin(), loop.end());
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    }
    std::sort(loops.begin(), loops.end());
    return loops;
}

} // namespace gaspard
