// Anderson acceleration of the fixed-point iteration phi -> phi + beta u(phi), with the differences dphi_j
// and du_j of successive iterates:
//
//   gamma = argmin | u - sum_j gamma_j du_j |
//   next  = phi + beta u - sum_j gamma_j (dphi_j + beta du_j)
//
// The norm belongs to the inner product in which u is the Riesz representative of r: (u, w) = r . w. For u
// given by <grad v, grad u> = r_v, it is the H1 inner product; evaluating it takes one dot product.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gaspard {

class Anderson {
  public:
    /// `size`: number of unknowns; `memory`: number of differences stored.
    Anderson(std::size_t size, std::size_t memory);

    /// Discards the differences, but keeps the last iterate.
    void forget_differences() { count_ = 0; }
    /// Discards everything.
    void restart() { count_ = 0, begun_ = false; }
    /// Number of stored differences.
    std::size_t count() const { return count_; }
    /// Stores the iterate phi with its u and r, and computes `next`. Allocates nothing.
    void propose(std::span<const double> phi, std::span<const double> u, std::span<const double> r,
                 double beta, std::span<double> next);

  private:
    void remember(std::span<const double> phi, std::span<const double> u, std::span<const double> r);
    void solve();

    std::size_t size_, memory_;
    std::size_t count_ = 0, oldest_ = 0;
    bool begun_ = false;
    std::vector<std::vector<double>> dphi_, du_; ///< ring buffers of differences
    std::vector<double> phi_, u_, r_;            ///< the last iterate
    std::vector<double> gram_;                   ///< (du_i, du_j), memory x memory
    std::vector<double> projection_;             ///< (du_j, u) for the last iterate
    std::vector<double> factor_, gamma_;
};

} // namespace gaspard
