// Anderson acceleration: from the last iterates of phi -> phi + beta u(phi), the next one that the
// differences between them make most promising.
//
//   minimise | u - sum of gamma_j du_j |,   next = phi + beta u - sum of gamma_j (dphi_j + beta du_j)
//
// The norm is that of an inner product in which u is the representative of r: (u, w) = r . w. With u from
// <grad v, grad u> = r_v it is the H1 product, and costs one sum.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gaspard {

class Anderson {
  public:
    /// For `size` unknowns, remembering `memory` differences.
    Anderson(std::size_t size, std::size_t memory);

    /// All but the last iterate, which the next one may differ from.
    void forget_differences() { count_ = 0; }
    /// How many differences it knows of.
    std::size_t count() const { return count_; }
    /// Takes note of an iterate with its u and r, and fills next. Allocates nothing.
    void propose(std::span<const double> phi, std::span<const double> u, std::span<const double> r,
                 double beta, std::span<double> next);

  private:
    void remember(std::span<const double> phi, std::span<const double> u, std::span<const double> r);
    void solve();

    std::size_t size_, memory_;
    std::size_t count_ = 0, oldest_ = 0;
    bool begun_ = false;
    std::vector<std::vector<double>> dphi_, du_; ///< slots, used in turn
    std::vector<double> phi_, u_, r_;            ///< the last iterate
    std::vector<double> gram_;                   ///< (du_i, du_j), memory x memory
    std::vector<double> projection_;             ///< (du_j, u) of the last iterate
    std::vector<double> factor_, gamma_;
};

} // namespace gaspard
