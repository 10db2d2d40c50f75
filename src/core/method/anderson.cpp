#include "core/method/anderson.hpp"

#include "core/base/check.hpp"
#include "core/linear/reduce.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

Anderson::Anderson(std::size_t size, std::size_t memory)
    : size_(size), memory_(memory), dphi_(memory, std::vector<double>(size)), du_(dphi_), phi_(size),
      u_(size), r_(size), gram_(memory * memory), projection_(memory), factor_(memory * memory),
      gamma_(memory) {
    GASPARD_CHECK(memory >= 1);
}

// Stores the difference to the previous iterate. The new entries of the Gram matrix are the changes of the
// projections:
//
//   (du_j, u - u_before) = (du_j, u) - (du_j, u_before)
void Anderson::remember(std::span<const double> phi, std::span<const double> u, std::span<const double> r) {
    std::size_t newest = memory_;
    if (begun_) {
        newest = (oldest_ + count_) % memory_;
        if (count_ == memory_)
            oldest_ = (oldest_ + 1) % memory_;
        else
            ++count_;
        double* __restrict dphi = dphi_[newest].data();
        double* __restrict du = du_[newest].data();
        for (std::size_t i = 0; i < size_; ++i) dphi[i] = phi[i] - phi_[i], du[i] = u[i] - u_[i];
        projection_[newest] = dot(du_[newest], r_);
    }
    for (std::size_t k = 0; k < count_; ++k) {
        const std::size_t slot = (oldest_ + k) % memory_;
        const double before = projection_[slot];
        projection_[slot] = dot(du_[slot], r);
        gram_[newest * memory_ + slot] = gram_[slot * memory_ + newest] = projection_[slot] - before;
    }
    std::copy(phi.begin(), phi.end(), phi_.begin());
    std::copy(u.begin(), u.end(), u_.begin());
    std::copy(r.begin(), r.end(), r_.begin());
    begun_ = true;
}

// Solves gram gamma = projection by Cholesky factorisation, from the newest difference to the oldest.
// Differences that are nearly linearly dependent on newer ones (relative pivot at most 1e-13) are dropped,
// because their pivots are mostly rounding errors.
void Anderson::solve() {
    constexpr double least_pivot = 1e-13; // relative to the diagonal entry
    const std::size_t n = count_;
    const auto slot = [&](std::size_t k) { return (oldest_ + n - 1 - k) % memory_; };
    const auto factor = [&](std::size_t i, std::size_t j) -> double& { return factor_[i * memory_ + j]; };
    for (std::size_t j = 0; j < n; ++j) {
        const double own = gram_[slot(j) * memory_ + slot(j)];
        double pivot = own;
        for (std::size_t k = 0; k < j; ++k) pivot -= factor(j, k) * factor(j, k);
        const bool useful = own > 0 && pivot > least_pivot * own;
        factor(j, j) = useful ? std::sqrt(pivot) : 0.0;
        for (std::size_t i = j + 1; i < n; ++i) {
            double entry = gram_[slot(i) * memory_ + slot(j)];
            for (std::size_t k = 0; k < j; ++k) entry -= factor(i, k) * factor(j, k);
            factor(i, j) = useful ? entry / factor(j, j) : 0.0;
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        double value = projection_[slot(i)];
        for (std::size_t k = 0; k < i; ++k) value -= factor(i, k) * gamma_[slot(k)];
        gamma_[slot(i)] = factor(i, i) > 0 ? value / factor(i, i) : 0.0;
    }
    for (std::size_t i = n; i-- > 0;) {
        double value = gamma_[slot(i)];
        for (std::size_t k = i + 1; k < n; ++k) value -= factor(k, i) * gamma_[slot(k)];
        gamma_[slot(i)] = factor(i, i) > 0 ? value / factor(i, i) : 0.0;
    }
}

void Anderson::propose(std::span<const double> phi, std::span<const double> u, std::span<const double> r,
                       double beta, std::span<double> next) {
    GASPARD_CHECK(phi.size() == size_ && u.size() == size_ && r.size() == size_ && next.size() == size_);
    remember(phi, u, r);
    solve();
    constexpr std::size_t chunk = 512; // unknowns per block, so that `next` stays in the L1 cache
    for (std::size_t begin = 0; begin < size_; begin += chunk) {
        const std::size_t end = std::min(size_, begin + chunk);
        double* __restrict to = next.data();
        for (std::size_t i = begin; i < end; ++i) to[i] = phi[i] + beta * u[i];
        for (std::size_t k = 0; k < count_; ++k) {
            const double gamma = gamma_[k];
            const double *dphi = dphi_[k].data(), *du = du_[k].data();
            for (std::size_t i = begin; i < end; ++i) to[i] -= gamma * (dphi[i] + beta * du[i]);
        }
    }
}

} // namespace gaspard
