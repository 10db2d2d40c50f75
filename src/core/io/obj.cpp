#include "core/base/check.hpp"
#include "core/base/parameter.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/facets.hpp"
#include "core/io/formats.hpp"
#include "core/mesh/number_anew.hpp"
#include "core/tessellate/tessellation.hpp"

#include <cmath>

namespace gaspard {

namespace {

void append_vertex(std::string& text, Vec3 p) {
    GASPARD_CHECK(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    text += "v " + format_number(p.x) + ' ' + format_number(p.y) + ' ' + format_number(p.z) + '\n';
}

/// The OBJ records of one cell as local corner numbers: a line, a face, or the faces of a solid.
std::vector<std::vector<int>> records_of_cell(CellKind kind) {
    if (cell_dimension(kind) == 3) {
        const auto faces = cell_faces(kind);
        return {faces.begin(), faces.end()};
    }
    std::vector<int> all;
    for (int i = 0; i < corners_per_cell(kind); ++i) all.push_back(i);
    return {all};
}

} // namespace

void write_obj(const std::filesystem::path& file, const Mesh& mesh, const Points& positions) {
    GASPARD_CHECK(positions.size() == mesh.node_count());
    auto corners = corners_of_cells(mesh);
    const auto vertices = number_anew(corners, mesh.node_count());
    std::string text =
        "# Gaspard: " + std::to_string(mesh.cell_count()) + " cells (" + cell_name(mesh.kind) + ")\n";
    for (const std::size_t node : vertices) append_vertex(text, positions[node]);

    const auto records = records_of_cell(mesh.kind);
    const char* keyword = cell_dimension(mesh.kind) == 1 ? "l" : "f";
    const auto each = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    for (std::size_t first = 0; first < corners.size(); first += each)
        for (const auto& record : records) {
            text += keyword;
            for (const int corner : record)
                text += ' ' + std::to_string(corners[first + static_cast<std::size_t>(corner)] + 1);
            text += '\n';
        }
    write_atomically(file, text);
}

void write_obj(const std::filesystem::path& file, const Tessellation& shape, const Points& positions) {
    const Points points = shown_points(shape, positions);
    std::string text = "# Gaspard: cells cut into triangles, their edges into lines\n";
    for (std::size_t i = 0; i < points.size(); ++i) append_vertex(text, points[i]);
    const auto number = [](std::uint32_t point) { return ' ' + std::to_string(point + 1); };
    // An object of its own for each kind: some readers take an object with lines for lines alone.
    if (!shape.triangles.empty()) text += "o cells\n";
    for (std::size_t i = 0; i < shape.triangles.size(); i += 3)
        text += 'f' + number(shape.triangles[i]) + number(shape.triangles[i + 1]) +
                number(shape.triangles[i + 2]) + '\n';
    if (!shape.segments.empty()) text += "o edges\n";
    for (std::size_t i = 0; i < shape.segments.size(); i += 2) {
        const bool goes_on = i > 0 && shape.segments[i] == shape.segments[i - 1];
        text += (goes_on ? "" : (i > 0 ? "\nl" : "l") + number(shape.segments[i])) +
                number(shape.segments[i + 1]);
    }
    if (!shape.segments.empty()) text += '\n';
    write_atomically(file, text);
}

} // namespace gaspard
