// Closed convex curves of class C1 in the plane (z = 0), the boundaries of convex domains.
//
// A curve gamma is anticlockwise and has the parameter t in [0, 1), continued with period 1. Its Minkowski
// gauge about the centroid c of the domain,
//
//   g(c + s (gamma(t) - c)) = s   for s >= 0,
//
// is convex and homogeneous of degree 1 in p - c, and less than 1 exactly inside. With the outward normal n
// at the point of the curve in the direction p - c, grad g = n / (n . (gamma - c)), and g = grad g . (p - c).
#pragma once

#include "core/base/box.hpp"
#include "core/base/points.hpp"

#include <memory>

namespace gaspard {

/// A symmetric matrix of size 2.
struct Covariance {
    double xx = 0, xy = 0, yy = 0;
};

class ConvexCurve {
  public:
    struct Gauge {
        double value = 0;
        Vec3 gradient;
    };

    virtual ~ConvexCurve() = default;
    ConvexCurve(const ConvexCurve&) = delete;
    ConvexCurve& operator=(const ConvexCurve&) = delete;

    virtual Vec3 point(double t) const = 0;
    virtual Vec3 tangent(double t) const = 0; ///< d point / dt
    /// To a few units in the last place of p - c. At the centroid the value is 0, and the gradient that of
    /// some direction.
    virtual Gauge gauge(Vec3 p) const = 0;
    virtual bool is_ellipse() const { return false; }

    double area() const { return measures_.area; }
    Vec3 centre() const { return measures_.centre; } ///< the centroid of the domain
    /// Second moments about the centroid of the uniform density with mass 1.
    Covariance covariance() const { return measures_.covariance; }
    const Box& bounding_box() const { return measures_.box; }

  protected:
    struct Measures {
        double area = 0;
        Vec3 centre;
        Covariance covariance;
        Box box;
    };
    explicit ConvexCurve(const Measures& measures) : measures_(measures) {}

  private:
    Measures measures_;
};

/// The range of lengths that curves may have; of the longest side of their box twice that.
inline constexpr double shortest_length = 1e-6, longest_length = 1e6;

// All throw InputError, one sentence, if a number is not finite or a length is out of range.

/// Semi-axes a and b, of which a has the given angle with the x axis, in degrees. t is proportional to the
/// length of the curve from the end of a on; for a disk it is the angle divided by 2 pi.
std::shared_ptr<const ConvexCurve> ellipse(Vec3 centre, double a, double b, double angle = 0);

/// The superellipse |x / a|^p + |y / b|^p = 1 with p in [2, 20], turned by the angle in degrees. t is as for
/// an ellipse.
std::shared_ptr<const ConvexCurve> rounded_rectangle(Vec3 centre, double a, double b, double p,
                                                     double angle = 0);

/// The periodic cubic spline through at least three points in either orientation, whose knots have the
/// distances of the points. t is proportional to its length from the first point on. Throws InputError if the
/// spline is not convex, and names a point near which it is not.
std::shared_ptr<const ConvexCurve> closed_spline(const Points& points);

/// A convex polygon, of either orientation, whose corners are replaced by arcs of circles. Corners within
/// `tolerance` (relative to the size) of a straight side are left out. t is proportional to the length from
/// the middle of the first arc on. Throws InputError that names the corner at which the polygon is not
/// convex, or the largest radius if this one does not fit.
std::shared_ptr<const ConvexCurve> rounded_polygon(const Points& corners, double radius,
                                                   double tolerance = 1e-12);

} // namespace gaspard
