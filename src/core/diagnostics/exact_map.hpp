// The exact map of the sphere for a monitor M(s) that depends on the angle s from an axis only; McRae,
// Cotter, Budd, appendix A. Points move along great circles through the axis, from angle t to angle s(t):
//
//   integral from 0 to s of M(s') sin s' ds' = theta (1 - cos t),  theta = half of the integral from 0 to pi
//
// The integrals are tabulated once, from both ends, so that s is accurate near the axis and opposite to it.
#pragma once

#include "core/base/series.hpp"
#include "core/mesh/mesh.hpp"
#include "core/monitor/monitor.hpp"

#include <optional>
#include <vector>

namespace gaspard {

class ExactMap {
  public:
    /// Nothing where the monitor has no axis.
    static std::optional<ExactMap> of(const Monitor& monitor);

    double theta() const { return theta_; }
    /// s(t), both from 0 to pi; right to about 1e-10.
    double angle(double t) const;
    /// Where points of a sphere around the origin go, of whatever radius.
    Points apply(const Points& xi) const;

  private:
    ExactMap(const Monitor& monitor, Vec3 axis);
    double within(std::size_t interval, double part) const;

    Vec3 axis_;
    double theta_ = 0;
    std::vector<double> density_; ///< M sin s at the ends and middles of the intervals
    std::vector<double> from_0_, from_pi_;
};

/// Root mean squares of the distances along the sphere between x and where the exact map puts the nodes, in
/// units of length; (5.9).
struct ExactDeviation {
    double vertices = 0; ///< over the cells' corners
    double nodes = 0;    ///< over all nodes
};
ExactDeviation exact_deviation(const Mesh& mesh, const Points& x, const Points& exact);
/// What a run reports of it, and the values in the same order.
std::vector<SeriesInfo> exact_series();
SeriesValues values_of(const ExactDeviation& deviation);

} // namespace gaspard
