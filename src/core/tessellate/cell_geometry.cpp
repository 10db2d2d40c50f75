#include "core/tessellate/cell_geometry.hpp"

#include "core/base/check.hpp"
#include "core/fem/cell_quadrature.hpp"
#include "core/fem/gauss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

/// Per direction; exact for cells in the plane and for solid cells, whose determinants have degree 3 k - 1.
int quadrature_points(CellKind kind) {
    return std::max(3, kind.shape == CellShape::hexahedron ? (3 * kind.order + 1) / 2 : kind.order);
}

/// Areas of the parallelograms spanned at each corner of a straight-edged planar cell by its two edges.
/// Inlined, so that the result stays in registers.
template <std::size_t corners>
[[gnu::always_inline]] inline std::array<double, corners> corner_areas(const std::int32_t* cell,
                                                                       const double* x, const double* y) {
    std::array<double, corners> to_x, to_y, areas; // to_*: vector from the previous corner
    for (std::size_t k = 0; k < corners; ++k) {
        to_x[k] = x[cell[k]] - x[cell[(k + corners - 1) % corners]];
        to_y[k] = y[cell[k]] - y[cell[(k + corners - 1) % corners]];
    }
    for (std::size_t k = 0; k < corners; ++k)
        areas[k] = to_x[k] * to_y[(k + 1) % corners] - to_y[k] * to_x[(k + 1) % corners];
    return areas;
}

double smaller(double a, double b) { return std::isnan(b) || b < a ? b : a; }

template <std::size_t corners>
void straight_jacobians(const Mesh& mesh, const Points& x, std::vector<double>& found) {
    const double *to_x = x.x.data(), *to_y = x.y.data();
    const double *from_x = mesh.nodes.x.data(), *from_y = mesh.nodes.y.data();
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::int32_t* cell = mesh.cells.data() + corners * i;
        const auto areas = corner_areas<corners>(cell, to_x, to_y);
        const auto of = corner_areas<corners>(cell, from_x, from_y);
        double smallest = areas[0] / of[0], sum = smallest; // branch-free, because the order is unpredictable
        for (std::size_t k = 1; k < corners; ++k) {
            const double jacobian = areas[k] / of[k];
            smallest = jacobian < smallest ? jacobian : smallest;
            sum += jacobian;
        }
        found[i] = std::isnan(sum) ? sum : smallest;
    }
}

template <std::size_t corners>
std::vector<std::uint32_t> not_all_turning_left(const Mesh& mesh, const Points& nodes) {
    std::vector<std::uint32_t> found;
    const double *x = nodes.x.data(), *y = nodes.y.data();
    for (std::size_t i = 0; i < mesh.cell_count(); ++i) {
        bool all = true;
        for (const double area : corner_areas<corners>(mesh.cells.data() + corners * i, x, y))
            all &= area > 0;
        if (!all) found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
}

} // namespace

double radius_of_ball(const Mesh& mesh) {
    if (mesh.space_dimension != 3 || cell_dimension(mesh.kind) != 2 || mesh.node_count() == 0) return 0;
    const double radius = norm(mesh.nodes[0]);
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
        if (!(std::abs(norm(mesh.nodes[i]) - radius) <= 1e-9 * radius)) return 0;
    return radius;
}

CellGeometry::CellGeometry(std::shared_ptr<const Mesh> mesh)
    : mesh_(std::move(mesh)), dimension_(cell_dimension(mesh_->kind)), on_ball_(radius_of_ball(*mesh_) > 0) {
    const auto n = static_cast<std::size_t>(nodes_per_cell(mesh_->kind));
    const auto sample = [&](Vec3 point, double weight) {
        Sample made{std::vector<double>(n), std::vector<Vec3>(n), weight};
        shape_functions(mesh_->kind, point, made.values, made.gradients);
        return made;
    };
    for (const Vec3 node : reference_nodes(mesh_->kind)) nodes_.push_back(sample(node, 0));
    for (const auto& [point, weight] : cell_quadrature(mesh_->kind.shape, quadrature_points(mesh_->kind)))
        quadrature_.push_back(sample(point, weight));
    if (mesh_->kind.shape == CellShape::hexahedron) {
        std::vector<double> line; // the order of the nodes is of no importance
        for (int k = 0; k <= mesh_->kind.order; ++k)
            line.push_back(static_cast<double>(k) / mesh_->kind.order);
        node_cell_.emplace(mesh_->kind, line);
        quadrature_cell_.emplace(mesh_->kind, gauss_legendre(quadrature_points(mesh_->kind)).points);
    }
    turns_left_ = straight_in_the_plane() && tangled_in_the_plane(mesh_->nodes).empty();
}

