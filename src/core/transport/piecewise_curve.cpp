#include "core/transport/piecewise_curve.hpp"

#include "core/base/check.hpp"
#include "core/fem/gauss.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gaspard {

namespace {

double across(Vec3 a, Vec3 b) { return a.x * b.y - a.y * b.x; }

Vec3 direction_at(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

Vec3 outward(Vec3 tangent) { return {tangent.y, -tangent.x, 0}; }

/// Where d x (c0 + c1 s + c2 s^2 + c3 s^3) changes from below to above zero in [0, 1].
double cubic_crossing(const std::array<Vec3, 4>& c, Vec3 d) {
    const double f0 = across(d, c[0]), f1 = across(d, c[1]), f2 = across(d, c[2]), f3 = across(d, c[3]);
    const double end = f0 + f1 + f2 + f3;
    double low = 0, high = 1, s = end > f0 ? std::clamp(f0 / (f0 - end), 0.0, 1.0) : 0.5;
    for (int iteration = 0; iteration < 80; ++iteration) {
        const double f = f0 + s * (f1 + s * (f2 + s * f3)), slope = f1 + s * (2 * f2 + s * 3 * f3);
        (f > 0 ? high : low) = s;
        double next = slope > 0 ? s - f / slope : low + (high - low) / 2;
        if (!(next >= low && next <= high)) next = low + (high - low) / 2;
        const double step = std::abs(next - s);
        s = next;
        if (step <= 1e-10) break; // the next step would be some 1e-20, and the tangent makes good for 1e-10
    }
    return s;
}

/// Where the coordinate's derivative changes its sign, if it does.
double extreme(const CurvePiece& piece, double Vec3::*coordinate) {
    double low = 0, high = 1;
    const double first = piece.derivative(0).*coordinate;
    if (first * (piece.derivative(1).*coordinate) >= 0) return 0;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = low + (high - low) / 2;
        (first * (piece.derivative(middle).*coordinate) > 0 ? low : high) = middle;
    }
    return low;
}

/// Integrals over the triangles between the curve and the origin.
struct Moments {
    double area = 0;
    Vec3 first;
    Covariance second;
};

Moments moments_of(const std::vector<CurvePiece>& pieces) {
    static const LineQuadrature rule = gauss_legendre(24); // exact for cubics, to rounding for arcs below pi
    Moments sum;
    for (const CurvePiece& piece : pieces)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const Vec3 r = piece.at(rule.points[i]);
            const double cone = rule.weights[i] * across(r, piece.derivative(rule.points[i]));
            sum.area += cone / 2;
            sum.first = sum.first + cone / 3 * r;
            sum.second.xx += cone / 4 * r.x * r.x;
            sum.second.xy += cone / 4 * r.x * r.y;
            sum.second.yy += cone / 4 * r.y * r.y;
        }
    return sum;
}

Box box_of(const std::vector<CurvePiece>& pieces, Vec3 centre) {
    Points points;
    for (const CurvePiece& piece : pieces)
        for (const double s : {0.0, extreme(piece, &Vec3::x), extreme(piece, &Vec3::y)}) {
            points.resize(points.size() + 1);
            points.set(points.size() - 1, piece.at(s));
        }
    const Box box = gaspard::bounding_box(points);
    return {centre + box.low, centre + box.high};
}

std::vector<double> whole_numbers(std::size_t last) {
    std::vector<double> numbers(last + 1);
    std::iota(numbers.begin(), numbers.end(), 0.0);
    return numbers;
}

double speed_of(const std::vector<CurvePiece>& pieces, double u) {
    const std::size_t i = std::min(static_cast<std::size_t>(u), pieces.size() - 1);
    return norm(pieces[i].derivative(u - static_cast<double>(i)));
}

} // namespace

Vec3 CurvePiece::at(double s) const {
    if (kind == Kind::arc) return c[0] + radius * direction_at(start + s * sweep);
    if (kind == Kind::line) return c[0] + s * c[1];
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}

