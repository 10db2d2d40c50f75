// The parsers behind read_surface_mesh(), one per format. Each throws InputError with what is wrong, without
// the file's name. Vertex numbers are not checked here.
#pragma once

#include "core/mesh/surface_topology.hpp"

#include <string_view>
#include <vector>

namespace gaspard {

struct SurfaceFile {
    std::vector<Vec3> points;
    PolygonFaces faces;
    std::int32_t base = 0; ///< the number of the first vertex and face, as users of the format count
};

SurfaceFile parse_obj(std::string_view text);
SurfaceFile parse_off(std::string_view text);
SurfaceFile parse_ply(std::string_view bytes);
SurfaceFile parse_stl(std::string_view bytes);
/// Whether the bytes are those of an STL file, by their size or their first word.
bool is_stl(std::string_view bytes);

} // namespace gaspard
