// Gauges, tangents and moments of convex curves, and what is refused.
#include "core/base/error.hpp"
#include "core/transport/convex_curve.hpp"
#include "support/convex_curves.hpp"
#include "support/messages.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace gaspard {
namespace {

constexpr double pi = std::numbers::pi;

double curve_size(const ConvexCurve& curve) { return longest_side(curve.bounding_box()); }

class CurveDraws {
  public:
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }

  private:
    std::mt19937 engine_{7};
};

TEST(ConvexCurve, ItsGaugeIsTheFactorFromTheCentre) {
    CurveDraws draw;
    for (const auto& [name, curve] : all_curves())
        for (int k = 0; k < 500; ++k) {
            const Vec3 c = curve->centre(), p = curve->point(draw(0, 1)) - c;
            const double s = draw(0.05, 3);
            const double rounding = norm(c) / (s * norm(p)); // of the digits of c + s p
            ASSERT_NEAR(curve->gauge(c + s * p).value / s, 1, 1e-14 + 1e-14 * rounding) << name;
        }
}

TEST(ConvexCurve, TheGradientOfItsGaugeIsThatOfDifferences) {
    CurveDraws draw;
    for (const auto& [name, curve] : all_curves())
        for (int k = 0; k < 200; ++k) {
            const double size = curve_size(*curve), step = 1e-5 * size;
            const Vec3 p = curve->centre() + draw(0.3, 2) * (curve->point(draw(0, 1)) - curve->centre());
            const Vec3 d{draw(-1, 1), draw(-1, 1), 0};
            const double difference =
                (curve->gauge(p + step * d).value - curve->gauge(p - step * d).value) / (2 * step);
            ASSERT_NEAR(size * difference, size * dot(curve->gauge(p).gradient, d), 2e-4) << name;
        }
}

TEST(ConvexCurve, TheGradientIsNormalToTheTangent) {
    CurveDraws draw;
    for (const auto& [name, curve] : all_curves())
        for (int k = 0; k < 200; ++k) {
            const double t = draw(0, 1);
            const Vec3 gradient = curve->gauge(curve->point(t)).gradient, tangent = curve->tangent(t);
            ASSERT_NEAR(dot(gradient, tangent) / (norm(gradient) * norm(tangent)), 0, 1e-8) << name;
        }
}

TEST(ConvexCurve, ItsGaugeIsFiniteAtTheCentre) {
    for (const auto& [name, curve] : all_curves()) {
        const auto [value, gradient] = curve->gauge(curve->centre());
        EXPECT_EQ(value, 0) << name;
        EXPECT_TRUE(std::isfinite(gradient.x) && std::isfinite(gradient.y)) << name;
    }
}

TEST(ConvexCurve, ItsGaugeIsHomogeneous) {
    CurveDraws draw;
    for (const auto& [name, curve] : all_curves())
        for (int k = 0; k < 100; ++k) {
            const Vec3 c = curve->centre(), q = curve_size(*curve) * Vec3{draw(-1, 1), draw(-1, 1), 0};
            const double once = curve->gauge(c + q).value;
            ASSERT_NEAR(curve->gauge(c + 2 * q).value / once, 2, 1e-12) << name;
        }
}

TEST(ConvexCurve, ItsGaugeIsConvexAndSoIsTheBoundaryFunction) {
    CurveDraws draw;
    for (const auto& [name, curve] : all_curves())
        for (int k = 0; k < 500; ++k) {
            const auto value = [&, &of = curve](Vec3 p) { return of->gauge(p).value; };
            const auto random = [&, &of = curve] {
                return of->centre() + draw(0, 1) * (of->point(draw(0, 1)) - of->centre());
            };
            const Vec3 a = random(), b = random(), middle = 0.5 * (a + b);
            const double ga = value(a), gb = value(b), gm = value(middle);
            ASSERT_LE(gm, (ga + gb) / 2 + 1e-13) << name;
            ASSERT_GE((1 - gm * gm) / 2, (2 - ga * ga - gb * gb) / 4 - 1e-13)
                << name; // (1 - g^2) / 2 is concave
        }
}

