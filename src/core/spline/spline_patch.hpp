// A patch of splines or NURBS: F(xi) = sum of B_ij w_ij C_ij / sum of B_ij w_ij, (2.5) with weights.
#pragma once

#include "core/spline/patch_map.hpp"
#include "core/spline/tensor_space.hpp"

namespace gaspard {

/// A value: change control points or weights and make a map of it anew, which is cheap.
struct SplinePatch {
    TensorSpace space;           ///< two directions
    Points control;              ///< C, fastest in the first direction
    std::vector<double> weights; ///< all 1 for splines
    friend bool operator==(const SplinePatch&, const SplinePatch&) = default;
};

/// The same surface with more knots; `fine` refines the patch's space.
SplinePatch insert_knots(const SplinePatch& patch, const TensorSpace& fine);
/// The splines that are x at the Greville points of their space, fastest in the first direction.
SplinePatch patch_through(const TensorSpace& space, const Points& x);

/// The map of a patch, whose weights are positive and whose numbers fit together.
std::shared_ptr<const PatchMap> patch_map(SplinePatch patch);

} // namespace gaspard
