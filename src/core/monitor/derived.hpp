// A monitor derived from a function u, such as the solution of a PDE, so that the mesh is dense where u needs
// it. With v = u / range, where range = max u - min u over the domain, and lengths in units of the domain's
// size D (longest side of its box, radius of a sphere), the indicator is 1 + q or q:
//
//   arc length   1 + q = sqrt(1 + a |D grad v|^2)
//   curvature    1 + q = (1 + a |D^2 H|_F^2)^(1 / (2 k)),    H the Hessian of v
//   gradient     q = |D grad v|
//   magnitude    q = |u| / max |u|
//   band         1 + q = 1 + a sech((v - c) / w) or 1 + a exp(-((v - c) / w)^2),    v = (u - min u) / range
//
// On spheres and surfaces gradient and Hessian are those of the surface (function/derivative_norms.hpp).
// Stages (monitor/stages.hpp) turn it into m: average, limit, smoothing. They are computed once, on a grid; m
// is then the exponential of a spline through log m, so that it costs the same whatever the stages, and has
// exact gradients.
#pragma once

#include "core/base/export.hpp"
#include "core/function/scalar_function.hpp"
#include "core/monitor/monitor.hpp"

#include <memory>
#include <optional>

namespace gaspard GASPARD_API {

enum class Indicator { arc_length, curvature, gradient, magnitude, band };

struct DerivedOptions {
    Indicator indicator = Indicator::arc_length;
    bool normalise = true; ///< false: v = u, D = 1, so that all numbers have the units of u and x
    double alpha = 1;      ///< a > 0
    double order = 1.5;    ///< k > 0. In the plane 3/2 is best for the error of linear interpolation in L2, 1
                           ///< for its maximum and for that of the gradient
    double level = 0.5;    ///< c
    double width = 0.05;   ///< w > 0
    bool gaussian = false; ///< the band's profile: exp instead of sech
    bool average = true;   ///< the stage; without it m is the indicator
    double fraction = 0.5; ///< f of the cells, at least 0 and less than 1
    bool limit = true;     ///< the stage
    double floor = 0.01;   ///< F, relative to the average of m; at least 0
    double contrast = 1000;            ///< C, at least 1
    bool smooth = true;                ///< the stage
    std::optional<double> smoothing{}; ///< L in cells of the uniform mesh; nullopt: as much as the mesh needs
};

/// `context`: the space and the discretisation of the run (Run::space, Run::discretisation), which the
/// monitor does not keep. Throws InputError if an option is out of its range, if u or what is needed of its
/// derivatives is not finite at some point of the domain, or if m is not positive; Interrupted if asked to
/// stop. `of_u`: what there is to say of u; the monitor's report goes on with it.
std::shared_ptr<const Monitor> derived_monitor(std::shared_ptr<const ScalarFunction> u,
                                               const DerivedOptions& options, const MonitorContext& context,
                                               MonitorReport of_u = {});

} // namespace GASPARD_API
