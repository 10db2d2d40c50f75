// How the faces of a surface are connected: edges, one-rings, boundary loops, components, orientation and
// manifoldness, from vertex numbers alone. Faces are polygons; of cells of order 2 only the corners count.
//
// Numbering. Vertices and faces have the numbers of the input. Corner k of the concatenated faces is also
// side k: it runs from that corner to the next one of its face. Edges are sorted by their vertices, smaller
// vertex first. Lists of faces, edges and vertices are ascending unless stated otherwise.
//
// Surfaces that are not oriented manifolds are described, not repaired:
//   - An edge with three or more faces is treated as a cut: each of its faces has a boundary there.
//   - A vertex whose faces do not form one fan (a pinched vertex) has one ring per fan, and boundary loops
//     through different fans are different loops.
//   - Faces are taken in the orientation of the first face of their component. On a component that cannot be
//     oriented (a Möbius strip), rings and loops are still complete; each is ordered as seen from one of its
//     faces, so that neighbouring rings may run in opposite directions.
#pragma once

#include "core/base/export.hpp"
#include "core/mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gaspard GASPARD_API {

/// Polygons by the numbers of their vertices, one after another.
struct PolygonFaces {
    std::vector<std::uint32_t> starts = {0}; ///< #F + 1: face f has the corners starts[f] to starts[f + 1]
    std::vector<std::int32_t> corners;

    std::size_t size() const { return starts.size() - 1; }
    std::span<const std::int32_t> operator[](std::size_t face) const {
        return std::span(corners).subspan(starts[face], starts[face + 1] - starts[face]);
    }
    void add(std::span<const std::int32_t> face) {
        corners.insert(corners.end(), face.begin(), face.end());
        starts.push_back(static_cast<std::uint32_t>(corners.size()));
    }
};

/// What is wrong with the first face that has fewer than three corners, the same vertex twice, or a vertex
/// out of range: "face 3 names vertex 9, but there are 4 vertices". Faces and vertices are counted from
/// `base`.
std::optional<std::string> fault_of(std::size_t vertex_count, const PolygonFaces& faces,
                                    std::int32_t base = 0);

/// The corners of the cells of a surface (cell dimension 2, any order).
PolygonFaces polygon_faces(const Mesh& mesh);

struct SurfaceEdge {
    std::array<std::int32_t, 2> vertices{}; ///< smaller first
    std::uint32_t first = 0, count = 0;     ///< its sides are SurfaceEdges::sides[first .. first + count)
};

/// All edges with the sides that lie on them; one side at the boundary, two inside.
struct SurfaceEdges {
    std::vector<SurfaceEdge> edges;   ///< sorted by their vertices
    std::vector<std::uint32_t> sides; ///< edge by edge, ascending for each

    std::span<const std::uint32_t> sides_of(const SurfaceEdge& edge) const {
        return std::span(sides).subspan(edge.first, edge.count);
    }
};

/// Linear in the number of sides; no half-edge structure is built. `corners` is as in PolygonFaces, `next[k]`
/// the corner after k in its face. Vertices are smaller than `vertex_count`.
SurfaceEdges surface_edges(std::size_t vertex_count, std::span<const std::int32_t> corners,
                           std::span<const std::uint32_t> next);
/// The same for faces with `corners_each` corners.
SurfaceEdges surface_edges(std::size_t vertex_count, std::span<const std::int32_t> corners,
                           std::size_t corners_each);

/// Neighbours of a vertex, counterclockwise. An open fan has one neighbour more than faces: face i lies
/// between neighbours i and i + 1. In a closed fan the last face lies between the last and the first
/// neighbour, and the first neighbour is the smallest.
struct VertexFan {
    std::vector<std::int32_t> neighbours, faces;
    bool closed = false;
};

class SurfaceTopology {
  public:
    /// Throws InputError with fault_of().
    SurfaceTopology(std::size_t vertex_count, PolygonFaces faces);
    /// Of the corners of a mesh of surface cells; other nodes are isolated vertices.
    explicit SurfaceTopology(const Mesh& mesh);
    ~SurfaceTopology();
    SurfaceTopology(SurfaceTopology&&) noexcept;
    SurfaceTopology& operator=(SurfaceTopology&&) noexcept;

    std::size_t vertex_count() const;
    const PolygonFaces& faces() const;
    const SurfaceEdges& edges() const;
    std::int32_t face_of_side(std::uint32_t side) const;

    /// One fan per vertex of a manifold; several at a pinched vertex; none at an isolated one.
    std::vector<VertexFan> one_rings(std::int32_t vertex) const;
    /// Closed lines of vertices with the surface on the left: counterclockwise around a positively oriented
    /// region of the plane, clockwise around its holes. Each begins with its smallest vertex; sorted.
    std::vector<std::vector<std::int32_t>> boundary_loops() const;

    /// Faces that share an edge are in one component; per face its number, in the order of first faces.
    std::span<const std::int32_t> components() const;
    std::size_t component_count() const;

    /// Edges whose two faces run along them in the same direction.
    std::vector<std::uint32_t> inconsistent_edges() const;
    bool orientable() const;
    /// Faces to reverse so that all are oriented as the first one that they are connected with by manifold
    /// edges; empty if they are already, and for parts that cannot be oriented.
    std::vector<std::int32_t> reversed_faces() const;

    std::vector<std::uint32_t> complex_edges() const;   ///< with three or more faces
    std::vector<std::int32_t> pinched_vertices() const; ///< those at complex edges are left out
    /// No complex edge and no pinched vertex.
    bool manifold() const;
    /// #V - #E + #F, without isolated vertices: 1 for a disk, 2 for a sphere, 0 for a torus or Möbius strip.
    std::int64_t euler_characteristic() const;

    /// What keeps this surface from being a consistently oriented manifold, one fact each: "edge 12-40 has
    /// three faces", "vertex 7 joins 2 fans of faces", and, with `orientation`, "the faces at edge 3-4 have
    /// opposite orientations" or "not orientable". At most `most` facts of a kind are named; vertices are
    /// counted from `base`.
    std::vector<std::string> facts(std::size_t most = 3, std::int32_t base = 0,
                                   bool orientation = true) const;

  private:
    struct Data;
    std::unique_ptr<const Data> data_;
};

} // namespace GASPARD_API
