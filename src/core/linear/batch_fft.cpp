#include "core/linear/batch_fft.hpp"

#include "core/base/check.hpp"

#include <cmath>
#include <numbers>

namespace gaspard {

namespace {

constexpr std::size_t lanes = BatchFft::lanes;

/// Input and output of one butterfly; real and imaginary parts have the same layout. The backward transform
/// is the forward one with real and imaginary parts exchanged.
struct Place {
    const double* in_re;
    const double* in_im;
    double* out_re;
    double* out_im;
    std::size_t in_step, out_step; ///< between consecutive elements of the butterfly
};

void butterfly2(const Place& at, const double* w) {
    const double* __restrict ar = at.in_re;
    const double* __restrict ai = at.in_im;
    const double *br = ar + at.in_step, *bi = ai + at.in_step;
    double* __restrict yr = at.out_re;
    double* __restrict yi = at.out_im;
    double *zr = yr + at.out_step, *zi = yi + at.out_step;
    for (std::size_t l = 0; l < lanes; ++l) {
        const double dr = ar[l] - br[l], di = ai[l] - bi[l];
        yr[l] = ar[l] + br[l];
        yi[l] = ai[l] + bi[l];
        zr[l] = dr * w[0] - di * w[1];
        zi[l] = dr * w[1] + di * w[0];
    }
}

void butterfly3(const Place& at, const double* w) {
    static const double sine = std::sqrt(0.75);
    const double* __restrict re = at.in_re;
    const double* __restrict im = at.in_im;
    double* __restrict yr = at.out_re;
    double* __restrict yi = at.out_im;
    const std::size_t i1 = at.in_step, i2 = 2 * i1, o1 = at.out_step, o2 = 2 * o1;
    for (std::size_t l = 0; l < lanes; ++l) {
        const double sr = re[i1 + l] + re[i2 + l], si = im[i1 + l] + im[i2 + l];
        const double dr = sine * (im[i1 + l] - im[i2 + l]), di = sine * (re[i2 + l] - re[i1 + l]);
        const double mr = re[l] - 0.5 * sr, mi = im[l] - 0.5 * si;
        const double pr = mr + dr, pi = mi + di, qr = mr - dr, qi = mi - di;
        yr[l] = re[l] + sr;
        yi[l] = im[l] + si;
        yr[o1 + l] = pr * w[0] - pi * w[1];
        yi[o1 + l] = pr * w[1] + pi * w[0];
        yr[o2 + l] = qr * w[2] - qi * w[3];
        yi[o2 + l] = qr * w[3] + qi * w[2];
    }
}

void butterfly4(const Place& at, const double* w) {
    const double* __restrict re = at.in_re;
    const double* __restrict im = at.in_im;
    double* __restrict yr = at.out_re;
    double* __restrict yi = at.out_im;
    const std::size_t i1 = at.in_step, i2 = 2 * i1, i3 = 3 * i1, o1 = at.out_step, o2 = 2 * o1, o3 = 3 * o1;
    for (std::size_t l = 0; l < lanes; ++l) {
        const double ar = re[l] + re[i2 + l], ai = im[l] + im[i2 + l];
        const double br = re[l] - re[i2 + l], bi = im[l] - im[i2 + l];
        const double cr = re[i1 + l] + re[i3 + l], ci = im[i1 + l] + im[i3 + l];
        const double dr = im[i1 + l] - im[i3 + l], di = re[i3 + l] - re[i1 + l]; // times -i
        const double pr = br + dr, pi = bi + di, qr = ar - cr, qi = ai - ci, sr = br - dr, si = bi - di;
        yr[l] = ar + cr;
        yi[l] = ai + ci;
        yr[o1 + l] = pr * w[0] - pi * w[1];
        yi[o1 + l] = pr * w[1] + pi * w[0];
        yr[o2 + l] = qr * w[2] - qi * w[3];
        yi[o2 + l] = qr * w[3] + qi * w[2];
        yr[o3 + l] = sr * w[4] - si * w[5];
        yi[o3 + l] = sr * w[5] + si * w[4];
    }
}

void butterfly5(const Place& at, const double* w) {
    static const double c1 = std::cos(2 * std::numbers::pi / 5), s1 = std::sin(2 * std::numbers::pi / 5);
    static const double c2 = std::cos(4 * std::numbers::pi / 5), s2 = std::sin(4 * std::numbers::pi / 5);
    const double* __restrict re = at.in_re;
    const double* __restrict im = at.in_im;
    double* __restrict yr = at.out_re;
    double* __restrict yi = at.out_im;
    const std::size_t i1 = at.in_step, o1 = at.out_step;
    for (std::size_t l = 0; l < lanes; ++l) {
        const double ar = re[i1 + l] + re[4 * i1 + l], ai = im[i1 + l] + im[4 * i1 + l];
        const double br = re[2 * i1 + l] + re[3 * i1 + l], bi = im[2 * i1 + l] + im[3 * i1 + l];
        const double dr = im[i1 + l] - im[4 * i1 + l], di = re[4 * i1 + l] - re[i1 + l]; // times -i
        const double er = im[2 * i1 + l] - im[3 * i1 + l], ei = re[3 * i1 + l] - re[2 * i1 + l];
        const double pr = re[l] + c1 * ar + c2 * br, pi = im[l] + c1 * ai + c2 * bi;
        const double qr = re[l] + c2 * ar + c1 * br, qi = im[l] + c2 * ai + c1 * bi;
        const double fr = s1 * dr + s2 * er, fi = s1 * di + s2 * ei;
        const double gr = s2 * dr - s1 * er, gi = s2 * di - s1 * ei;
        const double y1r = pr + fr, y1i = pi + fi, y4r = pr - fr, y4i = pi - fi;
        const double y2r = qr + gr, y2i = qi + gi, y3r = qr - gr, y3i = qi - gi;
        yr[l] = re[l] + ar + br;
        yi[l] = im[l] + ai + bi;
        yr[o1 + l] = y1r * w[0] - y1i * w[1];
        yi[o1 + l] = y1r * w[1] + y1i * w[0];
        yr[2 * o1 + l] = y2r * w[2] - y2i * w[3];
        yi[2 * o1 + l] = y2r * w[3] + y2i * w[2];
        yr[3 * o1 + l] = y3r * w[4] - y3i * w[5];
        yi[3 * o1 + l] = y3r * w[5] + y3i * w[4];
        yr[4 * o1 + l] = y4r * w[6] - y4i * w[7];
        yi[4 * o1 + l] = y4r * w[7] + y4i * w[6];
    }
}

// Any radix, directly from the definition. `roots`: cosine and sine of the radix-th roots of unity.
void butterfly(const Place& at, const double* w, std::size_t radix, const double* roots) {
    for (std::size_t k = 0; k < radix; ++k) {
        double sum_re[lanes] = {}, sum_im[lanes] = {};
        for (std::size_t j = 0; j < radix; ++j) {
            const double* root = roots + 2 * (j * k % radix);
            const double* re = at.in_re + j * at.in_step;
            const double* im = at.in_im + j * at.in_step;
            for (std::size_t l = 0; l < lanes; ++l) {
                sum_re[l] += re[l] * root[0] - im[l] * root[1];
                sum_im[l] += re[l] * root[1] + im[l] * root[0];
            }
        }
        const double cosine = k == 0 ? 1 : w[2 * k - 2], sine = k == 0 ? 0 : w[2 * k - 1];
        for (std::size_t l = 0; l < lanes; ++l) {
            at.out_re[k * at.out_step + l] = sum_re[l] * cosine - sum_im[l] * sine;
            at.out_im[k * at.out_step + l] = sum_re[l] * sine + sum_im[l] * cosine;
        }
    }
}

std::size_t next_factor(std::size_t n) {
    for (const std::size_t factor : {4, 2, 3, 5})
        if (n % factor == 0) return factor;
    for (std::size_t factor = 7; factor * factor <= n; factor += 2)
        if (n % factor == 0) return factor;
    return n;
}

} // namespace

BatchFft::BatchFft(std::size_t n) : n_(n) {
    GASPARD_CHECK(n >= 1);
    const auto push_root = [](std::vector<double>& list, std::size_t power, std::size_t of) {
        const double phase =
            -2 * std::numbers::pi * static_cast<double>(power % of) / static_cast<double>(of);
        list.insert(list.end(), {std::cos(phase), std::sin(phase)});
    };
    std::size_t stride = 1;
    for (std::size_t left = n; left > 1;) {
        const std::size_t radix = next_factor(left), groups = left / radix;
        passes_.push_back({radix, groups, stride, twiddles_.size()});
        for (std::size_t j = 0; j < groups; ++j)
            for (std::size_t k = 1; k < radix; ++k) push_root(twiddles_, j * k, left);
        left = groups;
        stride *= radix;
    }
    for (const Pass& pass : passes_)
        for (std::size_t k = 0; pass.radix > 5 && k < pass.radix; ++k) push_root(roots_, k, pass.radix);
}

double* BatchFft::transform(double* data, double* scratch, std::size_t real, std::size_t imaginary) const {
    const double* roots = roots_.data();
    constexpr std::size_t element = 2 * lanes;
    for (const Pass& pass : passes_) {
        const double* w = twiddles_.data() + pass.first_twiddle;
        for (std::size_t j = 0; j < pass.groups; ++j, w += 2 * (pass.radix - 1))
            for (std::size_t q = 0; q < pass.stride; ++q) {
                const double* in = data + element * (q + pass.stride * j);
                double* out = scratch + element * (q + pass.stride * pass.radix * j);
                const Place at{in + real,
                               in + imaginary,
                               out + real,
                               out + imaginary,
                               element * pass.stride * pass.groups,
                               element * pass.stride};
                switch (pass.radix) {
                case 2:
                    butterfly2(at, w);
                    break;
                case 3:
                    butterfly3(at, w);
                    break;
                case 4:
                    butterfly4(at, w);
                    break;
                case 5:
                    butterfly5(at, w);
                    break;
                default:
                    butterfly(at, w, pass.radix, roots);
                }
            }
        if (pass.radix > 5) roots += 2 * pass.radix;
        std::swap(data, scratch);
    }
    return data;
}

} // namespace gaspard
