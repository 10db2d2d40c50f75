// A monitor from a function of the position, for example of a simulation.
#pragma once

#include "core/base/export.hpp"
#include "core/monitor/monitor.hpp"

#include <functional>

namespace gaspard GASPARD_API {

/// m(x) = function(x), evaluated point by point. `space` must be that of the run (Run::space), which
/// otherwise throws InputError. A run calls the function with points of its domain, as it does every monitor
/// of the caller's (monitor.hpp): in [0, 1)^2 on the periodic square (the default), in [0, 1]^2 between
/// walls, on a sphere with |x| = R; z = 0 in the plane. On a patch, differences also take points slightly
/// beside it (of a surface in space, off the surface). It may be called from several threads at once if a run
/// uses more than one. values() throws InputError with the position if the function is not positive or not
/// finite. The gradients of a run are differences of its values.
std::shared_ptr<const Monitor> function_monitor(std::function<double(Vec3)> function,
                                                Space space = {SpaceKind::periodic_square});

} // namespace GASPARD_API
