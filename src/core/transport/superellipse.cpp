// Ellipses, and superellipses |x / a|^p + |y / b|^p = 1 in coordinates along their axes.
#include "core/base/short_number.hpp"
#include "core/transport/arc_length.hpp"
#include "core/transport/checks.hpp"
#include "core/transport/convex_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

struct Axes {
    Vec3 centre, first, second; ///< semi-axes
    double a, b;                ///< their lengths

    Axes(Vec3 middle, double long_axis, double short_axis, double angle)
        : centre{middle.x, middle.y, 0}, a(long_axis), b(short_axis) {
        check_finite(middle.x, "the x coordinate of the centre");
        check_finite(middle.y, "the y coordinate of the centre");
        check_length(a, "the semi-axis a");
        check_length(b, "the semi-axis b");
        check_finite(angle, "the angle");
        const double radians = std::remainder(angle, 360.0) * (std::numbers::pi / 180);
        first = a * Vec3{std::cos(radians), std::sin(radians), 0};
        second = b * Vec3{-std::sin(radians), std::cos(radians), 0};
    }
    Vec3 world(double u, double v) const { return u * first + v * second; }
    /// Coordinates of p relative to the centre, in units of the semi-axes.
    Vec3 local(Vec3 p) const {
        const Vec3 q = p - centre;
        return {(q.x * first.x + q.y * first.y) / (a * a), (q.x * second.x + q.y * second.y) / (b * b), 0};
    }
    /// The gradient of a function of the local coordinates.
    Vec3 gradient(double du, double dv) const { return du / (a * a) * first + dv / (b * b) * second; }
};

/// The first quadrant of the superellipse with semi-axes 1 at the polar angle phi.
struct Quadrant {
    double p;

    struct Place {
        double x, y, dx, dy;
    };
    Place at(double phi) const {
        const double c = std::max(std::cos(phi), 0.0), s = std::sin(phi);
        if (p == 2) return {c, s, -s, c};
        const double c1 = std::pow(c, p - 1), s1 = std::pow(s, p - 1), sum = c * c1 + s * s1;
        const double scale = std::pow(sum, -1 / p), slope = scale / sum;
        return {scale * c, scale * s, -slope * s1, slope * c1};
    }
};

class Superellipse final : public ConvexCurve {
  public:
    Superellipse(const Axes& axes, double p)
        : ConvexCurve(measures_of(axes, p)), axes_(axes), quadrant_{p},
          length_(
              [q = Quadrant{p}, a = axes.a, b = axes.b](double phi) {
                  const auto place = q.at(phi);
                  return std::hypot(a * place.dx, b * place.dy);
              },
              {0, std::numbers::pi / 4, std::numbers::pi / 2}) {}

    Vec3 point(double t) const override {
        const auto place = at(t);
        return axes_.centre + axes_.world(place.x, place.y);
    }
    Vec3 tangent(double t) const override {
        const auto place = at(t);
        const Vec3 direction = axes_.world(place.dx, place.dy);
        return 4 * length_.total() / norm(direction) * direction;
    }
    bool is_ellipse() const override { return quadrant_.p == 2; }
    Gauge gauge(Vec3 p) const override {
        const Vec3 q = axes_.local(p);
        const double u = std::abs(q.x), v = std::abs(q.y), most = std::max(u, v);
        if (most == 0) return {0, axes_.gradient(1, 0)};
        if (quadrant_.p == 2) {
            const double radius = std::sqrt(u * u + v * v);
            return {radius, axes_.gradient(q.x / radius, q.y / radius)};
        }
        const double root = std::pow(1 + std::pow(std::min(u, v) / most, quadrant_.p), 1 / quadrant_.p);
        const double value = most * root, power = quadrant_.p - 1;
        return {value, axes_.gradient(std::copysign(std::pow(u / value, power), q.x),
                                      std::copysign(std::pow(v / value, power), q.y))};
    }

  private:
    static Measures measures_of(const Axes& axes, double p) {
        const double corner = std::tgamma(1 + 1 / p);
        // Dirichlet's integrals; for an ellipse pi a b and 1/4.
        const double area = 4 * axes.a * axes.b * corner * corner / std::tgamma(1 + 2 / p);
        const double moment =
            std::tgamma(3 / p) * std::tgamma(1 + 2 / p) / (std::tgamma(1 / p) * std::tgamma(1 + 4 / p));
        const auto covariance = [&](double i, double j, double k, double l) {
            return moment * (i * j + k * l);
        };
        const double dual = p / (p - 1);
        const auto half_width = [&](double i, double j) {
            return std::pow(std::pow(std::abs(i), dual) + std::pow(std::abs(j), dual), 1 / dual);
        };
        const Vec3 e = axes.first, f = axes.second;
        const Vec3 half{half_width(e.x, f.x), half_width(e.y, f.y), 0};
        return {.area = area,
                .centre = axes.centre,
                .covariance = {covariance(e.x, e.x, f.x, f.x), covariance(e.x, e.y, f.x, f.y),
                               covariance(e.y, e.y, f.y, f.y)},
                .box = {axes.centre - half, axes.centre + half}};
    }

    /// By reflections of the first quadrant.
    Quadrant::Place at(double t) const {
        const double quarters = 4 * (t - std::floor(t));
        const int k = std::min(static_cast<int>(quarters), 3);
        const double part = quarters - k;
        const bool back = k % 2 == 1;
        auto place = quadrant_.at(length_.parameter((back ? 1 - part : part) * length_.total()));
        const double x = k == 1 || k == 2 ? -1 : 1, y = k >= 2 ? -1 : 1, sense = back ? -1 : 1;
        return {x * place.x, y * place.y, sense * x * place.dx, sense * y * place.dy};
    }

    Axes axes_;
    Quadrant quadrant_;
    ArcLength length_;
};

} // namespace

std::shared_ptr<const ConvexCurve> ellipse(Vec3 centre, double a, double b, double angle) {
    return std::make_shared<const Superellipse>(Axes(centre, a, b, angle), 2);
}

std::shared_ptr<const ConvexCurve> rounded_rectangle(Vec3 centre, double a, double b, double p,
                                                     double angle) {
    if (!(p >= 2 && p <= 20))
        throw InputError("the exponent of a rounded rectangle must be between 2 and 20, not " +
                         exact_number(p));
    return std::make_shared<const Superellipse>(Axes(centre, a, b, angle), p);
}

} // namespace gaspard
