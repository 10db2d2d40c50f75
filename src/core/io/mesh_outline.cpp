#include "core/io/mesh_outline.hpp"

#include "core/base/check.hpp"
#include "core/mesh/surface_topology.hpp"

#include <algorithm>
#include <optional>

namespace gaspard {

namespace {

std::size_t index(std::int32_t node) { return static_cast<std::size_t>(node); }

using Key = std::pair<std::int32_t, std::int32_t>;
Key key_of(const Side& side) { return std::minmax(side.from, side.to); }

/// For every node the edges that end there: row n is starts[n] .. starts[n + 1] of `edges`.
struct EdgesAtNodes {
    std::vector<std::uint32_t> starts, edges;

    EdgesAtNodes(const std::vector<Side>& sides, std::size_t nodes) : starts(nodes + 1, 0) {
        for (const Side& side : sides) ++starts[index(side.from) + 1], ++starts[index(side.to) + 1];
        for (std::size_t n = 0; n < nodes; ++n) starts[n + 1] += starts[n];
        edges.resize(2 * sides.size());
        auto next = starts;
        for (std::size_t e = 0; e < sides.size(); ++e)
            for (const std::int32_t node : {sides[e].from, sides[e].to})
                edges[next[index(node)]++] = static_cast<std::uint32_t>(e);
    }
    std::span<const std::uint32_t> at(std::int32_t node) const {
        return std::span(edges).subspan(starts[index(node)], starts[index(node) + 1] - starts[index(node)]);
    }
};

Side side_of_face(const Facets& faces, std::size_t face, std::size_t i) {
    const auto nodes = faces[face];
    const auto corners = static_cast<std::size_t>(faces.corners);
    Side side{nodes[i], nodes[(i + 1) % corners], faces.kind.order - 1};
    const auto& edge = cell_edges(faces.kind)[i]; // the ends, then the nodes between
    for (std::size_t k = 2; k < edge.size(); ++k) side.through[k - 2] = nodes[index(edge[k])];
    return side;
}

class Chainer {
  public:
    Chainer(const std::vector<Side>& edges, const Points& positions)
        : edges_(edges), positions_(positions), at_(edges, positions.size()), used_(edges.size(), false) {}

    std::vector<Side> from(std::size_t first) {
        used_[first] = true;
        std::vector<Side> back = follow(edges_[first].reversed()), line;
        for (auto side = back.rbegin(); side != back.rend(); ++side) line.push_back(side->reversed());
        line.push_back(edges_[first]);
        const auto forth = follow(edges_[first]);
        line.insert(line.end(), forth.begin(), forth.end());
        return line;
    }
    bool used(std::size_t edge) const { return used_[edge]; }

  private:
    Vec3 direction(const Side& side) const {
        const Vec3 d = positions_[index(side.to)] - positions_[index(side.from)];
        const double length = norm(d);
        return length > 0 ? 1 / length * d : d;
    }

    std::vector<Side> follow(Side last) {
        constexpr double straight_enough = 0.5; // cosine; beyond, another line is the better continuation
        std::vector<Side> line;
        while (true) {
            double best = straight_enough;
            std::optional<std::uint32_t> next;
            for (const auto e : at_.at(last.to)) {
                if (used_[e]) continue;
                const double cosine = dot(direction(last), direction(leaving(e, last.to)));
                if (cosine > best) best = cosine, next = e;
            }
            if (!next) return line;
            used_[*next] = true;
            last = leaving(*next, last.to);
            line.push_back(last);
        }
    }

    Side leaving(std::uint32_t edge, std::int32_t node) const {
        return edges_[edge].from == node ? edges_[edge] : edges_[edge].reversed();
    }

    const std::vector<Side>& edges_;
    const Points& positions_;
    EdgesAtNodes at_;
    std::vector<bool> used_;
};

} // namespace

std::vector<Side> sides_of_face(const Facets& faces, std::size_t face) {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < static_cast<std::size_t>(faces.corners); ++i)
        sides.push_back(side_of_face(faces, face, i));
    return sides;
}

std::vector<DrawnEdge> edges_of(const Facets& faces) {
    const auto corners = static_cast<std::size_t>(faces.corners);
    std::vector<std::int32_t> cycle; // the corners of all faces
    cycle.reserve(faces.size() * corners);
    std::int32_t last_node = -1;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const std::int32_t node : faces[f].first(corners)) {
            cycle.push_back(node);
            last_node = std::max(last_node, node);
        }
    const SurfaceEdges found = surface_edges(index(last_node) + 1, cycle, corners);
    std::vector<DrawnEdge> edges;
    edges.reserve(found.edges.size());
    for (const SurfaceEdge& edge : found.edges) {
        const auto sides = found.sides_of(edge);
        const auto face = static_cast<std::size_t>(sides.front()) / corners;
        edges.push_back(
            {side_of_face(faces, face, sides.front() % corners),
             {static_cast<std::uint32_t>(face), static_cast<std::uint32_t>(sides.back() / corners)}});
    }
    return edges;
}

std::vector<std::vector<Side>> chain(const std::vector<Side>& edges, const Points& positions) {
    Chainer chainer(edges, positions);
    std::vector<std::vector<Side>> lines;
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (!chainer.used(e)) lines.push_back(chainer.from(e));
    return lines;
}

std::vector<std::vector<Side>> outline(const Facets& faces, std::span<const std::uint32_t> chosen) {
    std::vector<Side> sides;
    for (const auto face : chosen)
        for (const Side& side : sides_of_face(faces, face)) sides.push_back(side);
    // Where two of the faces meet, their sides run in opposite directions and cancel. No half-edge structure
    // is built for each set of faces: it would cost more than these sides.
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return key_of(a) < key_of(b); });
    std::size_t kept = 0;
    for (const Side& side : sides) {
        if (kept > 0 && sides[kept - 1].from == side.to && sides[kept - 1].to == side.from)
            --kept;
        else
            sides[kept++] = side;
    }
    sides.resize(kept);

    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); });
    std::vector<bool> used(sides.size(), false);
    // As many sides leave a node as come to it, so that every walk ends where it began.
    const auto next_from = [&](std::int32_t node) {
        auto at = std::lower_bound(sides.begin(), sides.end(), node,
                                   [](const Side& side, std::int32_t n) { return side.from < n; });
        while (at != sides.end() && at->from == node && used[static_cast<std::size_t>(at - sides.begin())])
            ++at;
        GASPARD_CHECK(at != sides.end() && at->from == node);
        return static_cast<std::size_t>(at - sides.begin());
    };
    std::vector<std::vector<Side>> loops;
    for (std::size_t first = 0; first < sides.size(); ++first) {
        if (used[first]) continue;
        loops.emplace_back();
        for (std::size_t s = first;; s = next_from(sides[s].to)) {
            used[s] = true;
            loops.back().push_back(sides[s]);
            if (sides[s].to == sides[first].from) break;
        }
    }
    return loops;
}

} // namespace gaspard
