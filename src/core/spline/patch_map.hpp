// F: the parameter square [0, 1]^2 -> a surface in the plane or in space, which the mesh covers. Its formulas
// are those that reproduce the tables of Bahari et al. (2024), sections 5 and 7; a patch of splines or NURBS
// is in spline_patch.hpp.
//
// The standard method's map leaves the square a little, so F has to go on beyond it.
#pragma once

#include "core/base/points.hpp"

#include <memory>

namespace gaspard {

class PatchMap {
  public:
    virtual ~PatchMap() = default;
    /// 2: z is 0 everywhere.
    virtual int space_dimension() const = 0;
    /// x = F(xi), xi in x and y; x is resized.
    virtual void points(const Points& xi, Points& x) const = 0;
    /// dF/dxi1 and dF/dxi2 at every xi; resized.
    virtual void tangents(const Points& xi, Points& first, Points& second) const = 0;
    /// x = xi, so that nobody needs to ask for points.
    virtual bool is_identity() const { return false; }
};

std::shared_ptr<const PatchMap> square_map();
/// The unit disk: u, v in [-1, 1], x = u sqrt(1 - v^2/2), y = v sqrt(1 - u^2/2). Singular at the corners.
std::shared_ptr<const PatchMap> disk_map();
/// Radii from 1/2 to 1, angles from 0 to pi/2.
std::shared_ptr<const PatchMap> quarter_annulus_map();
/// Of a torus of radii 3 and 1: angles from 0 to pi around its axis, from 0 to 3 pi/2 around the tube.
std::shared_ptr<const PatchMap> torus_part_map();
/// Of width 1 around a circle of radius 1, cut open: one turn, half a twist.
std::shared_ptr<const PatchMap> moebius_map();

} // namespace gaspard
