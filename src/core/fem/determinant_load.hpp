// The integrals <v, m det(I + sigma)> for all v in Q2, m in Q1 and sigma in Q2, on n x n squares, and their
// derivative in a direction (dm, dsigma),
//
//   <v, dm det(I + sigma) + m cof(I + sigma) : dsigma>
//
// exact, by 4 x 4 Gauss points, one direction after the other, whole rows of cells at a time.
#pragma once

#include "core/base/team.hpp"
#include "core/fem/line_map.hpp"

#include <array>
#include <span>
#include <vector>

namespace gaspard {

/// sigma, the weak Hessian of phi: three Q2 functions.
struct WeakHessian {
    std::vector<double> xx, yy, xy;
};

class DeterminantLoad {
  public:
    explicit DeterminantLoad(LineGrid grid);

    struct Workspace { ///< of one worker; all of it belongs to one row of cells
        std::vector<double>
            values; ///< sigma (and dsigma) at the Gauss points along x, of three rows of nodes
        std::vector<double> density;  ///< m (and dm) likewise, of two
        std::vector<double> tested;   ///< integrated along y
        std::vector<double> row, top; ///< what the cells give to a row of nodes; to the one above the last
    };
    Workspace make_workspace() const;

    /// Fills r (Q2 values, x running fastest) from m at the mesh's (n+1)^2 nodes. As many rooms as workers; r
    /// does not depend on how many.
    void integrate(std::span<const double> monitor, const WeakHessian& sigma, std::span<double> r,
                   std::span<Workspace> workspaces, Team& team) const;
    /// The derivative, with dm and dsigma of the same shapes.
    void differentiate(std::span<const double> monitor, const WeakHessian& sigma,
                       std::span<const double> d_monitor, const WeakHessian& d_sigma, std::span<double> r,
                       std::span<Workspace> workspaces, Team& team) const;

  private:
    static constexpr std::size_t gauss = 4;
    struct Fields;
    struct Point { ///< the local functions at a Gauss point: Q2, Q1, and Q2 with the weight
        double left, middle, right, q1_left, q1_right, test_left, test_middle, test_right;
    };
    /// Of nodes, at one of the Gauss points along x, a value for every cell: of m and sigma, then perhaps of
    /// dm and dsigma.
    template <std::size_t fields>
    struct Rows {
        std::array<std::array<const double*, 3>, 3 * fields> sigma; ///< xx, yy, xy
        std::array<std::array<const double*, 2>, fields> density;
    };
    template <std::size_t fields>
    void integrate_all(const Fields& from, std::span<double> r, std::span<Workspace> workspaces,
                       Team& team) const;
    template <std::size_t fields>
    void integrate_rows(std::size_t begin, std::size_t end, const Fields& from, std::span<double> r,
                        Workspace& workspace) const;
    void along_x(const double* nodes, double* values) const;
    void interpolate_cells(const double* nodes, double* v0, double* v1, double* v2, double* v3) const;
    void density_along_x(const double* monitor, double* density) const;
    void add_point(const Point& at, const Rows<1>& rows, double* t0, double* t1, double* t2) const;
    void add_point(const Point& at, const Rows<2>& rows, double* t0, double* t1, double* t2) const;
    template <std::size_t fields>
    void test_along_y(std::size_t p, const std::array<double*, 3>& rows,
                      const std::array<double*, 2>& density, double* tested) const;
    void test_along_x(const double* tested, double* row) const;

    LineGrid grid_;
    std::array<Point, gauss> points_;
};

} // namespace gaspard
