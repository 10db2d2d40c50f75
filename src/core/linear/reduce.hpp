// Sums over long arrays with eight partial sums: fast, and with an order of summation that does not depend on
// the machine.
#pragma once

#include <cstddef>
#include <span>

namespace gaspard {

/// The sum of term(i) for 0 <= i < count.
template <class Term>
double sum_of(std::size_t count, const Term& term) {
    constexpr std::size_t lanes = 8;
    double partial[lanes] = {};
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        for (std::size_t l = 0; l < lanes; ++l) partial[l] += term(i + l);
    for (std::size_t l = 0; i < count; ++i, ++l) partial[l] += term(i);
    return ((partial[0] + partial[1]) + (partial[2] + partial[3])) +
           ((partial[4] + partial[5]) + (partial[6] + partial[7]));
}

inline double sum(std::span<const double> a) {
    return sum_of(a.size(), [&](std::size_t i) { return a[i]; });
}

inline double dot(std::span<const double> a, std::span<const double> b) {
    return sum_of(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

} // namespace gaspard
