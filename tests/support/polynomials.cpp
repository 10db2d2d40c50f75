#include "support/polynomials.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace gaspard::slow {

namespace {

/// P_n and its derivative at x in ]-1, 1[: (k + 1) P_k+1 = (2 k + 1) x P_k - k P_k-1.
std::pair<long double, long double> legendre(int n, long double x) {
    long double before = 1, now = x;
    for (int k = 1; k < n; ++k) before = std::exchange(now, ((2 * k + 1) * x * now - k * before) / (k + 1));
    return {now, n * (x * now - before) / (x * x - 1)};
}

} // namespace

Rule gauss(int count) {
    Rule rule;
    for (int i = count - 1; i >= 0; --i) {
        long double x = std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (count + 0.5L));
        for (int step = 0; step < 10; ++step) { // Newton; the start is good to two digits
            const auto [value, slope] = legendre(count, x);
            x -= value / slope;
        }
        const long double slope = legendre(count, x).second;
        rule.points.push_back(static_cast<double>((1 + x) / 2));
        rule.weights.push_back(static_cast<double>(1 / ((1 - x * x) * slope * slope)));
    }
    return rule;
}

} // namespace gaspard::slow
