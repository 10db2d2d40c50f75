// Meshes of an interval that are given by formulas: Bakhvalov's and Shishkin's.
#include "core/base/error.hpp"
#include "core/layer/interval_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

static void check_layer(const LayerShape& layer) {
    if (!(layer.eps > 0) || !std::isfinite(layer.eps)) throw InputError("eps must be positive");
    if (!(layer.beta > 0) || !(layer.sigma > 0)) throw InputError("beta and sigma must be positive");
    if (!(layer.q > 0 && layer.q < 1)) throw InputError("q must be between 0 and 1");
}

/// The root of f in (low, high), f(low) < 0 < f(high), by bisection to neighbouring numbers.
template <class F>
static double root(double low, double high, const F& f) {
    for (;;) {
        const double middle = low + 0.5 * (high - low);
        if (!(low < middle && middle < high)) return low;
        (f(middle) < 0 ? low : high) = middle;
    }
}

BakhvalovMesh bakhvalov_mesh(const LayerShape& layer, Interval interval, int cells) {
    check_layer(layer);
    const double length = interval.b - interval.a, q = layer.q;
    const double scale =
        layer.sigma * layer.eps / layer.beta; // chi = -scale ln(1 - t/q), chi' = scale / (q - t)
    // With s = 1 - t/q in (0, 1): -scale ln s + scale (1 - q + q s) / (q s) = length. The left side falls
    // with s; solved for ln s, so that it is exact also where t is next to q.
    const auto missing = [&](double log_s) { // < 0 for s above the root
        const double s = std::exp(log_s);
        return scale * (-log_s + (1 - q + q * s) / (q * s)) - length;
    };
    BakhvalovMesh mesh{.x = uniform_interval(interval, cells)};
    if (missing(0) >= 0) return mesh; // scale / q >= length: the layer is as wide as the interval
    const double log_s = root(-745, 0, [&](double t) { return -missing(t); }), s = std::exp(log_s);
    mesh.tau = q * (1 - s);
    mesh.transition = interval.a - scale * log_s;
    for (int i = 1; i < cells; ++i) {
        const double t = static_cast<double>(i) / cells;
        const double away =
            t <= mesh.tau ? -scale * std::log1p(-t / q) : -scale * log_s + (t - mesh.tau) * scale / (q * s);
        mesh.x[static_cast<std::size_t>(i)] = interval.a + std::min(away, length);
    }
    return mesh;
}

std::vector<double> shishkin_mesh(const LayerShape& layer, Interval interval, int cells) {
    check_layer(layer);
    const int fine = static_cast<int>(std::lround(layer.q * cells));
    if (fine < 1 || fine >= cells)
        throw InputError("a Shishkin mesh of " + std::to_string(cells) +
                         " cells has no cell on one side of its transition point; change q or the number of "
                         "cells");
    const double length = interval.b - interval.a;
    const double width = std::min(layer.q * length, layer.sigma * layer.eps / layer.beta * std::log(cells));
    std::vector<double> x(static_cast<std::size_t>(cells) + 1);
    for (int i = 0; i <= cells; ++i)
        x[static_cast<std::size_t>(i)] =
            interval.a +
            (i <= fine ? width * i / fine : width + (length - width) * (i - fine) / (cells - fine));
    x.back() = interval.b;
    return x;
}

} // namespace gaspard
