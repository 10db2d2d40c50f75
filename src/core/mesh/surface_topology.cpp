#include "core/mesh/surface_topology.hpp"

#include "core/base/check.hpp"
#include "core/mesh/half_edges.hpp"

#include <algorithm>
#include <numeric>

namespace gaspard {

namespace {

std::size_t as_index(std::int32_t i) { return static_cast<std::size_t>(i); }

std::vector<std::uint32_t> next_corners(const PolygonFaces& faces) {
    std::vector<std::uint32_t> next(faces.corners.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::uint32_t k = faces.starts[f]; k < faces.starts[f + 1]; ++k)
            next[k] = k + 1 < faces.starts[f + 1] ? k + 1 : faces.starts[f];
    return next;
}

std::string number_word(std::size_t n) {
    constexpr std::array words = {"three", "four", "five", "six"};
    return n >= 3 && n < 3 + words.size() ? words[n - 3] : std::to_string(n);
}

} // namespace

std::optional<std::string> fault_of(std::size_t vertex_count, const PolygonFaces& faces, std::int32_t base) {
    std::vector<std::int32_t> sorted;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto face = [&] { return "face " + std::to_string(f + as_index(base)); };
        sorted.assign(faces[f].begin(), faces[f].end());
        std::sort(sorted.begin(), sorted.end());
        if (sorted.size() < 3) return face() + " has fewer than three corners";
        for (const auto v : {sorted.front(), sorted.back()})
            if (v < 0 || as_index(v) >= vertex_count)
                return face() + " names vertex " + std::to_string(std::int64_t{v} + base) +
                       ", but there are " + std::to_string(vertex_count) + " vertices";
        const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
        if (twice != sorted.end()) return face() + " has vertex " + std::to_string(*twice + base) + " twice";
    }
    return std::nullopt;
}

PolygonFaces polygon_faces(const Mesh& mesh) {
    GASPARD_CHECK(cell_dimension(mesh.kind) == 2);
    PolygonFaces faces;
    const auto corners = static_cast<std::size_t>(corners_per_cell(mesh.kind));
    faces.corners.reserve(mesh.cell_count() * corners);
    faces.starts.reserve(mesh.cell_count() + 1);
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) faces.add(mesh.cell(c).first(corners));
    return faces;
}

SurfaceEdges surface_edges(std::size_t vertex_count, std::span<const std::int32_t> corners,
                           std::span<const std::uint32_t> next) {
    // Sides grouped by their smaller vertex in the order of sides, then each group by the larger one.
    const auto low = [&](std::uint32_t side) { return std::min(corners[side], corners[next[side]]); };
    const auto high = [&](std::uint32_t side) { return std::max(corners[side], corners[next[side]]); };
    const auto count = static_cast<std::uint32_t>(corners.size());
    std::vector<std::uint32_t> ends(vertex_count + 1, 0);
    for (std::uint32_t s = 0; s < count; ++s) ++ends[as_index(low(s)) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    SurfaceEdges result;
    result.sides.resize(count);
    result.edges.reserve(count / 2 + 1);
    for (std::uint32_t s = 0; s < count; ++s) result.sides[ends[as_index(low(s))]++] = s;
    for (std::size_t v = 0, begin = 0; v < vertex_count; begin = ends[v++]) {
        const auto group = std::span(result.sides).subspan(begin, ends[v] - begin);
        std::sort(group.begin(), group.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(high(a), a) < std::pair(high(b), b);
        });
        for (std::size_t i = 0; i < group.size(); ++i) {
            if (i == 0 || high(group[i]) != high(group[i - 1]))
                result.edges.push_back({{static_cast<std::int32_t>(v), high(group[i])},
                                        static_cast<std::uint32_t>(begin + i),
                                        0});
            ++result.edges.back().count;
        }
    }
    return result;
}

SurfaceEdges surface_edges(std::size_t vertex_count, std::span<const std::int32_t> corners,
                           std::size_t corners_each) {
    std::vector<std::uint32_t> next(corners.size());
    for (std::size_t k = 0; k < next.size(); ++k)
        next[k] = static_cast<std::uint32_t>((k + 1) % corners_each == 0 ? k + 1 - corners_each : k + 1);
    return surface_edges(vertex_count, corners, next);
}

/// Everything is found once and kept.
struct SurfaceTopology::Data {
    std::size_t vertex_count;
    PolygonFaces faces;
    std::vector<std::uint32_t> next;
    std::vector<std::int32_t> face_of; ///< per side
    SurfaceEdges edges;
    std::vector<std::int32_t> components;
    std::size_t component_count = 0;
    FaceOrientations orientations;
    std::unique_ptr<const HalfEdges> half_edges;

    Data(std::size_t vertices, PolygonFaces polygons)
        : vertex_count(vertices), faces(std::move(polygons)), next(next_corners(faces)) {
        if (const auto fault = fault_of(vertex_count, faces)) throw InputError(*fault);
        for (std::size_t f = 0; f < faces.size(); ++f)
            face_of.insert(face_of.end(), faces[f].size(), static_cast<std::int32_t>(f));
        edges = surface_edges(vertex_count, faces.corners, next);
        find_components();
        orientations = orient_faces(faces, face_of, edges);
        half_edges = std::make_unique<HalfEdges>(vertex_count, faces, next, face_of, edges, orientations);
    }

    bool inconsistent(const SurfaceEdge& edge) const {
        const auto sides = edges.sides_of(edge);
        return sides.size() == 2 && faces.corners[sides[0]] == faces.corners[sides[1]];
    }

