// Load vectors of the Monge-Ampere residual on n x n squares, with v and sigma in Q2 and m in Q1,
//
//   <v, m det(I + sigma)>   for all v,
//
// and their derivative in the direction (dm, dsigma),
//
//   <v, dm det(I + sigma) + m cof(I + sigma) : dsigma>.
//
// The 4 x 4 Gauss quadrature is exact. It is factorised by direction and works on whole rows of cells.
#pragma once

#include "core/base/team.hpp"
#include "core/fem/line_map.hpp"

#include <array>
#include <span>
#include <vector>

namespace gaspard {

/// sigma, the weak Hessian of phi; three Q2 functions.
struct WeakHessian {
    std::vector<double> xx, yy, xy;
};

class DeterminantLoad {
  public:
    explicit DeterminantLoad(LineGrid grid);

    struct Workspace {               ///< of one worker, for one row of cells
        std::vector<double> values;  ///< sigma (and dsigma) at the Gauss points along x, three rows of nodes
        std::vector<double> density; ///< m (and dm) likewise, two rows
        std::vector<double> tested;  ///< integrals along y
        std::vector<double> row,
            top; ///< contributions to a row of nodes, and to the row above the last cells
    };
    Workspace make_workspace() const;

    /// Fills r (Q2 values, x fastest) from m at the mesh's (n+1)^2 nodes. Needs one workspace per worker; r
    /// does not depend on the number of workers.
    void integrate(std::span<const double> monitor, const WeakHessian& sigma, std::span<double> r,
                   std::span<Workspace> workspaces, Team& team) const;
    /// The derivative; d_monitor and d_sigma have the shapes of monitor and sigma.
    void differentiate(std::span<const double> monitor, const WeakHessian& sigma,
                       std::span<const double> d_monitor, const WeakHessian& d_sigma, std::span<double> r,
                       std::span<Workspace> workspaces, Team& team) const;

  private:
    static constexpr std::size_t gauss = 4;
    struct Fields;
    struct Point { ///< values of the basis functions at a Gauss point: Q2, Q1, and Q2 times the weight
        double left, middle, right, q1_left, q1_right, test_left, test_middle, test_right;
    };
    /// Pointers to rows of nodes at one Gauss point along x, with one value per cell: sigma and m, and with
    /// fields = 2 also dsigma and dm.
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
