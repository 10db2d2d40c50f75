#include "core/spline/tensor_domain.hpp"

#include "core/base/check.hpp"
#include "core/spline/patch_inverse.hpp"
#include "core/spline/solid_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

/// The nodes as a lattice of `side` per direction, the first fastest.
template <std::size_t D>
struct Lattice {
    std::size_t side;

    std::size_t size() const { return tensor_size<D>(side); }
    std::size_t step(std::size_t direction) const {
        return direction == 0 ? 1 : direction == 1 ? side : side * side;
    }
    std::size_t index(std::size_t node, std::size_t direction) const { return node / step(direction) % side; }
    /// Calls visit(first node) for all lines along a direction that lie on the side where index `across` is
    /// `at`.
    template <class Visit>
    void lines_on_side(std::size_t along, std::size_t across, std::size_t at, const Visit& visit) const {
        for (std::size_t node = 0; node < size(); ++node)
            if (index(node, along) == 0 && index(node, across) == at) visit(node);
    }
};

/// Where a side is collapsed, rounding leaves nodes that differ. They become equal, so that their cells have
/// no area there, exactly.
template <std::size_t D>
void join_collapsed_nodes(const Lattice<D>& lattice, Points& nodes) {
    double largest = 0;
    for (const auto* coordinate : {&nodes.x, &nodes.y, &nodes.z})
        for (const double c : *coordinate) largest = std::max(largest, std::abs(c));
    const double rounding = 64 * std::numeric_limits<double>::epsilon() * largest;
    for (std::size_t along = 0; along < D; ++along)
        for (std::size_t across = 0; across < D; ++across)
            for (const std::size_t at : {std::size_t{0}, lattice.side - 1}) {
                if (across == along) continue;
                lattice.lines_on_side(along, across, at, [&](std::size_t first) {
                    for (std::size_t k = 1; k < lattice.side; ++k) {
                        const std::size_t here = first + k * lattice.step(along),
                                          before = here - lattice.step(along);
                        if (norm(nodes[here] - nodes[before]) <= rounding) nodes.set(here, nodes[before]);
                    }
                });
            }
}

template <std::size_t D>
CollapsedSides<D> find_collapsed(const Lattice<D>& lattice, const Points& nodes) {
    const auto collapsed = [&](std::size_t across, std::size_t at) {
        for (std::size_t along = 0; along < D; ++along) {
            if (along == across) continue;
            bool all = true;
            lattice.lines_on_side(along, across, at, [&](std::size_t first) {
                for (std::size_t k = 1; all && k < lattice.side; ++k)
                    all = nodes[first + k * lattice.step(along)] == nodes[first];
            });
            if (all) return true;
        }
        return false;
    };
    CollapsedSides<D> found;
    for (std::size_t d = 0; d < D; ++d)
        found.low[d] = collapsed(d, 0), found.high[d] = collapsed(d, lattice.side - 1);
    return found;
}

/// Whether F reverses the orientation of a patch in the plane or of a solid; of a surface in space,
/// orientation is free.
bool mirrored(const Lattice<2>& lattice, const Points& nodes, const PatchMap& map) {
    if (map.space_dimension() == 3) return false;
    double area = 0;
    for (std::size_t j = 0; j + 1 < lattice.side; ++j)
        for (std::size_t i = 0; i + 1 < lattice.side; ++i) {
            const std::size_t k = j * lattice.side + i;
            area += cross(nodes[k + lattice.side + 1] - nodes[k], nodes[k + lattice.side] - nodes[k + 1]).z;
        }
    return area < 0;
}
bool mirrored(const Lattice<3>&, const Points&, const SolidMap& map) {
    const Points xi = cube_middles(8);
    std::array<Points, 3> tangents;
    map.tangents(xi, tangents);
    double volume = 0;
    for (std::size_t i = 0; i < xi.size(); ++i)
        volume += dot(cross(tangents[0][i], tangents[1][i]), tangents[2][i]);
    return volume < 0;
}

