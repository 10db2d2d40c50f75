// Monge-Ampère equations for a potential phi on the domains of McRae et al. and Bahari et al.: what they add
// to a nonlinear problem (nonlinear_problem.hpp).
//
//   phi -> x = xi + grad phi (on a sphere the exponential map), sigma = weak Hessian
//   r_v = <v, m(x) det(I + sigma) - theta>,  theta = mean of m det(I + sigma)
//   <grad v, grad d> = r_v                   the direction of the relaxation
//
// The unknowns of a State are the array "phi"; at the start phi = 0.
#pragma once

#include "core/fem/ellipticity.hpp"
#include "core/method/nonlinear_problem.hpp"

namespace gaspard {

/// The constant that m det(dx/dxi) is to equal: the integral of m over the physical domain / measure of the
/// computational one, which a map of the domain to itself keeps.
SeriesInfo theta_series();

class MongeAmpereEquation : public NonlinearProblem {
  public:
    /// Of the map last evaluated.
    virtual Ellipticity ellipticity() const = 0;

    std::vector<SeriesInfo> series() const override { return {theta_series()}; }
    /// From the ellipticity: admissibility is the convexity.
    IterateShape shape() const final;
    /// m^t: constant for t = 0, which the identity map solves.
    ProblemData continued(const ProblemData& data, double t) const final;
    std::string name_of_continued(double t) const final;

  protected:
    MongeAmpereEquation(std::string layout, std::size_t unknowns)
        : NonlinearProblem(std::move(layout), unknowns, "phi") {}
};

/// The step of the relaxation that damps the fastest and the slowest mode of the linearised equation alike, a
/// little shortened; beyond 2 / fastest it is unstable. Positive and at most longest_step, even if the map is
/// not convex.
double stable_step(const Ellipticity& ellipticity);
inline constexpr double longest_step = 1e3;

/// For the preconditioner P = S K S of -div( m cof(I + sigma) grad ), whose eigenvalues lie between theta and
/// m theta near a solution: K the stiffness matrix of the Laplacian, S = diag(m^(1/5)) (after Concus and Golub,
/// 1973, who use the square root of a scalar coefficient). Returns 1 / S for m.
double preconditioner_scale(double monitor);

} // namespace gaspard
