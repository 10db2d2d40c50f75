// One-dimensional pieces of the tensor-product operators: maps between function spaces on [0,1], cut into n
// cells.
//
//   y = M^-1 B x,   M the mass matrix of the target space, B_ij = <test_i (or its derivative), trial_j (or
//   its derivative)>
//
// Spaces: continuous, of degree 2 (unknown 2 c is vertex c, 2 c + 1 the middle of cell c) or degree 1
// (vertices). Periodic: the last vertex is the first. Walls: `even` functions have natural ends, `odd` ones
// vanish there; they are the symmetric and antisymmetric functions about the walls, so that a domain with
// walls is a quarter of a periodic one of twice the size. Odd functions keep their (zero) end values in the
// arrays, so that both kinds have equal length.
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

/// What is integrated: trial function or its derivative against test function or its derivative.
struct LineForm {
    bool derive_test = false;
    bool derive_trial = false;
    double factor = 1;
};

class LineMap {
  public:
    /// From degree-2 functions (even) to functions of `target_degree` and `target_symmetry` (which only walls
    /// see).
    LineMap(LineGrid grid, int target_degree, Symmetry target_symmetry, LineForm form);

    std::size_t rows() const { return rows_.size(); }
    /// Along the first index of row-major arrays: in is (degree-2 size) x columns, out is rows() x columns,
    /// with rows `in_stride` and `out_stride` apart.
    void apply(const double* in, std::size_t in_stride, double* out, std::size_t out_stride,
               std::size_t columns) const;

  private:
    struct Row { ///< a combination of the input's rows; terms without weight fill it up
        int count = 0;
        std::array<std::size_t, 5> index{};
        std::array<double, 5> weight{};
        void add(std::size_t column, double by);
    };
    void eliminate_middles(double h, bool clamped);

    LineGrid grid_;
    int degree_;
    std::vector<Row> rows_;  ///< M^-1 B but for what follows: of vertices, the right-hand side of mass_
    double neighbours_ = 0;  ///< of degree 2: what a middle gets from the vertices beside it
    TridiagonalSolver mass_; ///< of the vertices; for degree 2 with the middles eliminated
};

} // namespace gaspard
