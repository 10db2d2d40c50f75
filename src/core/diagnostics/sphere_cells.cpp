#include "core/diagnostics/sphere_cells.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr std::size_t sphere_batch = SphereCellMeter::batch;
constexpr std::size_t most_nodes = 9; // per cell
using Lane = SphereCellMeter::Lane;

struct Node { ///< xi and x of one node in every cell
    Lane xi[3], x[3];
};

void gather(const Mesh& mesh, std::size_t begin, std::size_t end, const Points& x, std::size_t count,
            std::array<Node, most_nodes>& nodes) {
    for (std::size_t l = 0; l < sphere_batch; ++l) {
        const auto cell = mesh.cell(std::min(begin + l, end - 1)); // pad with the last cell
        for (std::size_t n = 0; n < count; ++n) {
            const auto number = static_cast<std::size_t>(cell[n]);
            nodes[n].xi[0][l] = mesh.nodes.x[number], nodes[n].x[0][l] = x.x[number];
            nodes[n].xi[1][l] = mesh.nodes.y[number], nodes[n].x[1][l] = x.y[number];
            nodes[n].xi[2][l] = mesh.nodes.z[number], nodes[n].x[2][l] = x.z[number];
        }
    }
}

/// Adds a node's contribution to a point and to the two tangents.
void add(Lane (&p)[3], Lane (&s)[3], Lane (&t)[3], const Lane (&node)[3], double value, double ds,
         double dt) {
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t l = 0; l < sphere_batch; ++l) {
            p[c][l] += value * node[c][l];
            s[c][l] += ds * node[c][l];
            t[c][l] += dt * node[c][l];
        }
}

/// The area element, with the sign of the radial component of the normal.
void signed_area(const Lane (&p)[3], const Lane (&s)[3], const Lane (&t)[3], Lane& area) {
    for (std::size_t l = 0; l < sphere_batch; ++l) {
        const double x = s[1][l] * t[2][l] - s[2][l] * t[1][l], y = s[2][l] * t[0][l] - s[0][l] * t[2][l],
                     z = s[0][l] * t[1][l] - s[1][l] * t[0][l];
        const double outward = x * p[0][l] + y * p[1][l] + z * p[2][l],
                     size = std::sqrt(x * x + y * y + z * z);
        area[l] = outward < 0 ? -size : size;
    }
}

} // namespace

SphereCellMeter::SphereCellMeter(CellKind kind, int points)
    : nodes_(static_cast<std::size_t>(nodes_per_cell(kind))) {
    GASPARD_CHECK(cell_dimension(kind) == 2 && nodes_ <= most_nodes);
    std::vector<double> values(nodes_);
    std::vector<Vec3> gradients(nodes_);
    const auto add_sample = [&](Vec3 point, double weight) {
        shape_functions(kind, point, values, gradients);
        weight_.push_back(weight);
        for (std::size_t n = 0; n < nodes_; ++n) {
            value_.push_back(values[n]);
            ds_.push_back(gradients[n].x);
            dt_.push_back(gradients[n].y);
        }
    };
    for (const auto& [point, weight] : cell_quadrature(kind.shape, points)) add_sample(point, weight);
    quadrature_ = weight_.size();
    for (const Vec3 node : reference_nodes(kind)) add_sample(node, 0);
}

SphereCellMeter::Measured SphereCellMeter::measure(const Mesh& mesh, std::size_t begin, std::size_t end,
                                                   const Points& x, const Monitor* monitor,
                                                   Workspace& workspace) const {
    std::array<Node, most_nodes> nodes;
    gather(mesh, begin, end, x, nodes_, nodes);
    workspace.points.resize(quadrature_ * sphere_batch);
    workspace.area.resize(quadrature_ * sphere_batch);
    workspace.monitor.resize(quadrature_ * sphere_batch);
    Measured measured;
    measured.mass.fill(0);
    measured.smallest.fill(std::numeric_limits<double>::infinity());
    measured.largest.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t q = 0; q < weight_.size(); ++q) {
        Lane p[3] = {}, s[3] = {}, t[3] = {}, from_p[3] = {}, from_s[3] = {}, from_t[3] = {}, area, from_area;
        for (std::size_t n = 0; n < nodes_; ++n) {
            const std::size_t at = q * nodes_ + n;
            add(p, s, t, nodes[n].x, value_[at], ds_[at], dt_[at]);
            add(from_p, from_s, from_t, nodes[n].xi, value_[at], ds_[at], dt_[at]);
        }
        signed_area(p, s, t, area);
        signed_area(from_p, from_s, from_t, from_area);
        for (std::size_t l = 0; l < sphere_batch; ++l) { // a NaN is kept
            const double jacobian = area[l] / from_area[l];
            measured.smallest[l] =
                jacobian < measured.smallest[l] || jacobian != jacobian ? jacobian : measured.smallest[l];
            measured.largest[l] =
                jacobian > measured.largest[l] || jacobian != jacobian ? jacobian : measured.largest[l];
        }
        if (q >= quadrature_) continue;
        for (std::size_t l = 0; l < sphere_batch; ++l) {
            workspace.points.x[q * sphere_batch + l] = p[0][l];
            workspace.points.y[q * sphere_batch + l] = p[1][l];
            workspace.points.z[q * sphere_batch + l] = p[2][l];
            workspace.area[q * sphere_batch + l] = weight_[q] * area[l];
        }
    }
    if (!monitor) return measured;
    monitor->values(workspace.points, workspace.monitor);
    for (std::size_t q = 0; q < quadrature_; ++q)
        for (std::size_t l = 0; l < sphere_batch; ++l)
            measured.mass[l] +=
                workspace.area[q * sphere_batch + l] * workspace.monitor[q * sphere_batch + l];
    return measured;
}

} // namespace gaspard
