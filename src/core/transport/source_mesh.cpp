#include "core/transport/source_mesh.hpp"

#include "core/base/error.hpp"
#include "core/base/fnv1a.hpp"
#include "core/base/read_data_file.hpp"
#include "core/base/user_path.hpp"
#include "core/mesh/surface_mesh.hpp"
#include "core/transport/lagrange_triangles.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

namespace gaspard {

namespace {

constexpr std::uintmax_t largest_source_file = std::uintmax_t{64} << 20; ///< bytes

Mesh read(const std::string& text, const std::filesystem::path& folder) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw InputError("it must name a mesh of the source");
    if (is_path(text)) return read_surface_mesh(user_path(text, folder), largest_source_file);
    return parse_surface_mesh(read_data_file(text, folder, largest_source_file), data_file_name(text));
}

Mesh in_triangles(Mesh mesh) {
    if (mesh.kind.shape != CellShape::quadrilateral) return mesh;
    Mesh cut{.kind = {CellShape::triangle, 1},
             .space_dimension = mesh.space_dimension,
             .nodes = std::move(mesh.nodes),
             .cells = {}};
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        const auto q = mesh.cell(c);
        const auto length = [&](std::size_t a, std::size_t b) {
            return norm(cut.nodes[static_cast<std::size_t>(q[a])] -
                        cut.nodes[static_cast<std::size_t>(q[b])]);
        };
        if (length(0, 2) <= length(1, 3))
            cut.cells.insert(cut.cells.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
        else
            cut.cells.insert(cut.cells.end(), {q[0], q[1], q[3], q[1], q[2], q[3]});
    }
    return cut;
}

/// `has`: what has the triangles.
void check_count(std::size_t triangles, const std::string& has) {
    if (triangles > most_source_triangles)
        throw InputError(has + " " + std::to_string(triangles) + " triangles; at most " +
                         std::to_string(most_source_triangles) + " are possible");
}

/// The hash of numbers.
class NumberHash {
  public:
    void add(std::uint64_t number) {
        std::array<char, sizeof number> bytes;
        std::memcpy(bytes.data(), &number, sizeof number);
        hash_ = fnv1a({bytes.data(), bytes.size()}, hash_);
    }
    std::string text() const {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
        return digits;
    }

  private:
    std::uint64_t hash_ = fnv1a_start;
};

} // namespace

SourceMesh read_source_mesh(const std::string& text, const std::filesystem::path& folder) {
    try {
        Mesh mesh = in_triangles(read(text, folder));
        check_count(mesh.cell_count(), "it has");
        SourceMesh source{.convex = convex_mesh(std::move(mesh)), .name = {}, .topology = {}};
        NumberHash hash;
        for (const auto node : source.convex.mesh.cells) hash.add(static_cast<std::uint64_t>(node));
        source.topology = hash.text();
        for (const auto* coordinate : {&source.convex.mesh.nodes.x, &source.convex.mesh.nodes.y})
            for (const double value : *coordinate) hash.add(std::bit_cast<std::uint64_t>(value));
        source.name = "mesh " + hash.text();
        return source;
    } catch (const InputError& error) {
        const std::string what = error.what();
        const std::string file = what.starts_with("cannot read") || what.starts_with("it must")
                                     ? std::string()
                                     : data_file_name(text, folder) + ": ";
        throw InputError("domain.file: " + file + what);
    }
}

ConvexMesh refined(const ConvexMesh& mesh, int times) {
    ConvexMesh fine = mesh;
    check_count(mesh.mesh.cell_count() << 2 * times,
                "domain.refinements = " + std::to_string(times) + " gives the mesh");
    for (int i = 0; i < times; ++i) {
        const LagrangeTriangles halved(fine.mesh, {.nodes = fine.boundary_nodes}, 2);
        ConvexMesh next;
        next.mesh = {.kind = fine.mesh.kind, .space_dimension = 2, .nodes = halved.nodes(), .cells = {}};
        for (std::size_t c = 0; c < halved.cell_count(); ++c) {
            const auto n = halved.cell(c);
            next.mesh.cells.insert(next.mesh.cells.end(),
                                   {n[0], n[3], n[5], n[3], n[1], n[4], n[5], n[4], n[2], n[3], n[4], n[5]});
        }
        for (std::size_t s = 0; s < fine.boundary_nodes.size(); ++s) {
            const auto& [cell, edge] = halved.sides()[s];
            const auto middle = halved.cell(cell)[3 + static_cast<std::size_t>(edge)];
            next.boundary_nodes.insert(next.boundary_nodes.end(), {fine.boundary_nodes[s], middle});
        }
        fine = std::move(next);
    }
    return fine;
}

} // namespace gaspard
