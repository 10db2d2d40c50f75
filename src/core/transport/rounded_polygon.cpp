// Arcs at the corners of a convex polygon, and what is left of its sides.
#include "core/base/short_number.hpp"
#include "core/transport/checks.hpp"
#include "core/transport/piecewise_curve.hpp"
#include "core/transport/polygon.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

/// A corner with the angle by which the polygon turns there; its arc of radius R begins and ends at the
/// distance R reach from it.
struct RoundedCorner {
    Vec3 at, before, after; ///< the corner; unit vectors along the sides
    double angle, reach;
};

std::vector<RoundedCorner> rounded_corners(const std::vector<Vec3>& p) {
    const std::size_t n = p.size();
    std::vector<RoundedCorner> corners;
    for (std::size_t k = 0; k < n; ++k) {
        const Vec3 in = p[k] - p[(k + n - 1) % n], out = p[(k + 1) % n] - p[k];
        const double angle = std::atan2(cross(in, out).z, dot(in, out));
        corners.push_back({p[k], 1 / norm(in) * in, 1 / norm(out) * out, angle, std::tan(angle / 2)});
    }
    return corners;
}

double side_after(const std::vector<RoundedCorner>& corners, std::size_t k) {
    return norm(corners[(k + 1) % corners.size()].at - corners[k].at);
}

/// So that the arcs at the ends of each side do not overlap.
double largest_radius(const std::vector<RoundedCorner>& corners) {
    double largest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < corners.size(); ++k)
        largest = std::min(largest, side_after(corners, k) /
                                        (corners[k].reach + corners[(k + 1) % corners.size()].reach));
    return largest;
}

/// In four digits, not above the number.
std::string rounded_down(double number) {
    const double unit = std::pow(10.0, std::floor(std::log10(number)) - 3);
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, unit * std::floor(number / unit * (1 + 1e-13)),
                                   std::chars_format::general, 4);
    return {text, end.ptr};
}

CurvePiece corner_arc(const RoundedCorner& c, double radius) {
    const Vec3 inward{-c.before.y, c.before.x, 0};
    const Vec3 middle = c.at - radius * c.reach * c.before + radius * inward;
    return arc_piece(middle, radius, std::atan2(-inward.y, -inward.x), c.angle);
}

/// From the middle of the first arc on.
std::vector<CurvePiece> rounded_pieces(const std::vector<RoundedCorner>& corners, double radius) {
    std::vector<CurvePiece> pieces;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const RoundedCorner &c = corners[k], &next = corners[(k + 1) % corners.size()];
        pieces.push_back(corner_arc(c, radius));
        const Vec3 begin = c.at + radius * c.reach * c.after,
                   end = next.at - radius * next.reach * next.before;
        if (dot(end - begin, c.after) > 1e-13 * side_after(corners, k))
            pieces.push_back(line_piece(begin, end));
    }
    CurvePiece half = pieces.front();
    half.sweep /= 2;
    pieces.push_back(half); // the first half of the arc comes last
    half.start += half.sweep;
    pieces.front() = half;
    return pieces;
}

} // namespace

std::shared_ptr<const ConvexCurve> rounded_polygon(const Points& given, double radius, double tolerance) {
    check_convex(given, tolerance, "corner");
    if (!(radius > 0) || !std::isfinite(radius))
        throw InputError("the radius of the corners must be positive, not " + exact_number(radius));
    const Vec3 origin = bounding_box(given).centre();
    std::vector<Vec3> corners;
    for (const std::size_t k : true_corners(given, tolerance)) {
        const Vec3 p = given[k] - origin;
        corners.push_back({p.x, p.y, 0});
    }
    const auto rounded = rounded_corners(corners);
    const double largest = largest_radius(rounded);
    if (radius > largest * (1 + 1e-12))
        throw InputError("the radius " + exact_number(radius) +
                         " of the corners is too large for the sides of the polygon; the largest is " +
                         rounded_down(largest));
    return std::make_shared<const PiecewiseCurve>(rounded_pieces(rounded, radius), origin);
}

} // namespace gaspard
