#include "core/fem/ellipticity.hpp"

#include "core/base/check.hpp"
#include "core/base/eigenvalues.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gaspard {

namespace {

constexpr std::size_t lanes = 8; // independent minima and maxima, so that the loop vectorises

struct Extremes {
    std::array<double, lanes> convexity, slowest, fastest;

    Extremes() : convexity(), slowest(), fastest() {
        convexity.fill(std::numeric_limits<double>::infinity());
        slowest.fill(std::numeric_limits<double>::infinity());
        fastest.fill(-std::numeric_limits<double>::infinity());
    }
    void look(std::size_t lane, double m, double xx, double yy, double xy) {
        const auto [low, high] = symmetric_eigenvalues(1 + xx, xy, 1 + yy);
        convexity[lane] = low < convexity[lane] ? low : convexity[lane];
        slowest[lane] = m * low < slowest[lane] ? m * low : slowest[lane];
        fastest[lane] = m * high > fastest[lane] ? m * high : fastest[lane];
    }
};

} // namespace

Ellipticity ellipticity(const LineGrid& grid, std::span<const double> monitor, const WeakHessian& sigma) {
    const std::size_t n = grid.size(2), v = grid.vertices(), side = grid.cells + 1;
    GASPARD_CHECK(monitor.size() == side * side && sigma.xx.size() == n * n);
    Extremes extremes;
    for (std::size_t j = 0; j < v; ++j) {
        const double* m = monitor.data() + j * side;
        const double* xx = sigma.xx.data() + 2 * j * n;
        const double* yy = sigma.yy.data() + 2 * j * n;
        const double* xy = sigma.xy.data() + 2 * j * n;
        std::size_t i = 0;
        for (; i + lanes <= v; i += lanes)
            for (std::size_t l = 0; l < lanes; ++l)
                extremes.look(l, m[i + l], xx[2 * (i + l)], yy[2 * (i + l)], xy[2 * (i + l)]);
        for (; i < v; ++i) extremes.look(0, m[i], xx[2 * i], yy[2 * i], xy[2 * i]);
    }
    return {.convexity = *std::min_element(extremes.convexity.begin(), extremes.convexity.end()),
            .slowest = *std::min_element(extremes.slowest.begin(), extremes.slowest.end()),
            .fastest = *std::max_element(extremes.fastest.begin(), extremes.fastest.end())};
}

} // namespace gaspard
