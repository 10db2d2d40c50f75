// The adapted map of a patch as splines, for codes that compute with them: Psi, from the parameter square to
// itself. The mesh is F(Psi).
#pragma once

#include "core/method/method.hpp"
#include "core/spline/spline_patch.hpp"

#include <array>
#include <optional>

namespace gaspard {

struct SplineFunction {
    TensorSpace space;
    std::vector<double> coefficients; ///< fastest in the first direction
};

/// psi1 and psi2, exactly: in S^p-1 (x) S^p and S^p (x) S^p-1 of the standard form, whose psi are
/// derivatives; in S^p (x) S^p-1 and S^p-1 (x) S^p of the mixed one. Nothing for states that are not of a
/// patch.
std::optional<std::array<SplineFunction, 2>> spline_map(const State& state);
/// The mesh itself, F(Psi), as splines of the state's degree p on its cells, twice at every inner knot, as
/// Psi is: those that agree at the Greville points. Exact where F is affine, else to order p + 1.
std::optional<SplinePatch> adapted_patch(const State& state, const PatchMap& map);

} // namespace gaspard
