// A monitor from a function of the place, as a simulation has one.
#pragma once

#include "core/monitor/monitor.hpp"

#include <functional>

namespace gaspard {

/// m(x) = function(x), asked point by point; z = 0 in the plane. `space` is that of the run (Run::space),
/// which refuses others; on the periodic square (the default) the function is asked for points of [0, 1)^2
/// only, on a sphere for points of the sphere. Calls may come from several threads at once when a run has
/// more than one. Where the function is not positive or not finite, values() throws an InputError that says
/// where. Gradients are differences over 1e-5, on a sphere of its radius.
std::shared_ptr<const Monitor> function_monitor(std::function<double(Vec3)> function,
                                                Space space = {SpaceKind::periodic_square});

} // namespace gaspard
