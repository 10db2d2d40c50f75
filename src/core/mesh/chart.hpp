// A chart of a domain: coordinates s in a box, on which functions are given by their values on regular grids.
//
//   box       plane, walls, planar patches, solids: s = x, in the bounding box of the domain
//   sphere    s = (longitude, latitude) in degrees, in [-180, 180] x [-90, 90] (equirectangular)
//   surface   a patch in space: s = (u, v), its parameters, in [0, 1]^2
//
// Coordinates are kept in Points: s_1, s_2, s_3 in x, y, z; those beyond the chart's dimension are zero. The
// gradient of a function f(s(x)) is, with the tangents t_i = dx/ds_i and g_ij = t_i . t_j,
//
//   grad f = sum over i, j of (g^-1)_ij df/ds_i t_j
#pragma once

#include "core/base/box.hpp"
#include "core/base/points.hpp"
#include "core/mesh/data_context.hpp"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gaspard {

enum class ChartKind { box, sphere, surface };
/// How a function goes on across the two ends of a direction.
enum class ChartEnds {
    open,     ///< the domain ends there
    periodic, ///< the ends are the same points
    poles,    ///< of the latitude: on the opposite meridian
};

struct ChartDirection {
    std::string name; ///< "x", "longitude", "u"
    double low = 0, high = 1;
    ChartEnds ends = ChartEnds::open;
    friend bool operator==(const ChartDirection&, const ChartDirection&) = default;
};

/// Immutable; may be called from several threads at once.
class Chart {
  public:
    Chart(ChartKind kind, std::vector<ChartDirection> directions)
        : kind_(kind), directions_(std::move(directions)) {}
    virtual ~Chart() = default;

    ChartKind kind() const { return kind_; }
    /// 1, 2 or 3.
    std::size_t dimension() const { return directions_.size(); }
    const ChartDirection& direction(std::size_t i) const { return directions_[i]; }

    /// s of points of the domain; resizes s. Points beside a patch may get coordinates beside the box,
    /// other images of points of a periodic domain those of any image. For points near a sphere: of their
    /// directions.
    virtual void coordinates(const Points& x, Points& s) const = 0;
    /// x of coordinates in the box; resizes x.
    virtual void points(const Points& s, Points& x) const = 0;
    /// The tangents dx/ds_i at every s; resizes those of the chart's dimension.
    virtual void tangents(const Points& s, std::array<Points, 3>& tangents) const = 0;
    /// Overwrites df/ds at the points x with coordinates s by the Cartesian gradient, which on surfaces is
    /// tangential. On the sphere not at the poles (see pole_margin).
    virtual void to_cartesian(const Points& x, const Points& s, Points& derivatives) const = 0;

  private:
    ChartKind kind_;
    std::vector<ChartDirection> directions_;
};

/// Closer to the poles (degrees) longitudes have too few digits for gradients: these are then those of the
/// point at this distance.
inline constexpr double pole_margin = 1e-5;

/// s = x in a box. `ends`: of every direction.
std::shared_ptr<const Chart> box_chart(const Box& box, std::size_t dimension, ChartEnds ends);
/// Longitude and latitude on the sphere of this radius around the origin.
std::shared_ptr<const Chart> sphere_chart(double radius);
/// The chart of a domain; without a discretisation that of the space's box, the unit square or the unit
/// sphere.
std::shared_ptr<const Chart> chart_of(const DataContext& context);

} // namespace gaspard
