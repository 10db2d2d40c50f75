// The operators of the nonvariational finite element method (Lakkis, Pryer, 2013; Kawecki, Lakkis, Pryer,
// 2018) on Lagrange triangles. For u in V, with test functions v in V:
//
//   (G_a, v)  = (d_a u, v)                                    recovered gradient (73)
//   (H_ab, v) = -(g_a, d_b v) + <g_a, n_b v>, symmetrised     Hessian: g = G by (75), g = grad u by (39)
//
// Both are eliminated: u alone is unknown. With recovery, as G is continuous, (75) is (H_ab, v) = (d_b G_a,
// v). The mass matrix is factorised once. Arrays of several numbers per node keep those of a node together.
#pragma once

#include "core/linear/cell_cholesky.hpp"
#include "core/transport/cell_pattern.hpp"
#include "core/transport/lagrange_triangles.hpp"

#include <array>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace gaspard {

enum class Recovery { none, gradient };

/// Order of the numbers of Derivatives.
enum DerivativeIndex : std::size_t { h11, h12, h22, g1, g2, derivative_count };

class NonvariationalSpace {
  public:
    /// Throws Interrupted if asked to stop.
    NonvariationalSpace(LagrangeTriangles elements, Recovery recovery, std::stop_token stop = {});

    const LagrangeTriangles& elements() const { return elements_; }
    Recovery recovery() const { return recovery_; }
    std::size_t size() const { return elements_.nodes().size(); } ///< N
    const CellUnknowns& unknowns() const { return unknowns_; }
    const CellPattern& pattern() const { return pattern_; }
    const Points& middles() const { return middles_; } ///< one point of each cell
    const std::shared_ptr<const Dissection>& dissection() const { return dissection_; }
    /// (1, v) for the nodal basis, and its sum, the area of the mesh.
    std::span<const double> loads() const { return loads_; }
    double area() const { return area_; }

    /// H and G of u at the nodes: derivative_count numbers per node.
    void differentiate(std::span<const double> u, std::vector<double>& derivatives) const;
    /// Solves (f, v) = b for f, `b` and the result with four numbers per node.
    void project(std::vector<double>& four) const;

    // Quadrature. Points are numbered cell by cell; those of sides follow each other likewise.
    struct Point {
        double weight = 0;          ///< of the rule times the Jacobian
        std::array<double, 4> by{}; ///< d s/dx, ds/dy, dt/dx, dt/dy
        std::array<double, 2> gradient(const std::array<double, 2>& slopes) const {
            return {slopes[0] * by[0] + slopes[1] * by[2], slopes[0] * by[1] + slopes[1] * by[3]};
        }
    };
    struct SidePoint {
        Point point;                    ///< weight: the length element
        std::array<double, 2> normal{}; ///< outer, of length 1
    };
    const std::vector<TriangleShapes>& shapes() const { return shapes_; }
    std::span<const Point> points(std::size_t cell) const {
        return {points_.data() + cell * shapes_.size(), shapes_.size()};
    }
    const std::vector<TriangleShapes>& side_shapes(int edge) const {
        return side_shapes_[static_cast<std::size_t>(edge)];
    }
    std::span<const SidePoint> side_points(std::size_t side) const {
        return {side_points_.data() + side * side_shapes_[0].size(), side_shapes_[0].size()};
    }
    /// Positions of all points of cells.
    Points positions() const;

  private:
    void make_points(const std::stop_token& stop);
    void make_operators(const std::stop_token& stop);
    void add_side_terms();

    LagrangeTriangles elements_;
    Recovery recovery_;
    CellUnknowns unknowns_;
    CellPattern pattern_;
    std::vector<TriangleShapes> shapes_;
    std::array<std::vector<TriangleShapes>, 3> side_shapes_;
    std::vector<double> weights_, side_weights_; ///< of the rules
    std::vector<Point> points_;
    std::vector<SidePoint> side_points_;
    Points middles_;
    std::shared_ptr<const Dissection> dissection_;
    std::unique_ptr<const CellCholesky> mass_;
    std::vector<double> loads_;
    double area_ = 0;
    std::vector<double> slopes_;   ///< (d_1 u, v), (d_2 u, v): two numbers per entry
    std::vector<double> hessians_; ///< the right-hand sides of (39), h11 to h22; without recovery only
};

} // namespace gaspard
