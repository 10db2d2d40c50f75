// Surface meshes from files: OBJ, OFF, PLY and STL.
#pragma once

#include "core/base/export.hpp"
#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace gaspard GASPARD_API {

/// The largest file that is read unless the caller says otherwise.
inline constexpr std::uintmax_t largest_surface_file = std::uintmax_t{1} << 30;

/// Reads a mesh of triangles or polygons; the extension .obj, .off, .ply or .stl (any case) tells the format.
///
/// The result has order 1, and space dimension 2 if z is 0 everywhere, else 3. If all faces are triangles or
/// all are quadrilaterals they become the cells, in the file's order; otherwise every face is cut into
/// triangles from its first corner, which suits convex faces. Vertices without a face are left out; the
/// others keep their order. Coordinates are read in double precision (in binary files, as they are stored),
/// whatever the locale is. Normals, colours, textures and materials are ignored.
///
/// OBJ: `v` and `f` records, with relative (negative) numbers too. OFF: text, also COFF, NOFF and STOFF, one
/// vertex or face per line. PLY: text and binary of either byte order; other elements are skipped. STL: text
/// and binary; equal corners become one vertex, triangles with two equal corners are left out.
///
/// Throws InputError, one sentence with the file's name, if the file is missing, not a regular file, larger
/// than `limit` bytes, empty, or not of its format; if it has no faces, a coordinate that is not finite, or a
/// vertex number out of range; and if the surface is not a manifold ("edge 12-40 has three faces"). Faces
/// are not reversed: SurfaceTopology tells whether their orientations agree.
Mesh read_surface_mesh(const std::filesystem::path& file, std::uintmax_t limit = largest_surface_file);

/// The mesh of a file's bytes; how they begin tells the format. `name` stands for the file in errors.
Mesh parse_surface_mesh(std::string_view bytes, const std::string& name);

} // namespace GASPARD_API
