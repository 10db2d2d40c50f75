// A scalar function u(x) on a domain, of any sign: a formula, an image, a field from a file. Monitors are
// made of such functions (monitor/monitor.hpp says at which points of each kind of domain they are
// evaluated).
#pragma once

#include "core/base/export.hpp"
#include "core/base/points.hpp"

#include <span>

namespace gaspard GASPARD_API {

/// Immutable; may be called from several threads at once.
class ScalarFunction {
  public:
    virtual ~ScalarFunction() = default;
    /// u at every point (physical coordinates). `values`: x.size() entries.
    virtual void values(const Points& x, std::span<double> values) const = 0;
    /// grad u at every point, in Cartesian coordinates; on a sphere the tangential gradient. Resizes
    /// `gradients` to x.size().
    virtual void gradients(const Points& x, Points& gradients) const = 0;
};

} // namespace GASPARD_API
