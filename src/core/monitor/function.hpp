// A monitor from a function of the position, for example of a simulation.
#pragma once

#include "core/monitor/monitor.hpp"

#include <functional>

namespace gaspard {

/// m(x) = function(x), evaluated point by point; z = 0 in the plane. `space` must be that of the run
/// (Run::space), which otherwise throws InputError. On the periodic square (the default) the function is
/// called only with points in [0, 1)^2, on a sphere only with points of the sphere. It may be called from
/// several threads at once if a run uses more than one. values() throws InputError with the position if the
/// function is not positive or not finite. Gradients are central differences with step 1e-5, times the radius
/// on a sphere.
std::shared_ptr<const Monitor> function_monitor(std::function<double(Vec3)> function,
                                                Space space = {SpaceKind::periodic_square});

} // namespace gaspard
