#include "core/linear/line_spectrum.hpp"

#include "core/base/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <kissfft/kissfft.hh>
#include <numbers>

namespace gaspard {

// A plan of kissfft has scratch of its own (for radices above 5), which is why it belongs to the caller's
// room.
struct LineSpectrum::Room::Plans {
    explicit Plans(std::size_t n) : forward(n, false), backward(n, true) {}
    kissfft<double> forward, backward;
};

namespace {

struct Pencil { ///< symbols of the stiffness and mass matrices at one frequency: vertex, coupling, middle
    double k11, k12, k22, m11, m12, m22;
};

Pencil symbols(double h, double phase) {
    const double c = std::cos(phase), half = std::cos(phase / 2);
    return {(14 + 2 * c) / (3 * h), -16 * half / (3 * h), 16 / (3 * h),
            (8 - 2 * c) * h / 30,   4 * half * h / 30,    16 * h / 30};
}

struct Branch {
    double eigenvalue, vertex, middle; ///< of unit mass per cell
};

// Both solutions of (K - lambda M)(a, b) = 0, the smaller eigenvalue first.
std::array<Branch, 2> solve(const Pencil& p) {
    const double a = p.m11 * p.m22 - p.m12 * p.m12;
    const double b = p.k11 * p.m22 + p.k22 * p.m11 - 2 * p.k12 * p.m12;
    const double c = p.k11 * p.k22 - p.k12 * p.k12;
    const double larger = (b + std::sqrt(std::max(0.0, b * b - 4 * a * c))) / (2 * a);
    std::array<Branch, 2> branches;
    for (const int i : {0, 1}) {
        const double lambda =
            i == 0 ? c / (a * larger) : larger; // the product of the roots is c / a: no cancellation
        // The second row is never zero for the smaller root, the first never for the larger.
        double vertex = i == 0 ? p.k22 - lambda * p.m22 : p.k12 - lambda * p.m12;
        double middle = i == 0 ? lambda * p.m12 - p.k12 : lambda * p.m11 - p.k11;
        const double mass = vertex * vertex * p.m11 + 2 * vertex * middle * p.m12 + middle * middle * p.m22;
        branches[static_cast<std::size_t>(i)] = {lambda, vertex / std::sqrt(mass), middle / std::sqrt(mass)};
    }
    return branches;
}

} // namespace

LineSpectrum::LineSpectrum(std::size_t cells, bool periodic)
    : cells_(cells), ring_(periodic ? cells : 2 * cells), periodic_(periodic) {
    GASPARD_CHECK(cells >= 2);
    const double h = 1.0 / static_cast<double>(cells);
    const double count = static_cast<double>(ring_);
    for (std::size_t k = 0; 2 * k <= ring_; ++k) {
        const double phase = 2 * std::numbers::pi * static_cast<double>(k) / count;
        const bool alone =
            k == 0 || 2 * k == ring_; // no sine partner: the mode fills the ring with mass P, not P/2
        // The even functions live on half of the ring, with half of its mass.
        const double scale = std::sqrt((alone ? 1.0 : 2.0) / count * (periodic ? 1.0 : 2.0));
        Mode mode{{0, 0}, {0, 0}, std::polar(1.0, phase / 2)};
        if (2 * k == ring_) { // vertices and middles part: (-1)^c on the ones, zero on the others
            const Pencil p = symbols(h, phase);
            mode.vertex[0] = scale / std::sqrt(p.m11);
            mode.middle[1] = scale / std::sqrt(p.m22);
            eigenvalues_.push_back(p.k11 / p.m11);
            if (periodic) eigenvalues_.push_back(p.k22 / p.m22);
        } else {
            const auto branches = solve(symbols(h, phase));
            for (std::size_t j = 0; j < 2; ++j) {
                mode.vertex[j] = scale * branches[j].vertex;
                mode.middle[j] = scale * branches[j].middle;
                const double lambda = k == 0 && j == 0 ? 0.0 : branches[j].eigenvalue;
                eigenvalues_.insert(eigenvalues_.end(), periodic && !alone ? 2 : 1, lambda);
            }
        }
        modes_.push_back(mode);
    }
    GASPARD_CHECK(eigenvalues_.size() == (periodic ? 2 * cells : 2 * cells + 1));
}

LineSpectrum::Room LineSpectrum::make_room() const {
    using Sequence = std::vector<std::complex<double>>;
    return {std::make_shared<Room::Plans>(ring_), Sequence(ring_), Sequence(ring_)};
}

void LineSpectrum::analyse(const double* b, double* c, Room& room) const {
    using Complex = std::complex<double>;
    auto& time = room.time;
    for (std::size_t i = 0; i < cells_; ++i) time[i] = {b[2 * i], b[2 * i + 1]};
    if (!periodic_) { // even continuation; the ends stand once in the line and count twice in half a ring
        for (std::size_t i = 0; i < cells_; ++i) time[ring_ - 1 - i] = {b[2 * (i + 1)], b[2 * i + 1]};
        time[0].real(2 * b[0]);
        time[cells_].real(2 * b[2 * cells_]);
    }
    room.plans->forward.transform(time.data(), room.frequency.data());
    const double half = periodic_ ? 1.0 : 0.5;
    for (std::size_t k = 0; 2 * k <= ring_; ++k) {
        const Mode& mode = modes_[k];
        const Complex z = room.frequency[k], mirror = std::conj(room.frequency[k == 0 ? 0 : ring_ - k]);
        const Complex vertex = half * 0.5 * (z + mirror);
        const Complex middle = half * Complex(0, -0.5) * (z - mirror) * std::conj(mode.half_shift);
        const bool alone = k == 0 || 2 * k == ring_;
        if (2 * k == ring_) {
            *c++ = mode.vertex[0] * vertex.real();
            if (periodic_) *c++ = -mode.middle[1] * middle.imag();
            continue;
        }
        for (int j = 0; j < 2; ++j) {
            const Complex coefficient = mode.vertex[j] * vertex + mode.middle[j] * middle;
            *c++ = coefficient.real();
            if (periodic_ && !alone) *c++ = -coefficient.imag();
        }
    }
}

void LineSpectrum::synthesise(const double* c, double* u, Room& room) const {
    using Complex = std::complex<double>;
    for (std::size_t k = 0; 2 * k <= ring_; ++k) {
        const Mode& mode = modes_[k];
        const bool alone = k == 0 || 2 * k == ring_;
        Complex vertex = 0, middle = 0;
        if (2 * k == ring_) {
            vertex = mode.vertex[0] * *c++;
            if (periodic_) middle = mode.middle[1] * *c++;
        } else {
            for (int j = 0; j < 2; ++j) {
                const double cosine = *c++;
                const Complex coefficient(cosine, periodic_ && !alone ? -*c++ : 0.0);
                vertex += mode.vertex[j] * coefficient;
                middle += mode.middle[j] * coefficient;
            }
            middle *= mode.half_shift;
            if (!alone) vertex *= 0.5, middle *= 0.5;
        }
        const Complex i(0, 1);
        room.frequency[k] = vertex + i * middle;
        if (!alone) room.frequency[ring_ - k] = std::conj(vertex) + i * std::conj(middle);
    }
    room.plans->backward.transform(room.frequency.data(), room.time.data());
    for (std::size_t i = 0; i < cells_; ++i) {
        u[2 * i] = room.time[i].real();
        u[2 * i + 1] = room.time[i].imag();
    }
    if (!periodic_) u[2 * cells_] = room.time[cells_].real();
}

} // namespace gaspard
