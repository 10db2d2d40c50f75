// The lines of a mesh for a drawing program: few long ones instead of one per edge, and outlines of regions
// instead of single cells. Numbers only, no positions on paper.
#pragma once

#include "core/io/facets.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

/// From a node to a node, through a middle one where the edge is curved (-1: straight).
struct Side {
    std::int32_t from = 0, to = 0, middle = -1;
    Side reversed() const { return {to, from, middle}; }
    friend bool operator==(const Side&, const Side&) = default;
};

/// An edge of the mesh with the faces beside it; the same face twice at the border.
struct DrawnEdge {
    Side side;
    std::array<std::uint32_t, 2> faces{};
};

/// The sides of one face in order, around it.
std::vector<Side> sides_of_face(const Facets& faces, std::size_t face);

/// Every edge once.
std::vector<DrawnEdge> edges_of(const Facets& faces);

/// Strings edges together, each into one line only, going straight on where lines cross. `positions` tell
/// what is straight: best those of the computational mesh.
std::vector<std::vector<Side>> chain(const std::vector<Side>& edges, const Points& positions);

/// Closed lines around the union of these faces; what lies between two of them is left out.
std::vector<std::vector<Side>> outline(const Facets& faces, std::span<const std::uint32_t> chosen);

} // namespace gaspard
