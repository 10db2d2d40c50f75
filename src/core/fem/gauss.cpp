#include "core/fem/gauss.hpp"

#include "core/base/check.hpp"

#include <cmath>
#include <numbers>

namespace gaspard {

LineQuadrature gauss_legendre(int points) {
    GASPARD_CHECK(points >= 1);
    const auto n = static_cast<std::size_t>(points);
    LineQuadrature rule{std::vector<double>(n), std::vector<double>(n)};
    for (std::size_t i = 0; i < n; ++i) {
        // Newton's method for the i-th root of the Legendre polynomial, starting from Tricomi's estimate.
        double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (points + 0.5)), slope = 0;
        for (int iteration = 0; iteration < 8; ++iteration) { // converges to rounding in three or four steps
            double p = 1, previous = 0;
            for (int k = 1; k <= points; ++k) {
                const double next = ((2 * k - 1) * x * p - (k - 1) * previous) / k;
                previous = p;
                p = next;
            }
            slope = points * (x * p - previous) / (x * x - 1);
            x -= p / slope;
        }
        rule.points[n - 1 - i] = (1 + x) / 2;
        rule.weights[n - 1 - i] = 1 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

} // namespace gaspard
