// Lines of a mesh for vector graphics: few long lines instead of one per edge, and outlines of regions
// instead of single cells. Node numbers only, no positions on the page.
#pragma once

#include "core/io/facets.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

/// A directed edge from node to node, through further nodes if it is curved.
struct Side {
    std::int32_t from = 0, to = 0;
    std::int32_t between = 0; ///< the number of further nodes
    std::array<std::int32_t, highest_order - 1> through{};
    std::span<const std::int32_t> inside() const {
        return std::span(through).first(static_cast<std::size_t>(between));
    }
    Side reversed() const {
        Side other{to, from, between, through};
        std::reverse(other.through.begin(), other.through.begin() + between);
        return other;
    }
    friend bool operator==(const Side&, const Side&) = default;
};

/// An edge of the mesh with its two faces; at the boundary the same face twice.
struct DrawnEdge {
    Side side;
    std::array<std::uint32_t, 2> faces{};
};

/// The sides of one face in order, around it.
std::vector<Side> sides_of_face(const Facets& faces, std::size_t face);

/// Every edge once, sorted by its end nodes (smaller first), directed as in its first face.
std::vector<DrawnEdge> edges_of(const Facets& faces);

/// Joins edges to lines, each edge to one line only; where lines cross, the straightest continuation is
/// taken. `positions` decide what is straight; those of the computational mesh work best.
std::vector<std::vector<Side>> chain(const std::vector<Side>& edges, const Points& positions);

/// Closed lines around the union of these faces; edges between two of them are left out.
std::vector<std::vector<Side>> outline(const Facets& faces, std::span<const std::uint32_t> chosen);

} // namespace gaspard
