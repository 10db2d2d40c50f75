// The inverse of the map F of a patch (mesh/patch_parameters.hpp):
//
//   (u, v) = argmin |F(u, v) - x|^2
//
// by the method of Levenberg and Marquardt, which starts at the nearest of 65 x 65 sample points. The samples
// are made when they are first needed.
#pragma once

#include "core/mesh/patch_parameters.hpp"
#include "core/spline/patch_map.hpp"

#include <memory>

namespace gaspard {

std::shared_ptr<const PatchParameters> patch_parameters(std::shared_ptr<const PatchMap> map);

} // namespace gaspard
