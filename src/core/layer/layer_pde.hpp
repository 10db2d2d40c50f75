// The problems with layers that users choose (section "pde"), from values to what the solvers take:
//
//   none                 no problem: only the mesh is computed
//   reaction-diffusion   -eps^2 u'' + r u = f                            Hill, Madden (2021), (6)
//   coupled-reaction-diffusion   -eps_k^2 u_k'' + sum_l r_kl u_l = f_k, k = 1, 2         (25)
//   convection-diffusion -eps u'' + c u' + r u = f
//
// on an interval, u = 0 at both ends, and on a quadrilateral
//
//   reaction-diffusion-2d   -((eps k_1)^p u_x)_x - ((eps k_2)^p u_y)_y + r u = f      (32), (35)
//   convection-diffusion-2d -eps (u_xx + u_yy) + c_1 u_x + c_2 u_y + r u = f
//
// with p = 2, or p = 1 as (35) is printed; u = 0 on the sides that are held, free on others. Coefficients are
// formulas in the coordinates and eps. Without convection r, or each r_kk, must not be negative: solutions
// would oscillate, on lengths of eps, or not be unique. Nor may (eps k)^p be.
#pragma once

#include "core/layer/interval_mesh.hpp"
#include "core/layer/interval_problem.hpp"
#include "core/layer/triangle_problem.hpp"
#include "core/monitor/pde_type.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

PdeType no_pde();
PdeType reaction_diffusion_pde();
PdeType coupled_pde();
PdeType convection_diffusion_pde();
PdeType plane_reaction_diffusion_pde();
PdeType plane_convection_diffusion_pde();

/// The row of an eps.
ParameterRow perturbation_row(const char* key, const char* symbol, double value);

/// A problem on an interval, and its solution where that is known in closed form.
struct IntervalPde {
    IntervalProblem problem;
    std::optional<IntervalExact> exact{};
};

/// nullopt for no_pde(). Throws InputError if a formula is wrong.
std::optional<IntervalPde> interval_pde(const std::string& type, const Values& values, Interval interval);

/// The same on a quadrilateral.
std::optional<TriangleProblem> plane_pde(const std::string& type, const Values& values);

/// What bounds the energy error of P1 on layer-adapted meshes with n cells per side, up to a constant:
/// sqrt(eps)/n (9), (sqrt(eps1) + sqrt(eps2))/n + 1/n^2 (26), the same with one eps in two dimensions; for
/// convection and diffusion 1/n, as on meshes of Bakhvalov's type.
struct EnergyBound {
    double value = 0;
    std::string formula; ///< "√ε / N"
};
EnergyBound one_layer_bound(double eps, double n);
EnergyBound two_layers_bound(double eps1, double eps2, double n);
EnergyBound plane_layers_bound(double eps, double n);
/// Of these, that of a problem; nullopt for no_pde().
std::optional<EnergyBound> energy_bound(const std::string& type, const Values& values, double n);

} // namespace gaspard
