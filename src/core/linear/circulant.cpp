#include "core/linear/circulant.hpp"

#include "core/base/check.hpp"
#include "core/linear/transpose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr std::size_t lines = BatchFft::lanes;

std::size_t up_to_multiple(std::size_t count, std::size_t of) { return (count + of - 1) / of * of; }

} // namespace

CirculantTransform::CirculantTransform(std::size_t n)
    : n_(n), columns_(up_to_multiple(n / 2 + 1, lines)), rows_(up_to_multiple(n, 2 * lines)), fft_(n),
      real_(columns_ * rows_), imaginary_(columns_ * rows_), batch_(2 * lines * n), scratch_(2 * lines * n) {}

std::vector<double> CirculantTransform::factors(const std::function<double(double, double)>& symbol) const {
    const double unit = 2 * std::numbers::pi / static_cast<double>(n_),
                 scale = 1 / static_cast<double>(n_ * n_);
    std::vector<double> values(columns_ * n_);
    for (std::size_t first = 0; first < columns_; first += lines)
        for (std::size_t l = 0; l < n_; ++l)
            for (std::size_t lane = 0; lane < lines && first + lane <= n_ / 2; ++lane)
                values[first * n_ + l * lines + lane] =
                    scale * symbol(unit * static_cast<double>(first + lane), unit * static_cast<double>(l));
    return values;
}

void CirculantTransform::apply(std::span<const double> factors, std::span<const double> in,
                               std::span<double> out) {
    GASPARD_CHECK(factors.size() == columns_ * n_ && in.size() == n_ * n_ && out.size() == n_ * n_);
    analyse_rows(in.data());
    multiply_columns(factors.data());
    synthesise_rows(out.data());
}

// Rows a and b are one sequence z = a + i b. Its transform Z is split: A_k = (Z_k + conj Z_(n-k)) / 2,
// B_k = (Z_k - conj Z_(n-k)) / (2 i).
void CirculantTransform::analyse_rows(const double* in) {
    for (std::size_t row = 0; row < n_; row += 2 * lines) {
        for (std::size_t part = 0; part < 2; ++part) {
            const std::size_t first = row + part * lines,
                              count = first < n_ ? std::min(lines, n_ - first) : 0;
            double* to = batch_.data() + part * lines;
            if (count < lines)
                for (std::size_t i = 0; i < n_; ++i) std::fill_n(to + i * 2 * lines, lines, 0.0);
            if (count > 0) transpose(in + first * n_, n_, to, 2 * lines, count, n_);
        }
        const double* z = fft_.forward(batch_.data(), scratch_.data());
        for (std::size_t k = 0; k <= n_ / 2; ++k) {
            const double* p = z + k * 2 * lines;
            const double* q = z + (n_ - k) % n_ * 2 * lines;
            double* re = real_.data() + k * rows_ + row;
            double* im = imaginary_.data() + k * rows_ + row;
            for (std::size_t l = 0; l < lines; ++l) {
                re[l] = 0.5 * (p[l] + q[l]);
                im[l] = 0.5 * (p[lines + l] - q[lines + l]);
                re[lines + l] = 0.5 * (p[lines + l] + q[lines + l]);
                im[lines + l] = 0.5 * (q[l] - p[l]);
            }
        }
    }
}

void CirculantTransform::multiply_columns(const double* factors) {
    for (std::size_t first = 0; first < columns_; first += lines) {
        double* re = real_.data() + first * rows_;
        double* im = imaginary_.data() + first * rows_;
        transpose(re, rows_, batch_.data(), 2 * lines, lines, n_);
        transpose(im, rows_, batch_.data() + lines, 2 * lines, lines, n_);
        double* z = fft_.forward(batch_.data(), scratch_.data());
        const double* factor = factors + first * n_;
        for (std::size_t j = 0; j < n_; ++j, factor += lines)
            for (std::size_t l = 0; l < lines; ++l) {
                z[j * 2 * lines + l] *= factor[l];
                z[j * 2 * lines + lines + l] *= factor[l];
            }
        z = fft_.backward(z, z == batch_.data() ? scratch_.data() : batch_.data());
        transpose(z, 2 * lines, re, rows_, n_, lines);
        transpose(z + lines, 2 * lines, im, rows_, n_, lines);
    }
}

// The inverse of analyse_rows: Z_k = A_k + i B_k, Z_(n-k) = conj A_k + i conj B_k.
void CirculantTransform::synthesise_rows(double* out) {
    for (std::size_t row = 0; row < n_; row += 2 * lines) {
        for (std::size_t k = 0; k <= n_ / 2; ++k) {
            const double* re = real_.data() + k * rows_ + row;
            const double* im = imaginary_.data() + k * rows_ + row;
            double* p = batch_.data() + k * 2 * lines;
            double* q = batch_.data() + (n_ - k) % n_ * 2 * lines;
            for (std::size_t l = 0; l < lines; ++l) {
                const double ar = re[l], ai = im[l], br = re[lines + l], bi = im[lines + l];
                q[l] = ar + bi;
                q[lines + l] = br - ai;
                p[l] = ar - bi; // last: where k = n - k, Z_k is this, and bi = ai = 0 but for rounding
                p[lines + l] = br + ai;
            }
        }
        const double* z = fft_.backward(batch_.data(), scratch_.data());
        for (std::size_t part = 0; part < 2; ++part) {
            const std::size_t first = row + part * lines;
            if (first < n_)
                transpose(z + part * lines, 2 * lines, out + first * n_, n_, n_, std::min(lines, n_ - first));
        }
    }
}

} // namespace gaspard
