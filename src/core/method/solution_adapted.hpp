// The values of the method "solution-adapted".
#pragma once

#include "core/base/parameter.hpp"
#include "core/layer/solution_density.hpp"

namespace gaspard {

/// From the rows "density" and "smoothing".
SolutionMeshOptions solution_options(const Values& values);

} // namespace gaspard
