// Spline and NURBS patches, surfaces and solids, (2.5) with weights:
//
//   F(xi) = (sum over i of B_i w_i C_i) / (sum over i of B_i w_i),    i = (i1, i2) or (i1, i2, i3)
#pragma once

#include "core/base/export.hpp"
#include "core/spline/patch_map.hpp"
#include "core/spline/tensor_space.hpp"

namespace gaspard GASPARD_API {

/// Plain data: to move control points, change them and make a new map, which is cheap.
struct SplinePatch {
    TensorSpace space;           ///< two or three directions
    Points control;              ///< C, first direction fastest
    std::vector<double> weights; ///< all 1 for splines
    friend bool operator==(const SplinePatch&, const SplinePatch&) = default;
};

/// The same patch with more knots; `fine` must refine the patch's space.
SplinePatch insert_knots(const SplinePatch& patch, const TensorSpace& fine);
/// The spline patch that interpolates x at the Greville points of the space, first direction fastest.
SplinePatch patch_through(const TensorSpace& space, const Points& x);

/// The map of a patch with two directions and positive weights.
std::shared_ptr<const PatchMap> patch_map(SplinePatch patch);
/// The map of one with three directions.
std::shared_ptr<const SolidMap> solid_map(SplinePatch patch);

} // namespace GASPARD_API
