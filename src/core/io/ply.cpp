// adapted.ply: corner vertices in double precision with the monitor and its colour, and straight-edged faces.
// Lines are "edge" elements; for solids the boundary is written, or triangles of a section.
#include "core/base/check.hpp"
#include "core/base/version.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/facets.hpp"
#include "core/io/formats.hpp"
#include "core/io/little_endian.hpp"
#include "core/mesh/number_anew.hpp"
#include "core/tessellate/colour_map.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/tessellation.hpp"

#include <cmath>

namespace gaspard {

namespace {

/// The faces or edges of the file, all with the same number of corners.
struct Polygons {
    std::size_t corners = 2; ///< 2: edges
    std::vector<std::int32_t> nodes;
    std::size_t size() const { return nodes.size() / corners; }
};

Polygons polygons_of(const Mesh& mesh) {
    Polygons polygons;
    const auto take = [&](std::span<const std::int32_t> cell) {
        const auto corners = cell.first(polygons.corners);
        polygons.nodes.insert(polygons.nodes.end(), corners.begin(), corners.end());
    };
    if (cell_dimension(mesh.kind) == 1) {
        for (std::size_t c = 0; c < mesh.cell_count(); ++c) take(mesh.cell(c));
        return polygons;
    }
    const Facets faces = shown_faces(mesh);
    polygons.corners = static_cast<std::size_t>(faces.corners);
    for (std::size_t f = 0; f < faces.size(); ++f) take(faces[f]);
    return polygons;
}

/// The vertices of the file.
struct PlyVertices {
    Points x;
    bool monitor = false;
    std::vector<double> values; ///< of the monitor
};

std::string header(const PlyVertices& vertices, const Polygons& polygons) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment Gaspard " + std::string(version()) +
                       "\nelement vertex " + std::to_string(vertices.x.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\n";
    if (vertices.monitor)
        text += "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double monitor\n";
    text += (polygons.corners == 2 ? "element edge " : "element face ") + std::to_string(polygons.size());
    text += polygons.corners == 2 ? "\nproperty int vertex1\nproperty int vertex2\n"
                                  : "\nproperty list uchar int vertex_indices\n";
    return text + "end_header\n";
}

void append_vertices(std::string& bytes, const PlyVertices& vertices) {
    const std::vector<double>& values = vertices.values;
    const ColourMap& map = colour_maps().front();
    const ColourRange range = range_of(values);
    for (std::size_t k = 0; k < vertices.x.size(); ++k) {
        const Vec3 p = vertices.x[k];
        GASPARD_CHECK(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        for (const double value : {p.x, p.y, p.z}) append_little_endian(bytes, value);
        if (!vertices.monitor) continue;
        GASPARD_CHECK(std::isfinite(values[k]));
        for (const unsigned char channel : colour_at(map, range.position(values[k])))
            append_little_endian(bytes, channel);
        append_little_endian(bytes, values[k]);
    }
}

void append_polygons(std::string& bytes, const Polygons& polygons) {
    for (std::size_t i = 0; i < polygons.nodes.size(); ++i) {
        if (polygons.corners != 2 && i % polygons.corners == 0)
            append_little_endian(bytes, static_cast<std::uint8_t>(polygons.corners));
        append_little_endian(bytes, polygons.nodes[i]);
    }
}

void write(const std::filesystem::path& file, const PlyVertices& vertices, const Polygons& polygons) {
    std::string bytes = header(vertices, polygons);
    append_vertices(bytes, vertices);
    append_polygons(bytes, polygons);
    write_atomically(file, bytes);
}

const Field* monitor_at_nodes(const Snapshot& snapshot) {
    GASPARD_CHECK(snapshot.x.size() == snapshot.mesh->node_count());
    const Field* monitor = snapshot.field("monitor");
    GASPARD_CHECK(!monitor || monitor->place == FieldPlace::node);
    return monitor;
}

} // namespace

void write_ply(const std::filesystem::path& file, const Snapshot& snapshot) {
    const Field* monitor = monitor_at_nodes(snapshot);
    Polygons polygons = polygons_of(*snapshot.mesh);
    const auto nodes = number_anew(polygons.nodes, snapshot.x.size());
    PlyVertices vertices{Points(nodes.size()), monitor != nullptr, {}};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        vertices.x.set(k, snapshot.x[nodes[k]]);
        if (monitor) vertices.values.push_back(monitor->values[nodes[k]]);
    }
    write(file, vertices, polygons);
}

void write_ply(const std::filesystem::path& file, const Snapshot& snapshot, const Tessellation& shape) {
    const Field* monitor = monitor_at_nodes(snapshot);
    PlyVertices vertices{shown_points(shape, snapshot.x), monitor != nullptr, {}};
    if (monitor) vertices.values = shown_values(shape, monitor->values);
    write(file, vertices, {3, {shape.triangles.begin(), shape.triangles.end()}});
}

} // namespace gaspard
