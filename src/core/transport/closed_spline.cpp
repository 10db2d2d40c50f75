// The periodic cubic spline with second derivatives M at its knots, h_k the distance of points k and k + 1:
//
//   h_{k-1} M_{k-1} + 2 (h_{k-1} + h_k) M_k + h_k M_{k+1}
//       = 6 ((p_{k+1} - p_k) / h_k - (p_k - p_{k-1}) / h_{k-1}).
//
// Of a cubic c0 + c1 s + c2 s^2 + c3 s^3, gamma' x gamma'' = 2 c1 x c2 + 6 (c1 x c3) s + 6 (c2 x c3) s^2 has
// the sign of the curvature, so that convexity is decided by the least value of a parabola.
#include "core/base/short_number.hpp"
#include "core/linear/tridiagonal.hpp"
#include "core/transport/checks.hpp"
#include "core/transport/piecewise_curve.hpp"
#include "core/transport/polygon.hpp"

#include <algorithm>
#include <numbers>

namespace gaspard {

namespace {

/// Columns x and y, one row per knot.
std::vector<double> second_derivatives(const Points& p, const std::vector<double>& h) {
    const std::size_t n = p.size();
    std::vector<double> diagonal(n), rows(2 * n);
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t before = (k + n - 1) % n, after = (k + 1) % n;
        diagonal[k] = 2 * (h[before] + h[k]);
        const Vec3 load = 6 * (1 / h[k] * (p[after] - p[k]) - 1 / h[before] * (p[k] - p[before]));
        rows[2 * k] = load.x, rows[2 * k + 1] = load.y;
    }
    TridiagonalSolver(diagonal, h, true).solve(rows.data(), 2, 2);
    return rows;
}

/// One cubic per interval between knots, s in [0, 1].
std::vector<CurvePiece> spline_cubics(const Points& p) {
    const std::size_t n = p.size();
    std::vector<double> h(n);
    for (std::size_t k = 0; k < n; ++k) h[k] = norm(p[(k + 1) % n] - p[k]);
    const auto rows = second_derivatives(p, h);
    std::vector<CurvePiece> cubics;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t after = (k + 1) % n;
        const Vec3 m = h[k] * h[k] * Vec3{rows[2 * k], rows[2 * k + 1], 0};
        const Vec3 next = h[k] * h[k] * Vec3{rows[2 * after], rows[2 * after + 1], 0};
        cubics.push_back(
            {.kind = CurvePiece::Kind::cubic,
             .c = {p[k], p[after] - p[k] - 1.0 / 6 * (2 * m + next), 0.5 * m, 1.0 / 6 * (next - m)}});
    }
    return cubics;
}

/// The smallest gamma' x gamma'' of a cubic and where it is, relative to the squared size of the derivatives.
struct Bend {
    double least, s;
};
Bend least_bend(const CurvePiece& cubic) {
    const auto& c = cubic.c;
    const double a = 2 * cross(c[1], c[2]).z, b = 6 * cross(c[1], c[3]).z, q = 6 * cross(c[2], c[3]).z;
    Bend found{a, 0};
    const auto see = [&](double s) {
        const double bend = a + s * (b + s * q);
        if (bend < found.least) found = {bend, s};
    };
    see(1);
    if (q > 0 && b < 0 && -b < 2 * q) see(-b / (2 * q));
    found.least /= dot(c[1], c[1]) + dot(c[2], c[2]) + dot(c[3], c[3]);
    return found;
}

double turning(const CurvePiece& piece) {
    const Vec3 a = piece.derivative(0), b = piece.derivative(1);
    return std::atan2(cross(a, b).z, dot(a, b));
}

/// The piece on [i / count, (i + 1) / count].
CurvePiece part_of(const CurvePiece& piece, int i, int count) {
    const double s = static_cast<double>(i) / count, h = 1.0 / count;
    const auto& c = piece.c;
    return {.kind = piece.kind,
            .c = {piece.at(s), h * piece.derivative(s), h * h * (c[2] + 3 * s * c[3]), h * h * h * c[3]}};
}

[[noreturn]] void refuse(const Points& p, std::size_t k) {
    throw InputError("the spline is not convex near (" + exact_number(p.x[k]) + ", " + exact_number(p.y[k]) +
                     "), point " + std::to_string(k + 1));
}

} // namespace

std::shared_ptr<const ConvexCurve> closed_spline(const Points& given) {
    check_convex(given, 1e-9, "point");
    const std::size_t n = given.size();
    const bool reversed = signed_area(given) < 0;
    const auto original = [&](std::size_t k) { return reversed ? (n - k) % n : k % n; };
    const Vec3 origin = bounding_box(given).centre();
    Points points(n);
    for (std::size_t k = 0; k < n; ++k) {
        const Vec3 p = given[original(k)] - origin;
        points.set(k, {p.x, p.y, 0});
    }
    constexpr int parts = 4; // no part is seen from inside under pi
    std::vector<CurvePiece> pieces;
    double turned = 0;
    const auto cubics = spline_cubics(points);
    for (std::size_t k = 0; k < n; ++k) {
        const auto [least, s] = least_bend(cubics[k]);
        if (least < -1e-10) refuse(given, original(s < 0.5 ? k : k + 1));
        for (int i = 0; i < parts; ++i) {
            pieces.push_back(part_of(cubics[k], i, parts));
            turned += turning(pieces.back());
        }
    }
    if (std::abs(turned - 2 * std::numbers::pi) > 1)
        throw InputError("the spline through the points crosses itself");
    return std::make_shared<const PiecewiseCurve>(std::move(pieces), origin);
}

} // namespace gaspard
