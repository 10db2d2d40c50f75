// Reaction-diffusion with convection on a grid of triangles:
//
//   -(k1 u_x)_x - (k2 u_y)_y + c1 u_x + c2 u_y + r u = f,   u = 0 on the sides that are held, free on others
//
// Hill, Madden (2021): (32) has k1 = k2 = eps^2, f = x, free on the right; (35) has k1 = (eps (1 + 2y)^2)^2,
// k2 = (eps (3 - 2x)^2)^2, the square of the printed matrix. Galerkin's method with P1 or P2; coefficients
// enter at the twelve points of a rule of degree 6. Errors in the energy norm
//
//   ||v||_E^2 = (k1 v_x, v_x) + (k2 v_y, v_y) + (v, v).
#pragma once

#include "core/base/points.hpp"

#include <array>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace gaspard {

struct TriangleCoefficients {
    double k1 = 1, k2 = 1, c1 = 0, c2 = 0, r = 1, f = 0;
};

struct TriangleProblem {
    /// Sets the coefficients at many points.
    std::function<void(const Points& x, std::span<TriangleCoefficients>)> coefficients;
    std::array<bool, 4> held = {true, true, true, true}; ///< left, right, bottom, top: u = 0
};

/// TriangleProblem::coefficients from a function of one point.
std::function<void(const Points& x, std::span<TriangleCoefficients>)>
pointwise(std::function<TriangleCoefficients(double x, double y)> coefficients);

/// Values at the nodes of the grid and, of order 2, at the midpoints of edges: (2N + 1)^2 values by rows, the
/// grid's nodes at even places.
struct TriangleSolution {
    int order = 1;
    std::vector<double> values;
};

/// `x`: the (N + 1)^2 nodes by rows; triangles have right diagonals and positive areas. Throws InputError if
/// a coefficient or the solution is not finite, or there is neither a side that is held nor reaction;
/// Interrupted when a stop is requested.
TriangleSolution solve_triangles(const TriangleProblem& problem, const Points& x, int cells, int order,
                                 const std::stop_token& stop = {});

/// Of order 1, with the diffusion along the lines of the grid fitted to the flow along them, as on an
/// interval (interval_problem.hpp), so that the solution does not oscillate where convection dominates.
TriangleSolution solve_fitted(const TriangleProblem& problem, const Points& x, int cells,
                              const std::stop_token& stop = {});

/// ||p2 - p1||_E of a solution of order 2 and one of order 1 on the same mesh: the paper's error.
double reference_error(const TriangleProblem& problem, const Points& x, int cells, const TriangleSolution& p1,
                       const TriangleSolution& p2, const std::stop_token& stop = {});

} // namespace gaspard