TEST(ConvexCurve, ItIsPeriodicAnticlockwiseAndHasItsTangent) {
    CurveDraws draw;
    for (const auto& [name, curve] : all_curves()) {
        const double size = curve_size(*curve);
        for (int k = 0; k < 200; ++k) {
            const double t = draw(0, 1), step = 1e-6;
            const Vec3 p = curve->point(t), tangent = curve->tangent(t);
            ASSERT_LT(norm(curve->point(t + 2) - p), 1e-9 * size) << name;
            ASSERT_LT(norm(curve->point(t - 1) - p), 1e-9 * size) << name;
            ASSERT_GT(cross(p - curve->centre(), tangent).z, 0) << name;
            const Vec3 difference = 1 / (2 * step) * (curve->point(t + step) - curve->point(t - step));
            ASSERT_LT(norm(difference - tangent), 1e-3 * norm(tangent)) << name;
        }
    }
}

TEST(ConvexCurve, ItHasEqualLengths) {
    for (const auto& [name, curve] : all_curves()) {
        const double speed = norm(curve->tangent(0));
        for (int k = 1; k < 50; ++k) ASSERT_NEAR(norm(curve->tangent(k / 50.0)) / speed, 1, 1e-12) << name;
    }
}

/// By the midpoints of many intervals of t.
TEST(ConvexCurve, ItsMomentsAreThoseOfItsPoints) {
    for (const auto& [name, curve] : all_curves()) {
        constexpr int n = 20000;
        double area = 0, xx = 0, xy = 0, yy = 0;
        Vec3 first, low{1e9, 1e9, 0}, high{-1e9, -1e9, 0};
        for (int k = 0; k < n; ++k) {
            const Vec3 p = curve->point((k + 0.5) / n), r = p - curve->centre();
            const double cone = cross(r, curve->tangent((k + 0.5) / n)).z / n;
            area += cone / 2;
            first = first + cone / 3 * r;
            xx += cone / 4 * r.x * r.x, xy += cone / 4 * r.x * r.y, yy += cone / 4 * r.y * r.y;
            low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
        }
        const double size = curve_size(*curve), square = size * size, close = 1e-6;
        EXPECT_NEAR(area / curve->area(), 1, close) << name;
        EXPECT_LT(norm(first), close * size * area) << name;
        EXPECT_NEAR(xx / area / square, curve->covariance().xx / square, close) << name;
        EXPECT_NEAR(xy / area / square, curve->covariance().xy / square, close) << name;
        EXPECT_NEAR(yy / area / square, curve->covariance().yy / square, close) << name;
        EXPECT_LT(norm(low - curve->bounding_box().low), close * size) << name;
        EXPECT_LT(norm(high - curve->bounding_box().high), close * size) << name;
    }
}

TEST(ConvexCurve, AnEllipseHasItsExactNumbers) {
    const auto curve = ellipse({1, -2, 0}, 3, 0.5, 90);
    EXPECT_NEAR(curve->area(), 1.5 * pi, 1e-14);
    EXPECT_NEAR(curve->covariance().xx, 0.0625, 1e-15);
    EXPECT_NEAR(curve->covariance().yy, 2.25, 1e-14);
    EXPECT_NEAR(curve->covariance().xy, 0, 1e-15);
    EXPECT_NEAR(curve->gauge({1.3, -0.5, 0}).value, std::hypot(0.3 / 0.5, 1.5 / 3), 1e-15);
    EXPECT_LT(norm(curve->point(0.25) - Vec3{0.5, -2, 0}), 1e-14);
    EXPECT_LT(norm(ellipse({}, 2, 2)->point(0.1) - Vec3{2 * std::cos(0.2 * pi), 2 * std::sin(0.2 * pi), 0}),
              1e-14);
}

