// Linear problems on an interval, also singularly perturbed and coupled: for components k = 1..m
//
//   -e_k u_k'' + c_k(x) u_k' + sum_l r_kl(x) u_l = f_k(x) in (a, b),   u_k = 0 at a and b
//
// Hill, Madden (2021): (6) has m = 1, e = eps^2, c = 0, r = 1, f = 1 - x; the coupled system (25) m = 2.
// Galerkin's method with P1 or P2 on any mesh; coefficients enter at five Gauss points of each cell. Errors
// are measured in the energy norm
//
//   ||v||_E^2 = sum_k ( e_k ||v_k'||^2 + ||v_k||^2 ).
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace gaspard {

/// The coefficients at points, one after the other: of each c (m), r (m x m, by rows), f (m).
struct IntervalCoefficients {
    std::vector<double> convection, reaction, source;
    std::vector<double> added_diffusion{}; ///< to e, on each cell (m); empty: none
};

struct IntervalProblem {
    std::vector<double> diffusion; ///< e_k > 0; m of them, 1 or 2
    /// Sets all coefficients at the points x, which are in [a, b]; they have their sizes.
    std::function<void(std::span<const double> x, IntervalCoefficients&)> coefficients;

    std::size_t components() const { return diffusion.size(); }
};

/// Throws InputError if values of a solution up to `largest` are not finite, or their energy would overflow.
void check_solution_size(double largest);

/// A piecewise polynomial, by components. Values at the nodes of the mesh and, of order 2, at the midpoints
/// of cells.
struct IntervalSolution {
    int order = 1;
    std::vector<std::vector<double>> nodes, middles;
};

/// The coefficients of a problem at points.
IntervalCoefficients coefficients_at(const IntervalProblem& problem, std::span<const double> points);
/// Where the integrals on a mesh need them, for solutions of both orders.
IntervalCoefficients coefficients_on(const IntervalProblem& problem, std::span<const double> x);

/// Throws InputError if a coefficient or the solution is not finite. `at`: coefficients_on() this mesh.
IntervalSolution solve_interval(const IntervalProblem& problem, const IntervalCoefficients& at,
                                std::span<const double> x, int order);
IntervalSolution solve_interval(const IntervalProblem& problem, std::span<const double> x, int order);

/// e (P coth P - 1), P = |c| h / (2 e): what exponential fitting adds to the diffusion e > 0.
double fitting_diffusion(double e, double c, double h);

/// The solution of order 1 with exponential fitting: on a cell of width h with the mean convection c, the
/// diffusion is e P coth P with P = c h / (2 e). It does not oscillate on coarse meshes (with constant c, f
/// and r = 0 it is exact at the nodes of a uniform one), and is Galerkin's where h is small or c = 0.
IntervalSolution solve_fitted(const IntervalProblem& problem, std::span<const double> x);

/// ||p2 - p1||_E of a solution of order 2 and one of order 1 on the same mesh: the paper's error.
double reference_error(const IntervalProblem& problem, std::span<const double> x, const IntervalSolution& p1,
                       const IntervalSolution& p2);

/// Value and derivative of an exact solution of one component.
struct IntervalExact {
    std::function<double(double)> value, slope;
};

/// ||u - u_h||_E of a solution of order 1; cells are halved until the integral is known to about 1e-10.
double exact_error(const IntervalProblem& problem, std::span<const double> x, const IntervalSolution& p1,
                   const IntervalExact& exact);

} // namespace gaspard
