// Mesh PDEs on a quadrilateral (layer/square_mesh_pde.hpp), as the method "mesh-pde": Algorithm 3 of Hill,
// Madden (2021). The form (29) is solved for the parameters (s, t) of the quadrilateral, with M at x(s, t),
// so that nodes slide along sides of any direction; on the unit square that is (29) itself. The form (28)
// moves nodes from the lower to the upper side only: in Cartesian coordinates where the left and the right
// side are vertical, as in the paper, otherwise in the parameters.
//
// On the last mesh the solves of Algorithm 3, or steps of Newton's method for the same equations; in columns
// with densities at corners from the converged mesh of half as many cells.
//
// The residual of an iterate is the largest change of a coordinate that the next solve makes; in
// Cartesian coordinates divided by the longest side. A State holds (s, t) of the nodes, for either form, of
// the domain's number of cells or of a coarser mesh.
#pragma once

#include "core/layer/quadrilateral_domain.hpp"
#include "core/method/method.hpp"

#include <memory>
#include <string>

namespace gaspard {

/// The rows of the form.
std::vector<ParameterRow> quadrilateral_rows();
/// Row for the solution of order 2 that errors are measured against.
ParameterRow reference_row();
/// Why method.reference measures no errors with so many cells per side: a sentence without a full stop; empty
/// if it measures them.
std::string why_without_errors(const std::string& reference, int cells);
/// MethodType::make of "mesh-pde" on a QuadrilateralDomain.
std::unique_ptr<Method> quadrilateral_mesh_pde(const MethodContext& context, const Values& values);

/// The same of "solution-adapted": the form (29) with densities from the computed solution
/// (layer/plane_solution_density.hpp); only a part of a step that would invert triangles.
std::unique_ptr<Method> quadrilateral_solution_adapted(const MethodContext& context, const Values& values);

} // namespace gaspard
