#include "core/linear/line_spectrum.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

struct Pencil { ///< stiffness and mass symbols at one frequency; 1: vertices, 2: midpoints
    double k11, k12, k22, m11, m12, m22;
};

Pencil symbols(double h, double phase) {
    const double c = std::cos(phase), half = std::cos(phase / 2);
    return {(14 + 2 * c) / (3 * h), -16 * half / (3 * h), 16 / (3 * h),
            (8 - 2 * c) * h / 30,   4 * half * h / 30,    16 * h / 30};
}

struct Branch {
    double eigenvalue, vertex, middle; ///< normalised to unit mass per cell
};

// Both solutions of (K - lambda M)(a, b) = 0, smaller eigenvalue first.
std::array<Branch, 2> solve(const Pencil& p) {
    const double a = p.m11 * p.m22 - p.m12 * p.m12;
    const double b = p.k11 * p.m22 + p.k22 * p.m11 - 2 * p.k12 * p.m12;
    const double c = p.k11 * p.k22 - p.k12 * p.k12;
    const double larger = (b + std::sqrt(std::max(0.0, b * b - 4 * a * c))) / (2 * a);
    std::array<Branch, 2> branches;
    for (const int i : {0, 1}) {
        const double lambda =
            i == 0 ? c / (a * larger) : larger; // the product of the roots is c / a: no cancellation
        // The second row is never zero for the smaller root, nor the first for the larger.
        double vertex = i == 0 ? p.k22 - lambda * p.m22 : p.k12 - lambda * p.m12;
        double middle = i == 0 ? lambda * p.m12 - p.k12 : lambda * p.m11 - p.k11;
        const double mass = vertex * vertex * p.m11 + 2 * vertex * middle * p.m12 + middle * middle * p.m22;
        branches[static_cast<std::size_t>(i)] = {lambda, vertex / std::sqrt(mass), middle / std::sqrt(mass)};
    }
    return branches;
}

} // namespace

LineSpectrum::LineSpectrum(std::size_t cells, bool periodic)
    : cells_(cells), ring_(periodic ? cells : 2 * cells), periodic_(periodic), fft_(ring_) {
    GASPARD_CHECK(cells >= 2);
    const double h = 1.0 / static_cast<double>(cells);
    const double count = static_cast<double>(ring_);
    for (std::size_t k = 0; 2 * k <= ring_; ++k) {
        const double phase = 2 * std::numbers::pi * static_cast<double>(k) / count;
        const bool alone = k == 0 || 2 * k == ring_; // no sine partner: mass P over the ring, not P / 2
        // Even functions are integrated over half of the ring, which halves their mass.
        const double scale = std::sqrt((alone ? 1.0 : 2.0) / count * (periodic ? 1.0 : 2.0));
        Mode mode{};
        if (2 * k == ring_) { // decoupled: (-1)^c at the vertices or at the midpoints, 0 at the others
            const Pencil p = symbols(h, phase);
            mode.vertex[0] = scale / std::sqrt(p.m11);
            mode.middle_cosine[1] = scale / std::sqrt(p.m22);
            eigenvalues_.push_back(p.k11 / p.m11);
            if (periodic) eigenvalues_.push_back(p.k22 / p.m22);
        } else {
            const auto branches = solve(symbols(h, phase));
            for (std::size_t j = 0; j < 2; ++j) {
                // Unless self-paired, the mode is shared by the frequencies k and P - k.
                const double share = alone ? scale : 0.5 * scale;
                mode.vertex[j] = share * branches[j].vertex;
                mode.middle_cosine[j] = share * branches[j].middle * std::cos(phase / 2);
                mode.middle_sine[j] = share * branches[j].middle * std::sin(phase / 2);
                const double lambda = k == 0 && j == 0 ? 0.0 : branches[j].eigenvalue;
                eigenvalues_.insert(eigenvalues_.end(), periodic && !alone ? 2 : 1, lambda);
            }
        }
        modes_.push_back(mode);
    }
    GASPARD_CHECK(eigenvalues_.size() == (periodic ? 2 * cells : 2 * cells + 1));
}

LineSpectrum::Workspace LineSpectrum::make_workspace() const {
    const std::vector<double> batch(2 * lanes * ring_);
    return {batch, batch};
}

void LineSpectrum::analyse(const double* b, std::size_t stride, double* c, Workspace& workspace) const {
    double* time = workspace.time.data();
    const auto take = [&](std::size_t to, std::size_t from, double factor) {
        for (std::size_t l = 0; l < lanes; ++l) time[to * lanes + l] = factor * b[from * stride + l];
    };
    for (std::size_t i = 0; i < 2 * cells_; ++i) take(i, i, 1);
    if (!periodic_) { // even extension; end points count once in the line but twice in half a ring
        for (std::size_t i = 0; i < cells_; ++i) {
            take(2 * (ring_ - 1 - i), 2 * (i + 1), 1);
            take(2 * (ring_ - 1 - i) + 1, 2 * i + 1, 1);
        }
        take(0, 0, 2);
        take(2 * cells_, 2 * cells_, 2);
    }
    split(fft_.forward(time, workspace.frequency.data()), c, periodic_ ? 1.0 : 0.5);
}

