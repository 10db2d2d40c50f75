// Meshes of a quadrilateral that are adapted to layers: positions x(xi) of a grid of (N + 1)^2 nodes.
//
// Mesh PDEs of Hill, Madden (2021), with a density rho or a diagonal matrix M of densities at x(xi):
//
//   componentwise (29): div(M_11 grad x) = 0, div(M_22 grad y) = 0; written with M as it stands, not inverted
//   one direction (28): (rho y_xi2)_xi2 = 0, x = xi1   (as printed, divided by rho, the equation is linear)
//
// in P1 on the crossed mesh of the computational domain (every quadrilateral in four triangles that meet in
// its centre), with the densities at the last iterate (Algorithm 3): iterations on a mesh of start_cells^2
// quadrilaterals, then uniform refinement, and so on. The unknowns of the centres are eliminated, which
// leaves nine-point systems on the grid (linear/nine_point.hpp). The physical mesh joins the grid's nodes by
// right diagonals.
//
// Boundary: the coordinate that a side fixes stays as it is there, the other one is free (nodes slide along
// the side). Sides: the computational domain is the unit square for (29); for (28) any quadrilateral whose
// left and right sides are vertical.
#pragma once

#include "core/base/points.hpp"

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace gaspard {

/// Densities M_11 and M_22 at points; each positive and finite.
using LayerDensities = std::function<void(const Points& x, std::span<double> m11, std::span<double> m22)>;

/// Mean densities M_11 and M_22 of the triangles of a crossed mesh of n x n quadrilaterals, by rows: [4 q +
/// t] for the triangle t = 0, ..., 3 of quadrilateral q, below, on the right, above, and on the left of its
/// centre.
using TriangleDensities = std::array<std::vector<double>, 2>;

enum class MeshPdeForm { componentwise, one_direction };
/// Where a triangle samples the densities: at its corners, or at the points of the closed rule of degree 4,
/// twelve of which have a weight. Both see the edges of the domain.
enum class DensitySamples { corners, degree_4 };

/// The coarsest mesh in the sequence cells, cells/2, ... of numbers of at least `start_cells`, as long as
/// they are even: 4 for 64, 6 for 48, 33 for 33. Throws InputError if start_cells < 1 or cells < start_cells.
int coarsest_cells(int cells, int start_cells);

/// What one linear solve did.
struct SquareMeshSolve {
    double update = 0; ///< the largest change of a coordinate, centres included
    int inner_iterations = 0;
};

/// What one step of newton() did.
struct SquareMeshNewton {
    double residual = 0; ///< before the step: root mean square of ln(inflow / outflow) over the equations
    double update = 0;   ///< the largest change of a coordinate, centres included
    double factor = 0;   ///< 1: Newton's step; tau / (1 + tau): damped; 0: a solve of the fixed point instead
    double rounding = 0; ///< what rounding of the positions leaves of the residual
    /// A step of Newton's method without effect.
    bool converged(double tolerance) const {
        return factor == 1 && (update <= tolerance || residual <= 4 * rounding);
    }
};

class SquareLevel;

/// The iterate of a mesh PDE on one mesh, to be stepped from outside.
class SquareMeshPde {
  public:
    /// The uniform mesh of cells x cells quadrilaterals. Throws InputError if cells < 1. For `corners` see
    /// SquareMeshPdeOptions.
    SquareMeshPde(MeshPdeForm form, DensitySamples samples, const std::array<Vec3, 4>& corners, int cells);
    ~SquareMeshPde();
    SquareMeshPde(SquareMeshPde&&) noexcept;
    SquareMeshPde& operator=(SquareMeshPde&&) noexcept;

    int cells() const;             ///< in each direction
    const Points& nodes() const;   ///< (cells + 1)^2, by rows
    const Points& centres() const; ///< of the quadrilaterals, where the crossed mesh has nodes as well
    /// An iterate from outside; with centres in the middle of the nodes if none are given. Throws InputError
    /// if numbers or values are wrong, or a node leaves its side.
    void set_positions(Points nodes);
    void set_positions(Points nodes, Points centres);

    /// One step of the fixed point: the solution for the densities at the iterate. Throws InputError if a
    /// density is not positive and finite.
    SquareMeshSolve solve(const LayerDensities& densities);
    /// The same for densities that belong to the triangles, wherever they move. Throws InputError if one is
    /// not positive and finite, or their number is wrong.
    SquareMeshSolve solve(TriangleDensities densities);
    /// One step of Newton's method for the fixed point of solve(), by sparse elimination, damped so that no
    /// triangle is inverted (square_newton.cpp). With densities of layers thinner than 1e-4 at corners it
    /// finds the fixed point for both forms; of degree 4 there are many, and finding one may take long for
    /// one_direction. Throws Interrupted when a stop is requested.
    SquareMeshNewton newton(const LayerDensities& densities, const std::stop_token& stop = {});
    /// Halves the cells; the iterate stays the same function.
    void refine();

  private:
    std::unique_ptr<SquareLevel> level_;
};

struct SquareMeshPdeOptions {
    MeshPdeForm form = MeshPdeForm::componentwise;
    DensitySamples samples = DensitySamples::degree_4;
    /// Corners of the computational domain: (0,0), (1,0), (0,1), (1,1) of the unit square, mapped bilinearly.
    std::array<Vec3, 4> corners = {Vec3{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    int start_cells = 4;  ///< least number in each direction of the coarsest mesh
    int inner = 4;        ///< solves on each coarser mesh
    int final = 5;        ///< at most, on the last mesh
    double tolerance = 0; ///< ends before, when no node moves by more
};

struct SquareMeshPdeResult {
    Points x;                    ///< (N + 1)^2 nodes, by rows
    std::vector<double> updates; ///< of each solve on the last mesh: the largest change of a coordinate
    int inner_iterations = 0;    ///< of the linear solver, in all
};

/// From the mesh of coarsest_cells() to `cells`. Throws InputError if cells < start_cells, or a density is
/// not positive and finite.
SquareMeshPdeResult mesh_pde_square(const LayerDensities& densities, int cells,
                                    const SquareMeshPdeOptions& options);

struct SquareConvergence {
    int steps = 0;
    double update = 0;   ///< of the last step
    double residual = 0; ///< before it
    bool converged = false;
};

/// Steps of newton() until one of Newton's changes no coordinate by more than `tolerance`, or rounding of the
/// positions leaves nothing to improve.
SquareConvergence converge_square(SquareMeshPde& pde, const LayerDensities& densities,
                                  double tolerance = 1e-8, int max_steps = 300);

/// Triangles of a grid with right diagonals (from (0,0) to (1,1)) whose area is not positive.
std::size_t inverted_triangles(const Points& x, int cells);

} // namespace gaspard
