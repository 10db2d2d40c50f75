// The adapted map of a patch or a solid as splines, for export to other codes: Psi, from the parameter square
// or cube to itself. The mesh is F(Psi).
#pragma once

#include "core/method/method.hpp"
#include "core/spline/spline_patch.hpp"

#include <optional>
#include <vector>

namespace gaspard {

/// The components of Psi, exactly, two or three; nullopt if the state is not that of a patch or a solid.
///
///   standard form   psi1 in S^{p-1} (x) S^p,       psi2 in S^p (x) S^{p-1}       (derivatives of Phi)
///   mixed form      psi1 in S^p (x) S^{p-1},       psi2 in S^{p-1} (x) S^p
std::optional<std::vector<SplineFunction>> spline_map(const State& state);
/// The mesh F(Psi) as a spline patch of the state's degree p on its cells, with double inner knots, because
/// Psi has this smoothness: interpolation at the Greville points. Exact if F is affine, else of order p + 1.
/// nullopt if the state is not that of a patch (D = 2) or a solid (D = 3).
template <std::size_t D>
std::optional<SplinePatch> adapted_patch(const State& state, const TensorMap<D>& map);

} // namespace gaspard
