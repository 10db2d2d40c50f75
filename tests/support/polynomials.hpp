// Polynomials, a quadrature rule and random numbers for the reference computations.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

namespace gaspard::slow {

using Polynomial = std::vector<long double>; ///< coefficients of 1, s, s^2, ...

inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial result(a.size() + b.size() - 1, 0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
    return result;
}

inline Polynomial derivative(const Polynomial& p) {
    Polynomial result;
    for (std::size_t i = 1; i < p.size(); ++i) result.push_back(static_cast<long double>(i) * p[i]);
    return result;
}

/// Over [0,1].
inline long double integral(const Polynomial& p) {
    long double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p[i] / static_cast<long double>(i + 1);
    return sum;
}

inline double evaluate(const Polynomial& p, double s) {
    long double sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * s + p[i];
    return static_cast<double>(sum);
}

/// 1 at node / degree, 0 at the other multiples of 1 / degree.
inline Polynomial lagrange(int degree, int node) {
    Polynomial p{1};
    for (int other = 0; other <= degree; ++other)
        if (other != node) {
            const long double gap = static_cast<long double>(node - other) / degree;
            p = p * Polynomial{-(static_cast<long double>(other) / degree) / gap, 1 / gap};
        }
    return p;
}

struct Rule {
    std::vector<double> points, weights;
};

/// Gauss-Legendre on [0,1], exact for polynomials of degree 2 count - 1.
Rule gauss(int count);

/// `count` deterministic pseudo-random numbers between low and high.
inline std::vector<double> random_values(std::size_t count, double low, double high, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> distribution(low, high);
    std::vector<double> values(count);
    for (double& value : values) value = distribution(random);
    return values;
}

} // namespace gaspard::slow
