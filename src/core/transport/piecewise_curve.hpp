// Closed convex curves of lines, arcs of circles and cubics.
#pragma once

#include "core/transport/arc_length.hpp"
#include "core/transport/convex_curve.hpp"

#include <array>
#include <vector>

namespace gaspard {

/// A line or cubic c0 + c1 s + c2 s^2 + c3 s^3, or an arc c0 + radius (cos, sin)(start + s sweep), with s in
/// [0, 1]. It is convex, and turns left by less than pi.
struct CurvePiece {
    enum class Kind { line, cubic, arc } kind = Kind::line;
    std::array<Vec3, 4> c{};
    double radius = 0, start = 0, sweep = 0;

    Vec3 at(double s) const;
    Vec3 derivative(double s) const;

    /// The outward normal (of any length) where the ray from the origin in the direction of the unit vector d
    /// meets this piece, and a point of the tangent there.
    struct Hit {
        Vec3 normal, point;
    };
    Hit hit(Vec3 d) const;
};

CurvePiece line_piece(Vec3 from, Vec3 to);
CurvePiece arc_piece(Vec3 middle, double radius, double start, double sweep);

class PiecewiseCurve final : public ConvexCurve {
  public:
    /// The pieces follow each other anticlockwise, are relative to `origin`, and the origin is inside. t is
    /// proportional to the length from the first piece on.
    PiecewiseCurve(std::vector<CurvePiece> pieces, Vec3 origin);

    Vec3 point(double t) const override;
    Vec3 tangent(double t) const override;
    Gauge gauge(Vec3 p) const override;

  private:
    struct Centred; ///< pieces relative to the centroid
    explicit PiecewiseCurve(Centred centred);
    struct Place {
        std::size_t piece;
        double s;
    };
    Place place(double t) const;

    std::vector<CurvePiece> pieces_;
    ArcLength length_;
    std::size_t first_ = 0;      ///< the piece whose start has the smallest polar angle
    std::vector<double> angles_; ///< of the starts, from that piece on, ascending
};

} // namespace gaspard
