// Fast diagonalisation of tensor-product systems in two or three directions with the same matrices in all of
// them (Lynch, Rice, Thomas, 1964; Sangalli and Tani, 2016; Algorithms 1 to 3 of Bahari et al., 2024, with U
// and U^T exchanged where the paper misprints them). In two directions
//
//   (K (x) M + M (x) K + shift M (x) M) x = b,     K U = M U Lambda,   U^T M U = I
//
//   x = U ( (U^T b U)_ij / (lambda_i + lambda_j + shift) ) U^T
//
// and in three with the sums over three directions.
//
// K is positive semidefinite and its kernel consists of the constants. With shift = 0, the component of b
// along the constants is dropped and x has mean zero.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gaspard {

/// A symmetric matrix in one direction, size x size.
struct LineOperator {
    std::size_t size = 0;
    std::vector<double> entries;
};

class FastDiagonalisation {
  public:
    /// M must be positive definite and K 1 = 0. `dimension`: 2 or 3.
    FastDiagonalisation(LineOperator stiffness, LineOperator mass, std::size_t dimension = 2);

    std::size_t size() const { return stiffness_.size; }
    /// K and M as given to the constructor.
    const LineOperator& stiffness() const { return stiffness_; }
    const LineOperator& mass() const { return mass_; }
    std::span<const double> eigenvalues() const { return eigenvalues_; } ///< the first is exactly 0

    /// size^dimension.
    std::size_t unknowns() const { return dimension_ == 2 ? size() * size() : size() * size() * size(); }
    /// Arrays of unknowns() numbers.
    struct Workspace {
        std::vector<double> first, second;
    };
    Workspace make_workspace() const {
        return {std::vector<double>(unknowns()), std::vector<double>(unknowns())};
    }
    /// Solves the system above. b and x: unknowns() numbers; they may be the same array.
    void solve(std::span<const double> b, std::span<double> x, double shift, Workspace& workspace) const;
    /// y = (K (x) M + M (x) K) x, or with three directions.
    void multiply(std::span<const double> x, std::span<double> y, Workspace& workspace) const;

  private:
    void solve_plane(std::span<const double> b, std::span<double> x, double shift,
                     Workspace& workspace) const;
    void solve_space(std::span<const double> b, std::span<double> x, double shift,
                     Workspace& workspace) const;

    LineOperator stiffness_, mass_;
    std::size_t dimension_;
    std::vector<double> eigenvalues_;
    std::vector<double> vectors_; ///< U by columns
};

} // namespace gaspard
