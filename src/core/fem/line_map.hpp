// One-dimensional factors of the tensor-product operators: maps between function spaces on [0, 1] with n
// equal cells,
//
//   y = M^-1 B x,   M: mass matrix of the target space,   B_ij = factor <test_i, trial_j>,
//
// where the test function, the trial function or both may be differentiated.
//
// Spaces: continuous piecewise polynomials of degree 2 (unknown 2 c is vertex c, 2 c + 1 the midpoint of cell
// c) or degree 1 (vertices). Periodic: the last vertex is identified with the first. Walls: `even` functions
// have natural boundary conditions, `odd` functions vanish at the walls. These are the symmetric and
// antisymmetric functions about the walls: a domain with walls is a quarter of a periodic domain of twice the
// size. Arrays of odd functions include the zero end values, so that both kinds have equal length.
#pragma once

#include "core/linear/tridiagonal.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace gaspard {

struct LineGrid {
    std::size_t cells = 0;
    bool periodic = true;

    std::size_t vertices() const { return periodic ? cells : cells + 1; }
    std::size_t size(int degree) const { return degree == 2 ? vertices() + cells : vertices(); }
    double h() const { return 1.0 / static_cast<double>(cells); }
    friend bool operator==(const LineGrid&, const LineGrid&) = default;
};

enum class Symmetry { even, odd };

/// The bilinear form of B.
struct LineForm {
    bool derive_test = false;
    bool derive_trial = false;
    double factor = 1;
};

class LineMap {
  public:
    /// From even functions of degree 2 to functions of `target_degree` and, with walls, `target_symmetry`.
    LineMap(LineGrid grid, int target_degree, Symmetry target_symmetry, LineForm form);

    std::size_t rows() const { return rows_.size(); }
    /// Applies the map along the first index of row-major arrays. in: (degree-2 size) x columns, out: rows()
    /// x columns, with strides `in_stride` and `out_stride` between rows.
    void apply(const double* in, std::size_t in_stride, double* out, std::size_t out_stride,
               std::size_t columns) const;

  private:
    struct Row { ///< a linear combination of input rows, padded with zero weights
        int count = 0;
        std::array<std::size_t, 5> index{};
        std::array<double, 5> weight{};
        void add(std::size_t column, double by);
    };
    void eliminate_middles(double h, bool clamped);

    LineGrid grid_;
    int degree_;
    std::vector<Row> rows_;  ///< sparse part of M^-1 B; for vertices, the right-hand side of mass_
    double neighbours_ = 0;  ///< degree 2: weight of the two vertices in the back substitution of a midpoint
    TridiagonalSolver mass_; ///< vertices; for degree 2 after elimination of the midpoints
};

} // namespace gaspard