/// Numbers of a cell's nodes, relative to its first. The cells of a mirrored patch or solid list their nodes
/// with the first two directions exchanged, so that they are anticlockwise in the plane, or have positive
/// volume. Parameters, and with them the map, are those of the patch.
template <std::size_t D>
std::vector<std::size_t> local_nodes(CellKind kind, const Lattice<D>& lattice, bool exchanged) {
    const auto number = [&](double of) { return static_cast<std::size_t>(std::lround(kind.order * of)); };
    std::vector<std::size_t> local;
    for (const Vec3 node : reference_nodes(kind)) {
        const std::size_t i = number(exchanged ? node.y : node.x), j = number(exchanged ? node.x : node.y);
        local.push_back(i + j * lattice.step(1) + (D == 3 ? number(node.z) * lattice.step(2) : 0));
    }
    return local;
}

template <std::size_t D>
Mesh tensor_mesh(std::size_t cells, int order, const std::vector<double>& line, const TensorMap<D>& map) {
    const Lattice<D> lattice{line.size()};
    const CellKind kind{D == 2 ? CellShape::quadrilateral : CellShape::hexahedron, order};
    Points xi(lattice.size());
    for (std::size_t i = 0; i < xi.size(); ++i)
        xi.set(i, {line[lattice.index(i, 0)], line[lattice.index(i, 1)],
                   D == 3 ? line[lattice.index(i, 2)] : 0});
    Mesh mesh{.kind = kind, .space_dimension = map.space_dimension(), .nodes = {}, .cells = {}};
    map.points(xi, mesh.nodes);
    join_collapsed_nodes(lattice, mesh.nodes);
    const auto local = local_nodes(kind, lattice, mirrored(lattice, mesh.nodes, map));
    const Lattice<D> of_cells{cells};
    mesh.cells.reserve(local.size() * of_cells.size());
    for (std::size_t c = 0; c < of_cells.size(); ++c) {
        std::size_t first = 0;
        for (std::size_t d = 0; d < D; ++d)
            first += static_cast<std::size_t>(order) * of_cells.index(c, d) * lattice.step(d);
        for (const std::size_t node : local) mesh.cells.push_back(static_cast<std::int32_t>(first + node));
    }
    if (D == 3) mesh.lattice.fill(static_cast<std::int32_t>(cells));
    return mesh;
}

} // namespace

template <std::size_t D>
TensorDomain<D>::TensorDomain(int degree, std::size_t cells, std::shared_ptr<const TensorMap<D>> map,
                              std::shared_ptr<const Points> control, std::shared_ptr<const PatchList> patches,
                              std::size_t control_columns)
    : degree_(degree), cells_(cells), map_(std::move(map)), control_(std::move(control)),
      control_columns_(control_columns), patches_(std::move(patches)) {
    GASPARD_CHECK(map_ != nullptr && cells_ >= 1 && degree_ >= 2 && degree_ <= highest_degree);
    if constexpr (D == 2) parameters_ = patch_parameters(map_);
    if constexpr (D == 3) shape_ = gaspard::solid_shape(map_);
    const std::vector<double> line = node_lines();
    mesh_ = std::make_shared<const Mesh>(tensor_mesh<D>(cells_, mesh_order(), line, *map_));
    collapsed_ = find_collapsed(Lattice<D>{line.size()}, mesh_->nodes);
}

template <std::size_t D>
std::shared_ptr<const PatchMap> TensorDomain<D>::patch_map() const {
    if constexpr (D == 2) return map_;
    return nullptr;
}

template <std::size_t D>
std::shared_ptr<const SolidMap> TensorDomain<D>::solid_map() const {
    if constexpr (D == 3) return map_;
    return nullptr;
}

template <std::size_t D>
std::size_t TensorDomain<D>::unknowns() const {
    return tensor_size<D>(cells_ + static_cast<std::size_t>(degree_));
}

template <std::size_t D>
int TensorDomain<D>::mesh_order() const {
    if constexpr (D == 2) return degree_;
    constexpr std::size_t most_pieces = 128; // per direction: 2.1 million nodes
    return std::clamp(static_cast<int>(most_pieces / cells_), 1, degree_);
}

template <std::size_t D>
std::vector<double> TensorDomain<D>::node_lines() const {
    const std::size_t pieces = static_cast<std::size_t>(mesh_order()) * cells_;
    std::vector<double> line(pieces + 1);
    for (std::size_t i = 0; i < line.size(); ++i)
        line[i] = static_cast<double>(i) / static_cast<double>(pieces);
    return line;
}

template class TensorDomain<2>;
template class TensorDomain<3>;

} // namespace gaspard