TEST(ConvexCurve, ARoundedRectangleHasItsExactNumbers) {
    const auto curve = rounded_rectangle({}, 2, 1, 4);
    // 4 a b Gamma(5/4)^2 / Gamma(3/2)
    EXPECT_NEAR(curve->area(), 8 * std::pow(0.9064024770554771, 2) / 0.886226925452758, 1e-13);
    EXPECT_NEAR(curve->gauge({1, -0.5, 0}).value, std::pow(0.125, 0.25), 1e-15);
    EXPECT_NEAR(curve->gauge({0, 0.3, 0}).gradient.y, 1, 1e-15);
    EXPECT_LT(norm(curve->point(0.75) - Vec3{0, -1, 0}), 1e-15);
    EXPECT_NEAR(rounded_rectangle({}, 2, 1, 2)->gauge({0.3, 0.4, 0}).value,
                ellipse({}, 2, 1)->gauge({0.3, 0.4, 0}).value, 1e-16);
}

TEST(ConvexCurve, ARoundedSquareHasItsExactNumbers) {
    const auto curve = rounded_polygon(square_corners(2), 0.25);
    EXPECT_NEAR(curve->area(), 4 - (4 - pi) / 16, 1e-14);
    EXPECT_LT(norm(curve->centre() - Vec3{1, 1, 0}), 1e-15);
    EXPECT_NEAR(norm(curve->tangent(0.3)), 8 - 8 * 0.25 + 2 * pi * 0.25, 1e-13);
    EXPECT_NEAR(curve->gauge({1.9, 1.2, 0}).value, 0.9, 1e-15);
    const double corner = 0.75 * std::sqrt(2) + 0.25; // distance of the curve from the centre
    EXPECT_NEAR(curve->gauge({0.5, 0.5, 0}).value, std::sqrt(0.5) / corner, 1e-15);
    const auto round = rounded_polygon(square_corners(2), 1); // no sides are left
    EXPECT_NEAR(round->area(), pi, 1e-14);
    EXPECT_NEAR(round->gauge({1.3, 1.4, 0}).value, 0.5, 1e-15);
}

TEST(ConvexCurve, StraightCornersAreMerged) {
    const auto plain = rounded_polygon(square_corners(), 0.4);
    const auto more = rounded_polygon(
        listed_points({{0.5, 0, 0}, {0.6, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1e-9, 0}, {0, 0, 0}}),
        0.4, 1e-6);
    EXPECT_NEAR(plain->area(), more->area(), 1e-8);
}

TEST(ConvexCurve, OrientationsOfPointsDoNotMatter) {
    const auto backwards = [](const Points& points) {
        Points reversed(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) reversed.set(i, points[points.size() - 1 - i]);
        return reversed;
    };
    EXPECT_NEAR(rounded_polygon(backwards(square_corners()), 0.1)->area(),
                rounded_polygon(square_corners(), 0.1)->area(), 1e-14);
    EXPECT_NEAR(closed_spline(backwards(uneven_points(9)))->area(), closed_spline(uneven_points(9))->area(),
                1e-12);
}

TEST(ConvexCurve, ASplineGoesThroughItsPointsAndConvergesToTheirEllipse) {
    const Points points = uneven_points(10);
    const auto curve = closed_spline(points);
    EXPECT_LT(norm(curve->point(0) - points[0]), 1e-13);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(curve->gauge(points[i]).value, 1, 1e-14);
    const double coarse = std::abs(closed_spline(uneven_points(20))->area() - 6 * pi);
    const double fine = std::abs(closed_spline(uneven_points(40))->area() - 6 * pi);
    EXPECT_GT(coarse / fine, 12) << "order 4";
    EXPECT_LT(fine, 1e-4);
    EXPECT_GT(closed_spline(listed_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))->area(), 0.5);
}

