// A flow whose exact solution is known, and errors of flows.
#pragma once

#include "core/base/check.hpp"
#include "core/flow/quasi_geostrophic.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

namespace gaspard {

inline double largest_difference(std::span<const double> a, std::span<const double> b) {
    GASPARD_CHECK(a.size() == b.size());
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

/// psi = a (cos 2 pi x sin 2 pi y), an eigenfunction of the Laplacian, which U carries along unchanged.
struct Travelling {
    double amplitude = 0.02, ux = 1, uy = 0.7, factor = -(8 * std::numbers::pi * std::numbers::pi + 1);
    static constexpr double pi = std::numbers::pi;
    double psi(double x, double y, double t) const {
        return amplitude * std::cos(2 * pi * (x - ux * t)) * std::sin(2 * pi * (y - uy * t));
    }
    double q(double x, double y, double t) const { return factor * psi(x, y, t); }
    QuasiGeostrophicFlow flow(std::size_t n) const {
        QuasiGeostrophicFlow made({.cells = n, .background = {ux, uy}});
        made.set_state(continuous_state(n, nodal_values(n, [&](double x, double y) { return q(x, y, 0); })));
        return made;
    }
};

/// The L2 norm of q - f, by the rule with seven points (exact for degree 3).
inline double l2_error(const QuasiGeostrophicFlow& flow, const std::function<double(double, double)>& f) {
    const std::size_t n = flow.cells();
    const double h = 1 / static_cast<double>(n);
    constexpr double across[6] = {0, 1, 1, 0, 1, 0}, up[6] = {0, 0, 1, 0, 1, 1};
    constexpr double points[7][4] = {{1, 0, 0, 3},
                                     {0, 1, 0, 3},
                                     {0, 0, 1, 3},
                                     {.5, .5, 0, 8},
                                     {0, .5, .5, 8},
                                     {.5, 0, .5, 8},
                                     {1. / 3, 1. / 3, 1. / 3, 27}};
    double sum = 0;
    for (std::size_t i = 0; i < n * n; ++i)
        for (std::size_t triangle = 0; triangle < 2; ++triangle)
            for (const auto& point : points) {
                double x = 0, y = 0, value = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::size_t corner = 3 * triangle + k;
                    x += point[k] * h * (static_cast<double>(i % n) + across[corner]);
                    y += point[k] * h * (static_cast<double>(i / n) + up[corner]);
                    value += point[k] * flow.q()[corner * n * n + i];
                }
                const double error = value - f(x, y);
                sum += point[3] / 60 * h * h / 2 * error * error;
            }
    return std::sqrt(sum);
}

} // namespace gaspard
