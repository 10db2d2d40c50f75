// The place of a spline solid in space (mesh/solid_shape.hpp), by the method of Levenberg and Marquardt
// within the parameter cube, which starts at the nearest of 33^3 sample points. Points that are nearer to a
// sample than this is to the boundary are inside without a search. The samples are made when they are first
// needed. Where F is singular, as at the edges of the ball's cube, points beside are found less accurately.
#pragma once

#include "core/mesh/solid_shape.hpp"
#include "core/spline/patch_map.hpp"

#include <memory>

namespace gaspard {

std::shared_ptr<const SolidShape> solid_shape(std::shared_ptr<const SolidMap> map);

} // namespace gaspard
