// Exact equidistribution of a density on an interval: its integral, piecewise in Chebyshev polynomials, is
// inverted.
#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_number.hpp"
#include "core/layer/interval_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr std::size_t degree = 8;
using Samples = std::array<double, degree + 1>; ///< at Chebyshev's points, from the right end to the left

/// A part of the interval, on which rho is a polynomial. Positions are measured from the nearer end of the
/// interval, where layers are thin.
struct Panel {
    double left, width;
    std::array<double, degree + 2> integral; ///< Chebyshev series of the integral from the left end
    double total = 0;
};

/// The integral from the left end to s in [-1, 1].
double evaluate(const Panel& panel, double s) {
    double b1 = 0, b2 = 0;
    for (std::size_t k = panel.integral.size(); k-- > 1;) {
        const double b0 = panel.integral[k] + 2 * s * b1 - b2;
        b2 = b1, b1 = b0;
    }
    return panel.integral[0] + s * b1 - b2;
}

Samples coefficients_of(const Samples& rho, std::size_t n) {
    Samples c{};
    const std::size_t stride = degree / n;
    for (std::size_t k = 0; k <= n; ++k) {
        double sum = 0;
        for (std::size_t j = 0; j <= n; ++j) {
            const double half = j == 0 || j == n ? 0.5 : 1.0;
            sum += half * rho[j * stride] *
                   std::cos(std::numbers::pi * static_cast<double>(j * k) / static_cast<double>(n));
        }
        c[k] = sum * (k == 0 || k == n ? 1.0 : 2.0) / static_cast<double>(n);
    }
    return c;
}

/// The integral over [-1, 1] of a Chebyshev series.
double integral_of(const Samples& c) {
    double sum = 0;
    for (std::size_t k = 0; k <= degree; k += 2) sum += 2 * c[k] / (1 - static_cast<double>(k * k));
    return sum;
}

class Integral {
  public:
    Integral(const Monitor& rho, Interval interval) : rho_(rho), interval_(interval) {
        // Panels that halve towards both ends, down to the spacing of numbers: no layer is thinner.
        const double half = 0.5 * (interval.b - interval.a);
        std::vector<double> widths;
        for (double w = 0.5; w > 0x1p-50; w *= 0.5) widths.push_back(w * half);
        widths.push_back(widths.back());
        double at = interval.a;
        for (auto w = widths.rbegin(); w != widths.rend(); ++w) add(at, *w), at += *w;
        at = interval.a + half;
        for (const double w : widths) add(at, w), at += w;
        for (const Panel& panel : panels_) total_ += panel.total;
    }

    std::vector<double> divided(int cells) const {
        std::vector<double> x(static_cast<std::size_t>(cells) + 1, interval_.a);
        x.back() = interval_.b;
        std::size_t p = 0;
        double before = 0;
        for (int i = 1; i < cells; ++i) {
            const double wanted = total_ * i / cells;
            while (p + 1 < panels_.size() && before + panels_[p].total < wanted) before += panels_[p++].total;
            x[static_cast<std::size_t>(i)] = position(panels_[p], wanted - before);
        }
        return x;
    }

  private:
    Samples samples(double left, double width) const {
        Points at(degree + 1);
        for (std::size_t j = 0; j <= degree; ++j) {
            const double s = std::cos(std::numbers::pi * static_cast<double>(j) / degree);
            at.x[j] = std::clamp(left + 0.5 * width * (1 + s), interval_.a, interval_.b);
        }
        Samples rho{};
        rho_.values(at, rho);
        for (std::size_t j = 0; j <= degree; ++j)
            if (!(rho[j] > 0) || !std::isfinite(rho[j]))
                throw InputError("the density of the mesh must be positive and finite, but is " +
                                 exact_number(rho[j]) + " at " + exact_number(at.x[j]));
        return rho;
    }
    void add(double left, double width, int depth = 0) {
        constexpr int deepest = 40;
        constexpr double tolerance = 1e-13;
        const Samples rho = samples(left, width), fine = coefficients_of(rho, degree);
        const double total = integral_of(fine), coarse = integral_of(coefficients_of(rho, degree / 2));
        if (depth < deepest && left + 0.5 * width > left && std::abs(total - coarse) > tolerance * total) {
            add(left, 0.5 * width, depth + 1);
            add(left + 0.5 * width, 0.5 * width, depth + 1);
            return;
        }
        Panel panel{left, width, {}, 0.5 * width * total};
        const auto c = [&](std::size_t k) { return k <= degree ? fine[k] : 0.0; };
        for (std::size_t k = 1; k < panel.integral.size(); ++k)
            panel.integral[k] =
                0.5 * width * ((k == 1 ? 2 : 1) * c(k - 1) - c(k + 1)) / (2 * static_cast<double>(k));
        double at_left = 0;
        for (std::size_t k = 1; k < panel.integral.size(); ++k)
            at_left += k % 2 == 0 ? panel.integral[k] : -panel.integral[k];
        panel.integral[0] = -at_left;
        panels_.push_back(panel);
    }
    /// Where the integral from the panel's left end is `wanted`: bisection, as the integral grows.
    static double position(const Panel& panel, double wanted) {
        double low = -1, high = 1;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (evaluate(panel, middle) < wanted ? low : high) = middle;
        }
        return panel.left + 0.5 * panel.width * (1 + 0.5 * (low + high));
    }

    const Monitor& rho_;
    Interval interval_;
    std::vector<Panel> panels_;
    double total_ = 0;
};

} // namespace

std::vector<double> equidistributed_interval(const Monitor& rho, Interval interval, int cells) {
    return Integral(rho, interval).divided(cells);
}

} // namespace gaspard
