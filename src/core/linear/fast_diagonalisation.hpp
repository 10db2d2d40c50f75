// Systems of two directions alike, by the eigenvectors of one (Lynch, Rice, Thomas, 1964; Sangalli and Tani,
// 2016; algorithms 1 and 2 of Bahari et al., 2024, with U and its transpose in their right places):
//
//   (K (x) M + M (x) K + shift M (x) M) x = b,   K U = M U Lambda,  U^T M U = I
//   x = U ( (U^T b U) / (lambda_i + lambda_j + shift) ) U^T
//
// K is semidefinite with the kernel of the constants, 1. Without a shift the system is solved on what is
// orthogonal to it: what b has of the constant is left out, and x has the mean zero.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gaspard {

/// A symmetric matrix of one direction, size x size.
struct LineOperator {
    std::size_t size = 0;
    std::vector<double> entries;
};

class FastDiagonalisation {
  public:
    /// M positive definite, K 1 = 0.
    FastDiagonalisation(LineOperator stiffness, LineOperator mass);

    std::size_t size() const { return stiffness_.size; }
    /// The same K and M as they were given.
    const LineOperator& stiffness() const { return stiffness_; }
    const LineOperator& mass() const { return mass_; }
    std::span<const double> eigenvalues() const { return eigenvalues_; } ///< the first is 0, exactly

    /// size^2 numbers each.
    struct Workspace {
        std::vector<double> first, second;
    };
    Workspace make_workspace() const {
        return {std::vector<double>(size() * size()), std::vector<double>(size() * size())};
    }
    /// b and x: size x size numbers; may be the same array.
    void solve(std::span<const double> b, std::span<double> x, double shift, Workspace& workspace) const;
    /// y = (K (x) M + M (x) K) x.
    void multiply(std::span<const double> x, std::span<double> y, Workspace& workspace) const;

  private:
    LineOperator stiffness_, mass_;
    std::vector<double> eigenvalues_;
    std::vector<double> vectors_; ///< U, column by column
};

} // namespace gaspard
