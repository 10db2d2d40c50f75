// Lagrange elements of degree k = 1 to 3 on a mesh of triangles, straight or isoparametric:
//
//   x(s, t) = sum_i L_i(s, t) x_i        per triangle, L_i the shape functions, x_i its nodes
//
// Nodes per triangle: corners, then k - 1 per edge (0-1, 1-2, 2-0, from the first corner on), then the
// interior one of degree 3. On straight triangles the nodes are where the affine map has them. On a curved
// boundary the nodes of boundary edges lie on the curve; the interior node of a cubic triangle follows, so
// that the map's derivatives decrease as h^2, h^3 (Ciarlet, Raviart, 1972; Lenoir, 1986).
#pragma once

#include "core/mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gaspard {

/// The boundary of a mesh, anticlockwise.
struct BoundarySides {
    std::vector<std::int32_t> nodes; ///< side i runs from nodes[i] to the next one, the last to the first
    /// The point of the curve at s in [0, 1] of a side; empty: sides are straight.
    std::function<Vec3(std::size_t side, double s)> point{};
};

inline constexpr int highest_triangle_degree = 3;

/// The nodes of degree k in their order, by multiples of 1/k of the barycentric coordinates.
std::vector<std::array<int, 3>> lagrange_lattice(int degree);

/// Shape functions of degree k at a point of the reference triangle, and their derivatives by s and t.
struct TriangleShapes {
    std::vector<double> values;
    std::vector<std::array<double, 2>> slopes;
};
TriangleShapes triangle_shapes(int degree, double s, double t);

class LagrangeTriangles {
  public:
    /// `corners`: triangles of order 1, anticlockwise. The first nodes are those of this mesh.
    LagrangeTriangles(const Mesh& corners, const BoundarySides& boundary, int degree);

    int degree() const { return degree_; }
    bool curved() const { return curved_; } ///< some triangle's map is not affine
    const Points& nodes() const { return nodes_; }
    std::size_t cell_count() const { return cells_.size() / per_cell_; }
    std::size_t per_cell() const { return per_cell_; }
    std::span<const std::int32_t> cell(std::size_t i) const {
        return {cells_.data() + i * per_cell_, per_cell_};
    }

    struct Side {
        std::size_t cell = 0;
        int edge = 0; ///< of the cell: 0-1, 1-2 or 2-0
    };
    /// In the order of BoundarySides.
    const std::vector<Side>& sides() const { return sides_; }
    /// A point of an edge of the reference triangle, at r in [0, 1] from its first corner on.
    static std::array<double, 2> on_edge(int edge, double r);

    /// Position and derivatives of a cell's map, from the shapes at a point.
    struct Place {
        Vec3 x{};
        std::array<double, 2> by_s{}, by_t{}; ///< dx/ds, dx/dt
        double jacobian() const { return by_s[0] * by_t[1] - by_s[1] * by_t[0]; }
        /// grad of a function with the derivatives (ds, dt) by s and t.
        std::array<double, 2> gradient(double ds, double dt) const;
    };
    Place place(std::size_t cell, const TriangleShapes& shapes) const;

  private:
    void number(const Mesh& corners);
    void curve(const BoundarySides& boundary);

    int degree_;
    std::size_t per_cell_;
    bool curved_ = false;
    Points nodes_;
    std::vector<std::int32_t> cells_;
    std::vector<Side> sides_;
};

} // namespace gaspard
