// The mesh of a source domain from a file: OBJ, OFF, PLY or STL.
#pragma once

#include "core/transport/boundary_loop.hpp"

#include <filesystem>
#include <string>

namespace gaspard {

/// The most triangles of a source's mesh: those of 128 rings.
inline constexpr std::size_t most_source_triangles = 6 * 128 * 128;

struct SourceMesh {
    ConvexMesh convex;
    std::string name;     ///< "mesh 12ab...": equal for equal nodes and triangles, in whatever file they are
    std::string topology; ///< "12ab...", of the triangles alone
};

/// Reads a mesh as parse_surface_mesh() and read_surface_mesh() do, cuts quadrilaterals along their shorter
/// diagonals, and checks it with convex_mesh(). `text`: the value of a row with the role `file`
/// (base/read_data_file.hpp), relative to `folder`. Throws InputError, one sentence with the file's name,
/// also if there are too many triangles.
SourceMesh read_source_mesh(const std::string& text, const std::filesystem::path& folder);

/// Each triangle divided into four through the middles of its edges, so many times. The first nodes are those
/// of the mesh. Throws InputError if there would be more than most_source_triangles.
ConvexMesh refined(const ConvexMesh& mesh, int times);
/// Without inner nodes no map is found.
inline bool has_inner_nodes(const ConvexMesh& mesh) {
    return mesh.mesh.node_count() > mesh.boundary_nodes.size();
}

} // namespace gaspard
