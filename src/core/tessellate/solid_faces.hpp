// How the cells of a solid are joined at their faces, found once per mesh.
#pragma once

#include "core/mesh/mesh.hpp"

#include <cstdint>
#include <vector>

namespace gaspard {

struct SolidFaces {
    static constexpr std::uint32_t none = 0xffffffff; ///< on the other side is nothing
    /// Face k of cell c, in the order of cell_faces(), has the number 6 c + k. For each the number of the
    /// same face as the cell on its other side has it.
    std::vector<std::uint32_t> partners;
    /// Per cell: how many cells lie between it and the boundary, from face to face; 0 at the boundary.
    std::vector<std::uint32_t> depths;

    std::uint32_t cell_beyond(std::uint32_t face) const {
        return partners[face] == none ? none : partners[face] / 6;
    }
};

/// Of a mesh of hexahedra, in linear time.
SolidFaces solid_faces(const Mesh& mesh);

} // namespace gaspard
