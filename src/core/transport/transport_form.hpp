// The Monge-Ampère equation with transport boundary condition, discretised by the nonvariational finite
// element method of Kawecki, Lakkis, Pryer (2018), (71) and (76) to (79):
//
//   r_v = (det H - theta rho / sigma(g) + c, v) + <b(g), v>,        r_c = (u, 1)
//
//   g = G u, H = H u with gradient recovery; g = grad u without      (transport/nonvariational_space.hpp)
//   theta = (integral of sigma over the target) / (integral of rho over the source)
//   b     = s (1 - gauge^2) / 2, concave, positive inside the target
//
// The condition b(grad u) = 0 holds for any scale s > 0, but only with
//
//   grad b(grad u) = -(cof H) n
//
// it is the conormal condition of the linearised equation, so that Newton's method converges undamped.
// scale_of() makes that hold on average. Points outside the target, which iterates may have, take sigma from
// the boundary.
#pragma once

#include "core/monitor/monitor.hpp"
#include "core/transport/convex_curve.hpp"
#include "core/transport/nonvariational_space.hpp"

#include <memory>
#include <span>
#include <vector>

namespace gaspard {

/// The densities of a problem; their units do not matter.
struct TransportDensities {
    std::shared_ptr<const Monitor> source; ///< rho; null: constant
    std::shared_ptr<const Monitor> target; ///< sigma; null: constant
    friend bool operator==(const TransportDensities&, const TransportDensities&) = default;
};

class TransportForm {
  public:
    /// `source`: the source domain, if it is bounded by a curve; null: the mesh is the domain.
    TransportForm(std::shared_ptr<const NonvariationalSpace> space, std::shared_ptr<const ConvexCurve> source,
                  std::shared_ptr<const ConvexCurve> target);

    const NonvariationalSpace& space() const { return *space_; }
    const std::shared_ptr<const NonvariationalSpace>& shared_space() const { return space_; }
    std::size_t size() const { return space_->size() + 1; } ///< u at the nodes, then c
    double boundary_scale() const { return scale_; }        ///< s
    void set_boundary_scale(double scale) { scale_ = scale; }

    /// u = a quadratic polynomial whose gradient maps the moments of the uniform density of the source to
    /// those of the target, and c = 0. Sets the scale of b for it.
    std::vector<double> start();
    /// u = |x|^2 / 2, as in the paper, without a change of the scale.
    std::vector<double> identity() const;
    /// The scale for which grad b = -(cof H) n on average over the boundary, at the iterate last evaluated.
    double scale_of_iterate() const;

    /// Throws InputError if a density is not positive and finite.
    void evaluate(const TransportDensities& densities, std::span<const double> unknowns);
    // Of the unknowns last evaluated:
    std::span<const double> unknowns() const { return unknowns_; }
    std::span<const double> residual() const { return residual_; }
    /// |r_v| / |(mean of det H, v)|.
    double normalised_residual() const;
    /// G and H at the nodes.
    std::span<const double> derivatives() const { return derivatives_; }
    double theta() const { return theta_; }
    /// The smallest eigenvalue of (H, B) / (1, B) over the Bernstein polynomials B >= 0: u is strictly finite
    /// element convex (3.7) if it is positive. With degree 1 these are all nonnegative functions of V.
    double convexity() const { return convexity_; }
    /// |b| / |grad b|, about the distance from the target's boundary, of the images of nodes on the boundary;
    /// 0 for other nodes. And the largest of them.
    std::vector<double> boundary_defects(std::span<const double> derivatives) const;
    double boundary_defect() const;
    /// The area within the images of the boundary's edges, to rounding.
    double image_area(std::span<const double> derivatives) const;

    void linearise();
    /// out = -(dr/du) w.
    void derivative(std::span<const double> w, std::span<double> out);

  private:
    struct Boundary { ///< b and grad b
        double value;
        Vec3 gradient;
    };
    Boundary boundary(Vec3 p) const;
    void take(const TransportDensities& densities);
    void evaluate_target();
    void add_cells();
    void add_sides();
    void find_convexity();
    std::array<double, 2> gradient_at(std::span<const std::int32_t> cell, const TriangleShapes& shapes,
                                      const NonvariationalSpace::Point& point) const;
    Vec3 into_target(Vec3 p) const;

    std::shared_ptr<const NonvariationalSpace> space_;
    std::shared_ptr<const ConvexCurve> source_, target_;
    std::vector<std::vector<double>> bernstein_; ///< at the points of the rule
    double scale_ = 1;
    double inner_radius_ = 0; ///< of the target, around its centre
    TransportDensities densities_{};
    bool known_ = false; ///< densities_ were taken
    double theta_ = 1;
    std::vector<double> rho_;   ///< theta rho at the points
    Points images_;             ///< of the points, within the target
    std::vector<double> sigma_; ///< there
    std::vector<double> unknowns_, derivatives_, residual_;
    double convexity_ = 0;
    std::vector<double> values_; ///< of the linearisation: derivative_count numbers per entry
    std::vector<double> direct_; ///< terms with grad w, without recovery
    std::vector<double> of_w_, sum_;
};

} // namespace gaspard