void CellGeometry::find_tangents(std::size_t cell, const Points& x, bool at_nodes, std::vector<Tangents>& out,
                                 Work& work) const {
    const auto& samples = at_nodes ? nodes_ : quadrature_;
    const auto numbers = mesh_->cell(cell);
    out.resize(samples.size());
    if (!node_cell_) {
        for (std::size_t s = 0; s < samples.size(); ++s) out[s] = tangents(numbers, x, samples[s]);
        return;
    }
    work.nodes.resize(numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) work.nodes[k] = x[static_cast<std::size_t>(numbers[k])];
    work.places.resize(samples.size());
    (at_nodes ? node_cell_ : quadrature_cell_)->evaluate(work.nodes, work.places, work.tensor);
    for (std::size_t s = 0; s < samples.size(); ++s) out[s] = work.places[s].tangents;
}

Tangents CellGeometry::tangents(std::span<const std::int32_t> cell, const Points& x,
                                const Sample& sample) const {
    const auto node = [&](std::size_t k) { return x[static_cast<std::size_t>(cell[k])]; };
    Tangents t = cell_tangents(dimension_, sample.gradients, node);
    for (std::size_t k = 0; on_ball_ && k < cell.size(); ++k) t[2] = t[2] + sample.values[k] * node(k);
    return t;
}

double CellGeometry::signed_measure(const Tangents& of, const Tangents& reference) const {
    if (!on_ball_) return gaspard::signed_measure(dimension_, mesh_->space_dimension, of, reference);
    const Vec3 normal = cross(of[0], of[1]);
    return std::copysign(norm(normal),
                         dot(normal, of[2]) * dot(cross(reference[0], reference[1]), reference[2]));
}

bool CellGeometry::straight_in_the_plane() const {
    return dimension_ == 2 && mesh_->space_dimension == 2 && mesh_->kind.order == 1;
}

std::vector<double> CellGeometry::measures(const Points& x) const {
    GASPARD_CHECK(x.size() == mesh_->node_count());
    std::vector<double> found(mesh_->cell_count());
    if (straight_in_the_plane()) { // half the cross product of the diagonals, or of two sides
        const auto corners = static_cast<std::size_t>(corners_per_cell(mesh_->kind));
        for (std::size_t i = 0; i < found.size(); ++i) {
            const std::int32_t* c = mesh_->cells.data() + i * corners;
            const auto a = static_cast<std::size_t>(c[0]), b = static_cast<std::size_t>(c[corners - 2]);
            const auto d = static_cast<std::size_t>(c[corners - 1]),
                       e = static_cast<std::size_t>(c[corners == 4 ? 1 : 0]);
            found[i] = 0.5 * ((x.x[b] - x.x[a]) * (x.y[d] - x.y[e]) - (x.y[b] - x.y[a]) * (x.x[d] - x.x[e]));
        }
        return found;
    }
    std::vector<Tangents> here, reference;
    Work work;
    for (std::size_t i = 0; i < found.size(); ++i) {
        find_tangents(i, x, false, here, work);
        find_tangents(i, mesh_->nodes, false, reference, work);
        for (std::size_t s = 0; s < quadrature_.size(); ++s)
            found[i] += quadrature_[s].weight * signed_measure(here[s], reference[s]);
    }
    return found;
}

std::vector<std::uint32_t> CellGeometry::tangled_in_the_plane(const Points& x) const {
    return mesh_->kind.shape == CellShape::triangle ? not_all_turning_left<3>(*mesh_, x)
                                                    : not_all_turning_left<4>(*mesh_, x);
}

std::vector<std::uint32_t> CellGeometry::tangled(const Points& x) const {
    GASPARD_CHECK(x.size() == mesh_->node_count());
    return turns_left_ ? tangled_in_the_plane(x) : tangled_cells(jacobians(x));
}

std::vector<std::uint32_t> tangled_cells(std::span<const double> jacobians) {
    std::vector<std::uint32_t> cells;
    for (std::size_t i = 0; i < jacobians.size(); ++i)
        if (!(jacobians[i] > 0)) cells.push_back(static_cast<std::uint32_t>(i));
    return cells;
}

std::vector<double> CellGeometry::jacobians(const Points& x) const {
    GASPARD_CHECK(x.size() == mesh_->node_count());
    std::vector<double> found(mesh_->cell_count());
    if (straight_in_the_plane()) {
        if (mesh_->kind.shape == CellShape::triangle)
            straight_jacobians<3>(*mesh_, x, found);
        else
            straight_jacobians<4>(*mesh_, x, found);
        return found;
    }
    std::vector<Tangents> here, reference;
    std::vector<double> before(nodes_.size());
    Work work;
    for (std::size_t i = 0; i < found.size(); ++i) {
        double smallest = std::numeric_limits<double>::infinity(), whole = 0;
        find_tangents(i, x, true, here, work);
        find_tangents(i, mesh_->nodes, true, reference, work);
        for (std::size_t s = 0; s < nodes_.size(); ++s) {
            before[s] = signed_measure(reference[s], reference[s]);
            whole = std::max(whole, std::abs(before[s]));
        }
        for (std::size_t s = 0; s < nodes_.size(); ++s)
            if (std::abs(before[s]) > degenerate_measure * whole)
                smallest = smaller(smallest, signed_measure(here[s], reference[s]) / before[s]);
        found[i] = smallest;
    }
    return found;
}

} // namespace gaspard
