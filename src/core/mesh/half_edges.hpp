// The half-edge structure behind SurfaceTopology, on OpenMesh's connectivity. Internal: ask SurfaceTopology.
#pragma once

#include "core/mesh/surface_topology.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// Orientation of every face relative to the first one that manifold edges connect it with.
struct FaceOrientations {
    std::vector<bool> reversed;
    std::vector<bool> orientable; ///< false for every face of a part that cannot be oriented
};
FaceOrientations orient_faces(const PolygonFaces& faces, std::span<const std::int32_t> face_of_side,
                              const SurfaceEdges& edges);

/// Edges with two faces join them; all others are boundaries of their faces. Every fan of faces at a vertex
/// is a vertex of its own. A part that cannot be oriented is replaced by its orientation double cover, which
/// can: it has every face twice, once in each orientation, and the two copies of a fan or loop differ only
/// in direction, so that one of them is kept.
class HalfEdges {
  public:
    HalfEdges(std::size_t vertex_count, const PolygonFaces& faces, std::span<const std::uint32_t> next,
              std::span<const std::int32_t> face_of_side, const SurfaceEdges& edges,
              const FaceOrientations& orientations);
    ~HalfEdges();

    std::size_t fan_count(std::int32_t vertex) const;
    std::vector<VertexFan> one_rings(std::int32_t vertex) const;
    std::vector<std::vector<std::int32_t>> boundary_loops() const;

  private:
    struct Data;
    std::unique_ptr<const Data> data_;
};

} // namespace gaspard