Vec3 CurvePiece::derivative(double s) const {
    if (kind == Kind::arc) {
        const Vec3 d = direction_at(start + s * sweep);
        return radius * sweep * Vec3{-d.y, d.x, 0};
    }
    if (kind == Kind::line) return c[1];
    return c[1] + s * (2 * c[2] + s * 3 * c[3]);
}

CurvePiece::Hit CurvePiece::hit(Vec3 d) const {
    if (kind == Kind::line) return {outward(c[1]), c[0]};
    if (kind == Kind::arc) {
        const double offset = across(d, c[0]); // the ray leaves the circle at its second crossing
        const double along = std::sqrt(std::max((radius - offset) * (radius + offset), 0.0));
        const Vec3 normal = along * d - offset * Vec3{-d.y, d.x, 0};
        return {normal, c[0] + normal};
    }
    const double s = cubic_crossing(c, d);
    return {outward(derivative(s)), at(s)};
}

CurvePiece line_piece(Vec3 from, Vec3 to) { return {.c = {from, to - from}}; }

CurvePiece arc_piece(Vec3 middle, double radius, double start, double sweep) {
    return {.kind = CurvePiece::Kind::arc, .c = {middle}, .radius = radius, .start = start, .sweep = sweep};
}

struct PiecewiseCurve::Centred {
    std::vector<CurvePiece> pieces;
    Measures measures;

    Centred(std::vector<CurvePiece> of, Vec3 origin) : pieces(std::move(of)) {
        const Moments outer = moments_of(pieces);
        GASPARD_CHECK(outer.area > 0);
        const Vec3 shift = 1 / outer.area * outer.first;
        for (CurvePiece& piece : pieces) piece.c[0] = piece.c[0] - shift;
        const Moments own = moments_of(pieces);
        measures = {
            .area = own.area,
            .centre = origin + shift,
            .covariance = {own.second.xx / own.area, own.second.xy / own.area, own.second.yy / own.area},
            .box = box_of(pieces, origin + shift)};
    }
};

PiecewiseCurve::PiecewiseCurve(std::vector<CurvePiece> pieces, Vec3 origin)
    : PiecewiseCurve(Centred(std::move(pieces), origin)) {}

PiecewiseCurve::PiecewiseCurve(Centred centred)
    : ConvexCurve(centred.measures), pieces_(std::move(centred.pieces)),
      length_([pieces = pieces_](double u) { return speed_of(pieces, u); }, whole_numbers(pieces_.size())) {
    for (const CurvePiece& piece : pieces_) angles_.push_back(std::atan2(piece.at(0).y, piece.at(0).x));
    const auto least = std::min_element(angles_.begin(), angles_.end());
    first_ = static_cast<std::size_t>(least - angles_.begin());
    std::rotate(angles_.begin(), least, angles_.end());
}

PiecewiseCurve::Place PiecewiseCurve::place(double t) const {
    const double u = length_.parameter((t - std::floor(t)) * length_.total());
    const std::size_t i = std::min(static_cast<std::size_t>(u), pieces_.size() - 1);
    return {i, u - static_cast<double>(i)};
}

Vec3 PiecewiseCurve::point(double t) const {
    const auto [piece, s] = place(t);
    return centre() + pieces_[piece].at(s);
}

Vec3 PiecewiseCurve::tangent(double t) const {
    const auto [piece, s] = place(t);
    const Vec3 direction = pieces_[piece].derivative(s);
    return length_.total() / norm(direction) * direction;
}

ConvexCurve::Gauge PiecewiseCurve::gauge(Vec3 p) const {
    const Vec3 q{p.x - centre().x, p.y - centre().y, 0};
    const double distance = std::sqrt(q.x * q.x + q.y * q.y);
    const Vec3 d = distance > 0 ? 1 / distance * q : Vec3{1, 0, 0};
    const auto above = std::upper_bound(angles_.begin(), angles_.end(), std::atan2(d.y, d.x));
    const auto before = static_cast<std::size_t>(above - angles_.begin()) + pieces_.size() - 1;
    const auto [normal, at] = pieces_[(first_ + before) % pieces_.size()].hit(d);
    const Vec3 gradient = 1 / dot(normal, at) * normal;
    return {dot(gradient, q), gradient};
}

} // namespace gaspard
