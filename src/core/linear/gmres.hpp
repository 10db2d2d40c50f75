// GMRES(m) with right preconditioning (Saad, Schultz, 1986):
//
//   minimise |b - A P^-1 y|_2 over Krylov spaces of dimension <= m, then restart;     x = P^-1 y
//
// The residual norm is that of the unpreconditioned residual.
#pragma once

#include "core/linear/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace gaspard {

class Gmres {
  public:
    /// `size` unknowns; restarts after `memory` iterations.
    Gmres(std::size_t size, std::size_t memory);

    struct Limits {
        double tolerance = 1e-6; ///< of the residual norm, relative to |b|
        int iterations = 200;    ///< maximum number of applications of A
    };
    struct Result {
        int iterations = 0;
        double residual = 0; ///< norm from the recurrence, relative to |b|
        bool converged = false;
    };
    /// Solves A x = b from x = 0 and overwrites x. apply(v, out) computes out = A v; precondition(v, out)
    /// computes out = P^-1 v and must be a fixed linear map. Does not allocate. Ends early when a stop is
    /// requested or a number is not finite.
    template <class Apply, class Precondition>
    Result solve(const Apply& apply, const Precondition& precondition, std::span<const double> b,
                 std::span<double> x, Limits limits, std::stop_token stop = {});

  private:
    std::span<double> basis(std::size_t k) { return {basis_.data() + k * size_, size_}; }
    void begin(double norm);
    double orthogonalise(std::size_t k);
    bool advance(std::size_t k);
    void combine(std::size_t columns);

    std::size_t size_, memory_;
    std::vector<double> basis_;      ///< memory + 1 vectors
    std::vector<double> hessenberg_; ///< triangular after Givens rotations; columns of memory + 1
    std::vector<double> cosine_, sine_, g_, y_;
    std::vector<double> preconditioned_, sum_;
};

template <class Apply, class Precondition>
Gmres::Result Gmres::solve(const Apply& apply, const Precondition& precondition, std::span<const double> b,
                           std::span<double> x, Limits limits, std::stop_token stop) {
    Result result;
    std::fill(x.begin(), x.end(), 0.0);
    const double all = std::sqrt(dot(b, b));
    if (all == 0) return {0, 0, true};
    std::copy(b.begin(), b.end(), basis(0).begin());
    for (double norm = all;;) {
        begin(norm);
        std::size_t k = 0;
        bool exhausted = false;
        while (k < memory_ && !exhausted && result.iterations < limits.iterations && !stop.stop_requested()) {
            precondition(std::span<const double>(basis(k)), std::span<double>(preconditioned_));
            apply(std::span<const double>(preconditioned_), basis(k + 1));
            exhausted = !advance(k);
            ++k, ++result.iterations;
            norm = std::abs(g_[k]);
            if (!(norm > limits.tolerance * all)) break; // also if NaN
        }
        combine(k);
        precondition(std::span<const double>(sum_), std::span<double>(preconditioned_));
        for (std::size_t i = 0; i < size_; ++i) x[i] += preconditioned_[i];
        result.residual = norm / all;
        result.converged = norm <= limits.tolerance * all;
        if (result.converged || !std::isfinite(norm) || exhausted || stop.stop_requested() ||
            result.iterations >= limits.iterations)
            return result;
        apply(std::span<const double>(x), basis(0));
        for (std::size_t i = 0; i < size_; ++i) basis_[i] = b[i] - basis_[i];
        norm = std::sqrt(dot(basis(0), basis(0)));
    }
}

} // namespace gaspard