  private:
    void find_components() {
        std::vector<std::int32_t> parent(faces.size());
        std::iota(parent.begin(), parent.end(), 0);
        const auto root = [&](std::int32_t f) {
            while (parent[as_index(f)] != f) f = parent[as_index(f)] = parent[as_index(parent[as_index(f)])];
            return f;
        };
        for (const SurfaceEdge& edge : edges.edges)
            for (const auto side : edges.sides_of(edge).subspan(1)) {
                const auto a = root(face_of[edges.sides[edge.first]]), b = root(face_of[side]);
                parent[as_index(std::max(a, b))] = std::min(a, b); // a root is its component's first face
            }
        components.resize(faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            const auto first = as_index(root(static_cast<std::int32_t>(f)));
            components[f] = first == f ? static_cast<std::int32_t>(component_count++) : components[first];
        }
    }
};

SurfaceTopology::SurfaceTopology(std::size_t vertex_count, PolygonFaces faces)
    : data_(std::make_unique<const Data>(vertex_count, std::move(faces))) {}
SurfaceTopology::SurfaceTopology(const Mesh& mesh)
    : SurfaceTopology(mesh.node_count(), polygon_faces(mesh)) {}
SurfaceTopology::~SurfaceTopology() = default;
SurfaceTopology::SurfaceTopology(SurfaceTopology&&) noexcept = default;
SurfaceTopology& SurfaceTopology::operator=(SurfaceTopology&&) noexcept = default;

std::size_t SurfaceTopology::vertex_count() const { return data_->vertex_count; }
const PolygonFaces& SurfaceTopology::faces() const { return data_->faces; }
const SurfaceEdges& SurfaceTopology::edges() const { return data_->edges; }
std::int32_t SurfaceTopology::face_of_side(std::uint32_t side) const { return data_->face_of[side]; }
std::span<const std::int32_t> SurfaceTopology::components() const { return data_->components; }
std::size_t SurfaceTopology::component_count() const { return data_->component_count; }

std::vector<VertexFan> SurfaceTopology::one_rings(std::int32_t vertex) const {
    GASPARD_CHECK(vertex >= 0 && as_index(vertex) < data_->vertex_count);
    return data_->half_edges->one_rings(vertex);
}

std::vector<std::vector<std::int32_t>> SurfaceTopology::boundary_loops() const {
    return data_->half_edges->boundary_loops();
}

std::vector<std::uint32_t> SurfaceTopology::inconsistent_edges() const {
    std::vector<std::uint32_t> found;
    for (std::size_t e = 0; e < data_->edges.edges.size(); ++e)
        if (data_->inconsistent(data_->edges.edges[e])) found.push_back(static_cast<std::uint32_t>(e));
    return found;
}

bool SurfaceTopology::orientable() const {
    const auto& two_sided = data_->orientations.orientable;
    return std::find(two_sided.begin(), two_sided.end(), false) == two_sided.end();
}

std::vector<std::int32_t> SurfaceTopology::reversed_faces() const {
    std::vector<std::int32_t> found;
    for (std::size_t f = 0; f < data_->faces.size(); ++f)
        if (data_->orientations.orientable[f] && data_->orientations.reversed[f])
            found.push_back(static_cast<std::int32_t>(f));
    return found;
}

std::vector<std::uint32_t> SurfaceTopology::complex_edges() const {
    std::vector<std::uint32_t> found;
    for (std::size_t e = 0; e < data_->edges.edges.size(); ++e)
        if (data_->edges.edges[e].count > 2) found.push_back(static_cast<std::uint32_t>(e));
    return found;
}

std::vector<std::int32_t> SurfaceTopology::pinched_vertices() const {
    std::vector<bool> at_complex_edge(data_->vertex_count, false); // its fans are parted by the cut
    for (const auto e : complex_edges())
        for (const auto v : data_->edges.edges[e].vertices) at_complex_edge[as_index(v)] = true;
    std::vector<std::int32_t> found;
    for (std::size_t v = 0; v < data_->vertex_count; ++v)
        if (!at_complex_edge[v] && data_->half_edges->fan_count(static_cast<std::int32_t>(v)) > 1)
            found.push_back(static_cast<std::int32_t>(v));
    return found;
}

bool SurfaceTopology::manifold() const { return complex_edges().empty() && pinched_vertices().empty(); }

std::int64_t SurfaceTopology::euler_characteristic() const {
    std::int64_t used = 0;
    for (std::size_t v = 0; v < data_->vertex_count; ++v)
        used += data_->half_edges->fan_count(static_cast<std::int32_t>(v)) > 0;
    return used - static_cast<std::int64_t>(data_->edges.edges.size()) +
           static_cast<std::int64_t>(data_->faces.size());
}

std::vector<std::string> SurfaceTopology::facts(std::size_t most, std::int32_t base, bool orientation) const {
    std::vector<std::string> found;
    const auto ends = [&](std::uint32_t e) {
        const auto& v = data_->edges.edges[e].vertices;
        return std::to_string(v[0] + base) + '-' + std::to_string(v[1] + base);
    };
    const auto complex = complex_edges();
    for (std::size_t i = 0; i < std::min(most, complex.size()); ++i)
        found.push_back("edge " + ends(complex[i]) + " has " +
                        number_word(data_->edges.edges[complex[i]].count) + " faces");
    const auto pinched = pinched_vertices();
    for (std::size_t i = 0; i < std::min(most, pinched.size()); ++i)
        found.push_back("vertex " + std::to_string(pinched[i] + base) + " joins " +
                        std::to_string(data_->half_edges->fan_count(pinched[i])) + " fans of faces");
    if (!orientation) return found;
    if (!orientable()) {
        found.push_back("not orientable");
        return found;
    }
    const auto inconsistent = inconsistent_edges();
    for (std::size_t i = 0; i < std::min(most, inconsistent.size()); ++i)
        found.push_back("the faces at edge " + ends(inconsistent[i]) + " have opposite orientations");
    return found;
}

} // namespace gaspard
