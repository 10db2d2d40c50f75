// Monge-Ampère equations for a potential phi as nonlinear problems (nonlinear_problem.hpp), on the domains of
// McRae et al. and Bahari et al.
//
//   x     = xi + grad phi                       on a sphere: exponential map
//   sigma = weak Hessian of phi
//   r_v   = <v, m(x) det(I + sigma) - theta>,   theta = mean of m det(I + sigma)
//
//   <grad v, grad d> = r_v                      direction d of the relaxation
//
// A State holds the array "phi"; initially phi = 0.
#pragma once

#include "core/fem/ellipticity.hpp"
#include "core/method/nonlinear_problem.hpp"

namespace gaspard {

/// The constant that m det(dx/dxi) is to equal: the integral of m over the physical domain / measure of the
/// computational one, which a map of the domain to itself keeps.
SeriesInfo theta_series();

class MongeAmpereEquation : public NonlinearProblem {
  public:
    /// Ellipticity of the map last evaluated.
    virtual Ellipticity ellipticity() const = 0;

    std::vector<SeriesInfo> series() const override { return {theta_series()}; }
    /// From the ellipticity: admissibility is the convexity.
    IterateShape shape() const final;
    /// Data with monitor m^t. For t = 0 it is constant, and the identity map is the solution.
    ProblemData continued(const ProblemData& data, double t) const final;
    std::string name_of_continued(double t) const final;

  protected:
    MongeAmpereEquation(std::string layout, std::size_t unknowns)
        : NonlinearProblem(std::move(layout), unknowns, "phi") {}
};

/// Step size of the relaxation that damps the slowest and the fastest mode of the linearised equation
/// equally, reduced by 2 %:
///
///   0.98 * 2 / (lambda_max + max(0, lambda_min))
///
/// Steps longer than 2 / lambda_max are unstable. The result is positive and at most longest_step / theta,
/// even if the map is not convex.
double stable_step(const Ellipticity& ellipticity);
inline constexpr double longest_step = 1e3;

/// Returns m^(-1/5), the diagonal entry of S^-1 for the monitor value m, where S belongs to the
/// preconditioner
///
///   P = S K S  of  -div( m cof(I + sigma) grad ),   S = diag(m^(1/5)),   K = stiffness matrix
///
/// Near a solution, the eigenvalues of m cof(I + sigma) lie between theta and m theta. After Concus and Golub
/// (1973), who use the square root of a scalar coefficient.
double preconditioner_scale(double monitor);

} // namespace gaspard
