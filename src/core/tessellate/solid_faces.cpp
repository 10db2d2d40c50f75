#include "core/tessellate/solid_faces.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>

namespace gaspard {

namespace {

using SortedFace = std::array<std::int32_t, 4>;

std::vector<SortedFace> sorted_faces(const Mesh& mesh) {
    const auto local = cell_faces(mesh.kind);
    GASPARD_CHECK(local.size() == 6);
    std::vector<SortedFace> faces;
    faces.reserve(6 * mesh.cell_count());
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
        for (const auto& corners : local) {
            SortedFace face;
            for (std::size_t k = 0; k < 4; ++k) face[k] = mesh.cell(c)[static_cast<std::size_t>(corners[k])];
            std::sort(face.begin(), face.end());
            faces.push_back(face);
        }
    return faces;
}

/// From the boundary inward, layer by layer.
std::vector<std::uint32_t> depths_of(const SolidFaces& faces) {
    const std::size_t cells = faces.partners.size() / 6;
    std::vector<std::uint32_t> depths(cells, SolidFaces::none), layer, next;
    for (std::uint32_t face = 0; face < faces.partners.size(); ++face)
        if (faces.partners[face] == SolidFaces::none && depths[face / 6] != 0) {
            depths[face / 6] = 0;
            layer.push_back(face / 6);
        }
    for (std::uint32_t depth = 1; !layer.empty(); ++depth, layer.swap(next)) {
        next.clear();
        for (const std::uint32_t cell : layer)
            for (std::uint32_t face = 6 * cell; face < 6 * cell + 6; ++face) {
                const std::uint32_t beyond = faces.cell_beyond(face);
                if (beyond == SolidFaces::none || depths[beyond] != SolidFaces::none) continue;
                depths[beyond] = depth;
                next.push_back(beyond);
            }
    }
    return depths;
}

} // namespace

SolidFaces solid_faces(const Mesh& mesh) {
    const std::vector<SortedFace> faces = sorted_faces(mesh);
    // Counting sort by the smallest corner; few faces have the same one.
    std::vector<std::uint32_t> ends(mesh.node_count() + 1, 0), order(faces.size());
    for (const SortedFace& face : faces) ++ends[static_cast<std::size_t>(face[0]) + 1];
    for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
    for (std::uint32_t i = 0; i < faces.size(); ++i) order[ends[static_cast<std::size_t>(faces[i][0])]++] = i;
    SolidFaces found;
    found.partners.assign(faces.size(), SolidFaces::none);
    std::uint32_t begin = 0;
    for (std::size_t node = 0; node < mesh.node_count(); ++node) {
        for (std::uint32_t i = begin; i < ends[node]; ++i)
            for (std::uint32_t j = i + 1; j < ends[node]; ++j)
                if (faces[order[i]] == faces[order[j]])
                    found.partners[order[i]] = order[j], found.partners[order[j]] = order[i];
        begin = ends[node];
    }
    found.depths = depths_of(found);
    return found;
}

} // namespace gaspard