TEST(ConvexCurve, RefusesBadNumbers) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 most = std::numeric_limits<double>::infinity();
    const auto message = [](auto&& make) { return message_of<InputError>(make); };
    EXPECT_EQ(message([&] { ellipse({}, 0, 1); }), "the semi-axis a must be between 10⁻⁶ and 10⁶, not 0");
    EXPECT_EQ(message([&] { ellipse({}, 1, nan); }),
              "the semi-axis b must be between 10⁻⁶ and 10⁶, not NaN");
    EXPECT_EQ(message([&] {
                  ellipse({most, 0, 0}, 1, 1);
              }),
              "the x coordinate of the centre must be a finite number");
    EXPECT_EQ(message([&] { ellipse({}, 1, 1, nan); }), "the angle must be a finite number");
    EXPECT_EQ(message([&] { rounded_rectangle({}, 1, 1, 21); }),
              "the exponent of a rounded rectangle must be between 2 and 20, not 21");
    EXPECT_EQ(message([&] { rounded_rectangle({}, 2e6, 1, 4); }),
              "the semi-axis a must be between 10⁻⁶ and 10⁶, not 2×10⁶");
    EXPECT_EQ(message([&] { rounded_polygon(square_corners(), -1); }),
              "the radius of the corners must be positive, not −1");
    EXPECT_EQ(message([&] { rounded_polygon(square_corners(1e7), 1); }),
              "the size of the curve must be between 10⁻⁶ and 2×10⁶, not 10⁷");
    EXPECT_EQ(message([&] {
                  rounded_polygon(listed_points({{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}), 1);
              }),
              "each coordinate of corner 2 must be a finite number");
}

TEST(ConvexCurve, RefusesPolygonsThatAreNotConvex) {
    const auto message = [](std::initializer_list<Vec3> corners) {
        return message_of<InputError>([&] { rounded_polygon(listed_points(corners), 0.01); });
    };
    EXPECT_EQ(message({{0, 0, 0}, {1, 0, 0}}), "a closed convex curve needs at least three corners, not 2");
    EXPECT_EQ(message({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.6, 0.4, 0}}),
              "the polygon is not convex at corner 4 at (0.6, 0.4)");
    EXPECT_EQ(
        message({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}),
        "the polygon crosses itself: its sides after corner 1 at (0, 0) and after corner 3 at (1, 0) meet");
    EXPECT_EQ(message({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
              "the polygon has the same point twice: corner 2 at (1, 0) and corner 3 at (1, 0)");
    EXPECT_EQ(message({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}),
              "the polygon has no area, all its points lie on one line");
    EXPECT_EQ(message({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}).substr(0, 26),
              "the polygon crosses itself");
    Points star(5), twice(6);
    for (std::size_t k = 0; k < 5; ++k) star.set(k, ellipse({}, 1, 1)->point(0.4 * static_cast<double>(k)));
    for (std::size_t k = 0; k < 6; ++k) twice.set(k, ellipse({}, 1, 1)->point(static_cast<double>(k) / 3));
    for (const Points& points : {star, twice})
        EXPECT_EQ(message_of<InputError>([&] { rounded_polygon(points, 0.01); }).substr(0, 26),
                  "the polygon crosses itself");
}

TEST(ConvexCurve, NamesTheLargestRadius) {
    const std::string text = message_of<InputError>([] { rounded_polygon(square_corners(), 0.6); });
    EXPECT_EQ(text,
              "the radius 0.6 of the corners is too large for the sides of the polygon; the largest is 0.5");
    const Points triangle = listed_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const std::string other = message_of<InputError>([&] { rounded_polygon(triangle, 1); });
    const double largest = std::stod(other.substr(other.rfind(' ')));
    EXPECT_NEAR(largest, 1 - std::sqrt(0.5), 1e-4); // that of the inscribed circle
    EXPECT_NO_THROW(rounded_polygon(triangle, largest));
}

TEST(ConvexCurve, RefusesSplinesThatAreNotConvex) {
    const std::string text = message_of<InputError>([] { // straight sides make a spline oscillate
        closed_spline(
            listed_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {3, 2, 0}, {0, 2, 0}}));
    });
    EXPECT_EQ(text, "the spline is not convex near (1, 0), point 2");
    const std::string given = message_of<InputError>([] {
        closed_spline(listed_points({{0, 0, 0}, {1, 0, 0}, {0.4, 0.4, 0}, {0, 1, 0}}));
    });
    EXPECT_EQ(given, "the polygon of the points is not convex at point 3 at (0.4, 0.4)");
}

} // namespace
} // namespace gaspard
