#include "core/base/check.hpp"
#include "core/base/parameter.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/formats.hpp"

#include <cmath>

namespace gaspard {

namespace {

/// For every node its number in the file, from 1; 0 for the nodes that are no cell's corner.
std::vector<std::int32_t> number_corners(const Mesh& mesh) {
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    std::vector<std::int32_t> number(mesh.node_count(), 0);
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        for (const auto node : mesh.cell(c).first(corners)) number[static_cast<std::size_t>(node)] = 1;
    std::int32_t last = 0;
    for (auto& n : number)
        if (n != 0) n = ++last;
    return number;
}

void append_vertex(std::string& text, Vec3 p) {
    GASPARD_CHECK(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    text += "v " + format_number(p.x) + ' ' + format_number(p.y) + ' ' + format_number(p.z) + '\n';
}

/// The records of one cell, each as local corner numbers: a line, a face, or the faces of a solid.
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
    const auto number = number_corners(mesh);
    std::string text =
        "# Gaspard: " + std::to_string(mesh.cell_count()) + " cells (" + cell_name(mesh.kind) + ")\n";
    for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] != 0) append_vertex(text, positions[i]);

    const auto records = records_of_cell(mesh.kind);
    const char* keyword = cell_dimension(mesh.kind) == 1 ? "l" : "f";
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        const auto cell = mesh.cell(c);
        for (const auto& record : records) {
            text += keyword;
            for (const int corner : record) {
                const auto node = static_cast<std::size_t>(cell[static_cast<std::size_t>(corner)]);
                text += ' ' + std::to_string(number[node]);
            }
            text += '\n';
        }
    }
    write_atomically(file, text);
}

} // namespace gaspard
