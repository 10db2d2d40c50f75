// Symmetric positive definite systems with nine-point stencils on a square grid, such as finite elements give
// on n x n quadrilaterals with any coefficients: conjugate gradients, preconditioned by a multigrid V-cycle
// with operator-dependent interpolation (Dendy 1982), Galerkin coarse grids and line relaxation in both
// directions. The number of iterations hardly depends on n, the coefficients and their anisotropy.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gaspard {

/// The lower triangle, by rows, of the symmetric matrix of one quadrilateral. Corners: (0,0), (1,0), (0,1),
/// (1,1).
using CornerMatrix = std::array<double, 10>;

/// A grid with its operators: n x n quadrilaterals, (n + 1)^2 unknowns by rows, some of which are fixed.
class NinePointSolver {
  public:
    /// `n`: a power of two times an odd number; grids are halved as long as that is possible.
    explicit NinePointSolver(int n);

    /// The matrices of the n x n quadrilaterals, by rows, to be set before factorise().
    std::span<CornerMatrix> matrices();
    /// Makes the coarser grids. `fixed`: 1 for those of the (n + 1)^2 unknowns that keep their values.
    void factorise(const std::vector<std::uint8_t>& fixed);
    /// Solves A u = 0 for the free unknowns, from the values in `u`, until the preconditioned residual is
    /// `reduction` times its first value or at most `smallest` (in units of u). Returns the iterations.
    int solve(std::span<double> u, double reduction, double smallest = 0);

  private:
    /// Weights of coarse points for the points between them, to the right, above, and between.
    struct Interpolation {
        std::array<double, 2> south{}, west{};
        std::array<double, 4> middle{};
    };
    /// Unknowns with a border of fixed ones, so that all have eight neighbours.
    struct Grid {
        int n = 0;
        std::vector<std::uint8_t> fixed;
        std::vector<CornerMatrix> matrices;
        std::vector<double> centre, east, north, north_east,
            north_west;                              ///< couplings, negated; to later ones
        std::vector<double> row_pivot, column_pivot; ///< inverse pivots of the lines' tridiagonal systems
        std::vector<double> row_next, column_next;   ///< couplings to the next one times those
        std::vector<Interpolation> interpolation;    ///< by points of the coarser grid
        std::vector<double> u, b, r;
        std::size_t stride() const { return static_cast<std::size_t>(n + 3); }
        std::size_t at(int i, int j) const {
            return static_cast<std::size_t>(j + 1) * stride() + static_cast<std::size_t>(i + 1);
        }
        std::size_t coarse(int i, int j) const {
            return static_cast<std::size_t>(j) * static_cast<std::size_t>(n / 2 + 1) +
                   static_cast<std::size_t>(i);
        }
        double image(const std::vector<double>& v, std::size_t p) const;
    };
    static void assemble(Grid& grid);
    static void factorise_lines(Grid& grid);
    static void interpolate(Grid& grid);
    static void coarsen(const Grid& fine, Grid& coarse);
    static void relax_row(Grid& grid, int j);
    static void eliminate(Grid& grid, int first, int j);
    static void substitute(Grid& grid, int first, int j);
    template <class Done>
    static void relax_before(Grid& grid, const Done& done);
    template <class Prepare>
    static void relax_after(Grid& grid, const Prepare& prepare);
    static void residual_row(Grid& grid, int j);
    static void restrict_row(const Grid& fine, Grid& coarse, int j);
    static void prolong_row(const Grid& coarse, Grid& fine, int j);
    void cycle(std::size_t level);
    void start(std::span<const double> u);

    std::vector<Grid> grids_; ///< the finest first
    std::vector<double> direction_, rest_;
};

} // namespace gaspard