// Coefficients from the transform z of (vertices + i midpoints): z_k and conj z_(P-k) are the sum and
// difference of the transform of the vertices and i times that of the midpoints.
void LineSpectrum::split(const double* frequency, double* __restrict c, double half) const {
    for (std::size_t k = 0; 2 * k <= ring_; ++k) {
        const bool alone = k == 0 || 2 * k == ring_;
        const double* z = frequency + 2 * lanes * k;
        const double* mirror = frequency + 2 * lanes * (ring_ - k);
        const auto weigh = [&](double vertex, double middle) { // a frequency without partner
            for (std::size_t l = 0; l < lanes; ++l) c[l] = half * (vertex * z[l] + middle * z[lanes + l]);
            c += lanes;
        };
        const Mode& mode = modes_[k];
        if (2 * k == ring_) {
            weigh(mode.vertex[0], 0);
            if (periodic_) weigh(0, mode.middle_cosine[1]);
            continue;
        }
        for (std::size_t j = 0; j < 2; ++j) {
            const double vertex = mode.vertex[j] * half, cosine = mode.middle_cosine[j] * half,
                         sine = mode.middle_sine[j] * half;
            if (alone) {
                weigh(mode.vertex[j], mode.middle_cosine[j]);
                continue;
            }
            const std::size_t im = lanes;
            for (std::size_t l = 0; l < lanes; ++l)
                c[l] = vertex * (z[l] + mirror[l]) + cosine * (z[im + l] + mirror[im + l]) -
                       sine * (z[l] - mirror[l]);
            c += lanes;
            if (!periodic_) continue;
            for (std::size_t l = 0; l < lanes; ++l)
                c[l] = vertex * (mirror[im + l] - z[im + l]) + cosine * (z[l] - mirror[l]) +
                       sine * (z[im + l] + mirror[im + l]);
            c += lanes;
        }
    }
}

void LineSpectrum::merge(const double* c, double* frequency) const {
    for (std::size_t k = 0; 2 * k <= ring_; ++k) {
        const Mode& mode = modes_[k];
        double* __restrict z = frequency + 2 * lanes * k;
        double* __restrict mirror = frequency + 2 * lanes * (ring_ - k);
        const std::size_t im = lanes;
        if (2 * k == ring_) {
            for (std::size_t l = 0; l < lanes; ++l) {
                z[l] = mode.vertex[0] * c[l];
                z[im + l] = periodic_ ? mode.middle_cosine[1] * c[lanes + l] : 0.0;
            }
        } else if (k == 0) {
            for (std::size_t l = 0; l < lanes; ++l) {
                z[l] = mode.vertex[0] * c[l] + mode.vertex[1] * c[lanes + l];
                z[im + l] = mode.middle_cosine[0] * c[l] + mode.middle_cosine[1] * c[lanes + l];
            }
            c += 2 * lanes;
        } else {
            const double *cosine0 = c, *cosine1 = c + (periodic_ ? 2 : 1) * lanes;
            const double *sine0 = c + lanes, *sine1 = c + 3 * lanes; // periodic only
            for (std::size_t l = 0; l < lanes; ++l) {
                const double a = cosine0[l], b = cosine1[l];
                const double s = periodic_ ? sine0[l] : 0.0, t = periodic_ ? sine1[l] : 0.0;
                const double vr = mode.vertex[0] * a + mode.vertex[1] * b;
                const double vi = -mode.vertex[0] * s - mode.vertex[1] * t;
                const double mr = mode.middle_cosine[0] * a + mode.middle_cosine[1] * b +
                                  mode.middle_sine[0] * s + mode.middle_sine[1] * t;
                const double mi = mode.middle_sine[0] * a + mode.middle_sine[1] * b -
                                  mode.middle_cosine[0] * s - mode.middle_cosine[1] * t;
                z[l] = vr - mi;
                z[im + l] = vi + mr;
                mirror[l] = vr + mi;
                mirror[im + l] = mr - vi;
            }
            c += (periodic_ ? 4 : 2) * lanes;
        }
    }
}

void LineSpectrum::synthesise(const double* c, double* u, std::size_t stride, Workspace& workspace) const {
    merge(c, workspace.frequency.data());
    const double* time = fft_.backward(workspace.frequency.data(), workspace.time.data());
    for (std::size_t i = 0; i < 2 * cells_ + (periodic_ ? 0 : 1); ++i)
        for (std::size_t l = 0; l < lanes; ++l) u[i * stride + l] = time[i * lanes + l];
}

} // namespace gaspard
