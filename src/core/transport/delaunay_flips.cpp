#include "core/transport/delaunay_flips.hpp"

#include "core/base/check.hpp"
#include "core/mesh/surface_topology.hpp"

#include <numeric>

namespace gaspard {

namespace {

/// Side k of the concatenated triangles runs from its corner to the next one of its triangle.
class TriangleSides {
  public:
    using Side = std::uint32_t;

    explicit TriangleSides(Mesh& mesh) : mesh_(mesh), twins_(mesh.cells.size(), none) {
        const auto edges = surface_edges(mesh.node_count(), mesh.cells, 3);
        for (const SurfaceEdge& edge : edges.edges)
            if (const auto sides = edges.sides_of(edge); sides.size() == 2) link(sides[0], sides[1]);
    }

    /// Each side is looked at again when a triangle beside it has changed.
    void flip_all() {
        std::vector<Side> waiting(twins_.size());
        std::iota(waiting.rbegin(), waiting.rend(), Side{0});
        while (!waiting.empty()) {
            const Side side = waiting.back();
            waiting.pop_back();
            if (twins_[side] == none || !angles_above_pi(side)) continue;
            const Side twin = twins_[side];
            flip(side);
            for (const Side outer : {side, twin, after(side), after(twin)}) waiting.push_back(outer);
        }
    }

  private:
    static constexpr Side none = ~Side{0};

    static Side after(Side s) { return s % 3 == 2 ? s - 2 : s + 1; }
    static Side before(Side s) { return s % 3 == 0 ? s + 2 : s - 1; }
    Vec3 start(Side s) const { return mesh_.nodes[static_cast<std::size_t>(mesh_.cells[s])]; }
    void link(Side a, Side b) {
        if (a != none) twins_[a] = b;
        if (b != none) twins_[b] = a;
    }

    bool angles_above_pi(Side side) const {
        const Vec3 p = start(side), q = start(after(side));
        const Vec3 r = start(before(side)), s = start(before(twins_[side]));
        const double cos_r = dot(p - r, q - r), sin_r = cross(p - r, q - r).z;
        const double cos_s = dot(q - s, p - s), sin_s = cross(q - s, p - s).z;
        const double scale = norm(p - r) * norm(q - r) * norm(p - s) * norm(q - s);
        return sin_r * cos_s + cos_r * sin_s < -1e-10 * scale; // the sine of their sum
    }

    /// p q r and q p s become s q r and r p s.
    void flip(Side a) {
        const Side b = twins_[a], r = before(a), s = before(b), beyond_r = twins_[r], beyond_s = twins_[s];
        mesh_.cells[a] = mesh_.cells[s];
        mesh_.cells[b] = mesh_.cells[r];
        link(a, beyond_s);
        link(b, beyond_r);
        link(r, s);
    }

    Mesh& mesh_;
    std::vector<Side> twins_; ///< the same edge in the other triangle
};

} // namespace

void flip_to_delaunay(Mesh& mesh) {
    GASPARD_CHECK(mesh.kind == (CellKind{CellShape::triangle, 1}) && mesh.space_dimension == 2);
    TriangleSides(mesh).flip_all();
}

} // namespace gaspard
