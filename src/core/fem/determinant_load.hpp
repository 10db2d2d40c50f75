// The integrals <v, m det(I + sigma)> for all v in Q2, m in Q1 and sigma in Q2, on n x n squares: exact, by
// 4 x 4 Gauss points, one direction after the other, whole rows of cells at a time.
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

    struct Room {                     ///< of one worker; all of it belongs to one row of cells
        std::vector<double> values;   ///< sigma at the Gauss points along x, of three rows of nodes
        std::vector<double> density;  ///< m likewise, of two
        std::vector<double> tested;   ///< integrated along y
        std::vector<double> row, top; ///< what the cells give to a row of nodes; to the one above the last
    };
    Room make_room() const;

    /// Fills r (Q2 values, x running fastest) from m at the mesh's (n+1)^2 nodes. As many rooms as workers; r
    /// does not depend on how many.
    void integrate(std::span<const double> monitor, const WeakHessian& sigma, std::span<double> r,
                   std::span<Room> rooms, Team& team) const;

  private:
    static constexpr std::size_t gauss = 4;
    struct Fields;
    struct Point { ///< the local functions at a Gauss point: Q2, Q1, and Q2 with the weight
        double left, middle, right, q1_left, q1_right, test_left, test_middle, test_right;
    };
    struct Rows { ///< of nodes, at one of the Gauss points along x, a value for every cell
        std::array<const double*, 3> xx, yy, xy;
        std::array<const double*, 2> density;
    };
    void integrate_rows(std::size_t begin, std::size_t end, const Fields& fields, std::span<double> r,
                        Room& room) const;
    void along_x(const double* nodes, double* values) const;
    void interpolate_cells(const double* nodes, double* v0, double* v1, double* v2, double* v3) const;
    void density_along_x(const double* monitor, double* density) const;
    void add_point(const Point& at, const Rows& rows, double* t0, double* t1, double* t2) const;
    void test_along_y(std::size_t p, const std::array<double*, 3>& rows,
                      const std::array<double*, 2>& density, double* tested) const;
    void test_along_x(const double* tested, double* row) const;

    LineGrid grid_;
    std::array<Point, gauss> points_;
};

} // namespace gaspard
