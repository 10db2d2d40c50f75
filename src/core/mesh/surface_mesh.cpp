#include "core/mesh/surface_mesh.hpp"

#include "core/base/error.hpp"
#include "core/base/read_file.hpp"
#include "core/base/user_path.hpp"
#include "core/mesh/number_anew.hpp"
#include "core/mesh/surface_formats.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

std::string bytes_of(const std::filesystem::path& file, std::uintmax_t limit) {
    std::error_code trouble;
    const auto status = std::filesystem::status(file, trouble);
    if (!std::filesystem::exists(status) || std::filesystem::is_directory(status)) return read_file(file);
    if (!std::filesystem::is_regular_file(status)) throw InputError("it is not a regular file");
    return read_file(file, limit);
}

std::string_view without_mark(std::string_view bytes) {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3); // UTF-8's byte order mark
    return bytes;
}

/// By the ending of the name.
SurfaceFile parse(const std::filesystem::path& file, std::string_view whole) {
    const std::string_view bytes = without_mark(whole);
    if (bytes.empty()) throw InputError("it is empty");
    if (has_extension(file, ".obj")) return parse_obj(bytes);
    if (has_extension(file, ".off")) return parse_off(bytes);
    if (has_extension(file, ".ply")) return parse_ply(bytes);
    if (has_extension(file, ".stl")) return parse_stl(bytes);
    throw InputError("surface meshes are .obj, .off, .ply or .stl");
}

/// By what it begins with; OBJ has no mark.
SurfaceFile parse(std::string_view whole) {
    const std::string_view bytes = without_mark(whole);
    if (bytes.empty()) throw InputError("it is empty");
    if (bytes.starts_with("ply")) return parse_ply(bytes);
    std::string_view rest = bytes; // behind lines that OFF does not count
    for (auto first = rest.find_first_not_of(" \t\r\n"); first != std::string_view::npos;
         first = rest.find_first_not_of(" \t\r\n")) {
        rest.remove_prefix(first);
        if (!rest.starts_with('#')) break;
        rest.remove_prefix(std::min(rest.find('\n'), rest.size()));
    }
    for (const std::string_view mark : {"OFF", "COFF", "NOFF", "STOFF", "CNOFF"})
        if (rest.starts_with(mark)) return parse_off(bytes);
    return is_stl(bytes) ? parse_stl(bytes) : parse_obj(bytes);
}

/// All faces as triangles, or as quadrilaterals where all are such.
Mesh cells_of(const PolygonFaces& faces) {
    std::size_t least = std::numeric_limits<std::size_t>::max(), most = 0;
    for (std::size_t f = 0; f < faces.size(); ++f)
        least = std::min(least, faces[f].size()), most = std::max(most, faces[f].size());
    Mesh mesh;
    const bool quadrilaterals = least == 4 && most == 4;
    mesh.kind = {quadrilaterals ? CellShape::quadrilateral : CellShape::triangle, 1};
    if (quadrilaterals || most == 3) {
        mesh.cells = faces.corners;
        return mesh;
    }
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t k = 1; k + 1 < faces[f].size(); ++k)
            mesh.cells.insert(mesh.cells.end(), {faces[f][0], faces[f][k], faces[f][k + 1]});
    return mesh;
}

void check(const SurfaceFile& file) {
    constexpr std::size_t most = std::size_t{1} << 26; // some 5 GB of half-edges and sorted sides
    if (file.faces.size() == 0) throw InputError("it has no faces");
    if (file.points.size() > most || file.faces.corners.size() > most)
        throw InputError("it has more than " + std::to_string(most) + " vertices or corners");
    for (std::size_t i = 0; i < file.points.size(); ++i) {
        const Vec3 p = file.points[i];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            throw InputError("vertex " + std::to_string(i + static_cast<std::size_t>(file.base)) +
                             " has a coordinate that is not finite");
    }
    if (const auto fault = fault_of(file.points.size(), file.faces, file.base)) throw InputError(*fault);
    const SurfaceTopology topology(file.points.size(), file.faces);
    if (topology.manifold()) return;
    std::string text;
    for (const auto& fact : topology.facts(3, file.base, false)) text += (text.empty() ? "" : "; ") + fact;
    throw InputError("its surface is not a manifold: " + text);
}

Mesh mesh_of(const SurfaceFile& file) {
    Mesh mesh = cells_of(file.faces);
    const auto kept = number_anew(mesh.cells, file.points.size());
    mesh.nodes = Points(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) mesh.nodes.set(i, file.points[kept[i]]);
    const auto& z = mesh.nodes.z;
    mesh.space_dimension = std::all_of(z.begin(), z.end(), [](double c) { return c == 0; }) ? 2 : 3;
    return mesh;
}

/// The mesh of what `parse_it` returns, with a name for it before what is wrong.
template <class Parse>
Mesh named(const std::string& name, const Parse& parse_it) {
    const std::string start = "cannot read " + name + ": ";
    try {
        const SurfaceFile surface = parse_it();
        check(surface);
        return mesh_of(surface);
    } catch (const InputError& error) {
        const std::string text = error.what();
        throw InputError(text.starts_with(start) ? text : start + text);
    } catch (const std::filesystem::filesystem_error& error) {
        throw InputError(start + error.code().message());
    }
}

} // namespace

Mesh read_surface_mesh(const std::filesystem::path& file, std::uintmax_t limit) {
    return named(file.string(), [&] { return parse(file, bytes_of(file, limit)); });
}

Mesh parse_surface_mesh(std::string_view bytes, const std::string& name) {
    return named(name, [&] { return parse(bytes); });
}

} // namespace gaspard
