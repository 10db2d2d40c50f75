// The adapted map of a patch as splines, for export to other codes: Psi, from the parameter square to itself.
// The mesh is F(Psi).
#pragma once

#include "core/method/method.hpp"
#include "core/spline/spline_patch.hpp"

#include <array>
#include <optional>

namespace gaspard {

/// The components of Psi, exactly; nullopt if the state is not that of a patch.
///
///   standard form   psi1 in S^{p-1} (x) S^p,       psi2 in S^p (x) S^{p-1}       (derivatives of Phi)
///   mixed form      psi1 in S^p (x) S^{p-1},       psi2 in S^{p-1} (x) S^p
std::optional<std::array<SplineFunction, 2>> spline_map(const State& state);
/// The mesh F(Psi) as a spline patch of the state's degree p on its cells, with double inner knots, because
/// Psi has this smoothness: interpolation at the Greville points. Exact if F is affine, else of order p + 1.
/// nullopt if the state is not that of a patch.
std::optional<SplinePatch> adapted_patch(const State& state, const PatchMap& map);

} // namespace gaspard
