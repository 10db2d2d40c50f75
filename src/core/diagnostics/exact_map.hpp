// The exact map of the sphere for a monitor M(s) that depends only on the angle s from an axis; McRae,
// Cotter, Budd, Appendix A. Points move along great circles through the axis, from angle t to angle s(t):
//
//   integral of M(s') sin s' ds' from 0 to s  =  theta (1 - cos t)
//
//   theta = 1/2 integral of M(s') sin s' ds' from 0 to pi
//
// The integrals are tabulated from both ends, so that s(t) is accurate near both poles of the axis.
#pragma once

#include "core/base/series.hpp"
#include "core/mesh/mesh.hpp"
#include "core/monitor/monitor.hpp"

#include <optional>
#include <vector>

namespace gaspard {

class ExactMap {
  public:
    /// nullopt if the monitor has no symmetry axis.
    static std::optional<ExactMap> of(const Monitor& monitor);

    double theta() const { return theta_; }
    /// s(t), both in [0, pi]; error about 1e-10.
    double angle(double t) const;
    /// The images of points on a sphere of any radius around the origin.
    Points apply(const Points& xi) const;

  private:
    ExactMap(const Monitor& monitor, Vec3 axis);
    double within(std::size_t interval, double part) const;

    Vec3 axis_;
    double theta_ = 0;
    std::vector<double> density_; ///< M sin s at the ends and midpoints of the intervals
    std::vector<double> from_0_, from_pi_;
};

/// Root mean square of the distance between x and the exact positions of the nodes, in units of length; on a
/// sphere of great circles (5.9).
struct ExactDeviation {
    double vertices = 0; ///< over the corners of the cells
    double nodes = 0;    ///< over all nodes
};
ExactDeviation exact_deviation(const Mesh& mesh, const Points& x, const Points& exact, bool sphere = true);
/// What a run reports of it, and the values in the same order.
std::vector<SeriesInfo> exact_series();
SeriesValues values_of(const ExactDeviation& deviation);

} // namespace gaspard
