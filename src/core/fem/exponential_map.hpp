// The exponential map of the unit sphere, McRae et al. (4.2) with R = 1:
//
//   exp(g) xi = cos|g| xi + (sin|g| / |g|) g
//
// cos t and sin t / t are entire functions of t^2, so they are evaluated without square roots, branches or
// divisions.
#pragma once

namespace gaspard {

template <class Number>
struct CosineAndSinc {
    Number cosine, sinc;
};

/// cos t and sin t / t from t^2, for a number or an array. Absolute error: a few 1e-16 for t <= pi, 1e-11 for
/// t <= 2 pi. It grows for larger t, which convergent iterations do not reach.
template <class Number>
CosineAndSinc<Number> cosine_and_sinc(const Number& t_squared) {
    const Number u = t_squared * 0.0625; // (t / 4)^2
    Number cosine = 1 - u * (1.0 / 306);
    cosine = 1 - u * (1.0 / 240) * cosine;
    cosine = 1 - u * (1.0 / 182) * cosine;
    cosine = 1 - u * (1.0 / 132) * cosine;
    cosine = 1 - u * (1.0 / 90) * cosine;
    cosine = 1 - u * (1.0 / 56) * cosine;
    cosine = 1 - u * (1.0 / 30) * cosine;
    cosine = 1 - u * (1.0 / 12) * cosine;
    cosine = 1 - u * 0.5 * cosine;
    Number sinc = 1 - u * (1.0 / 342);
    sinc = 1 - u * (1.0 / 272) * sinc;
    sinc = 1 - u * (1.0 / 210) * sinc;
    sinc = 1 - u * (1.0 / 156) * sinc;
    sinc = 1 - u * (1.0 / 110) * sinc;
    sinc = 1 - u * (1.0 / 72) * sinc;
    sinc = 1 - u * (1.0 / 42) * sinc;
    sinc = 1 - u * (1.0 / 20) * sinc;
    sinc = 1 - u * (1.0 / 6) * sinc;
    for (int doubled = 0; doubled < 2; ++doubled) { // double the angle twice: sin 2t = 2 sin t cos t
        sinc = sinc * cosine;
        cosine = 2 * cosine * cosine - 1;
    }
    return {cosine, sinc};
}

/// The derivative of sin t / t with respect to t^2, from t^2; error 1e-15 for t <= pi. (That of cos t is
/// -sin t / (2 t).)
template <class Number>
Number sinc_slope(const Number& t_squared) {
    Number sum = 1 - t_squared * (1.0 / (26 * 29));
    for (int k = 12; k >= 1; --k) sum = 1 - t_squared * (1.0 / (2 * k * (2 * k + 3))) * sum;
    return sum * (-1.0 / 6);
}

} // namespace gaspard
