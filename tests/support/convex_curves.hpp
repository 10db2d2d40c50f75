// Curves of each kind, and points of lists.
#pragma once

#include "core/transport/convex_curve.hpp"

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <vector>

namespace gaspard {

inline Points listed_points(std::initializer_list<Vec3> list) {
    Points points(list.size());
    std::size_t i = 0;
    for (const Vec3 p : list) points.set(i++, p);
    return points;
}

/// Points of an ellipse with semi-axes 3 and 2 about (5, -1), at unequal distances.
inline Points uneven_points(std::size_t n) {
    Points points(n);
    for (std::size_t k = 0; k < n; ++k) {
        const double part =
            (static_cast<double>(k) + 0.2 * static_cast<double>(k % 2)) / static_cast<double>(n);
        const double angle = 2 * std::numbers::pi * part;
        points.set(k, {5 + 3 * std::cos(angle), -1 + 2 * std::sin(angle), 0});
    }
    return points;
}

inline Points square_corners(double side = 1) {
    return listed_points({{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}});
}

struct NamedCurve {
    std::string name;
    std::shared_ptr<const ConvexCurve> curve;
};

inline std::vector<NamedCurve> all_curves() {
    return {{"disk", ellipse({}, 1, 1)},
            {"ellipse", ellipse({1, 2, 0}, 2, 1, 30)},
            {"long ellipse", ellipse({}, 5, 1, -70)},
            {"rounded rectangle", rounded_rectangle({0.5, 0, 0}, 2, 1, 8, 15)},
            {"odd exponent", rounded_rectangle({}, 1, 1, 2.7)},
            {"spline", closed_spline(uneven_points(12))},
            {"square", rounded_polygon(square_corners(), 0.1)},
            {"triangle", rounded_polygon(listed_points({{0, 0, 0}, {2, 0, 0}, {0.5, 1, 0}}), 0.1)},
            {"small", rounded_polygon(square_corners(2e-6), 1e-7)},
            {"large", rounded_rectangle({-1e6, 1e6, 0}, 1e6, 1e6, 20)}};
}

} // namespace gaspard
