// The map F from the parameter square [0, 1]^2 to the surface, in the plane or in space, that the mesh
// covers. The formulas below reproduce the tables of Bahari et al. (2024), sections 5 and 7. Spline and NURBS
// patches are in spline_patch.hpp.
//
// Maps of the standard form leave the square slightly, so F must be defined in a neighbourhood of it.
#pragma once

#include "core/base/export.hpp"
#include "core/base/points.hpp"

#include <memory>
#include <span>

namespace gaspard GASPARD_API {

class PatchMap {
  public:
    virtual ~PatchMap() = default;
    /// 2 if z = 0 everywhere, else 3.
    virtual int space_dimension() const = 0;
    /// x = F(xi), with xi in the x and y of each point; resizes x.
    virtual void points(const Points& xi, Points& x) const = 0;
    /// dF/dxi1 and dF/dxi2 at every xi; resizes both.
    virtual void tangents(const Points& xi, Points& first, Points& second) const = 0;
    /// x = F(xi), and the area elements J = |dF/dxi1 x dF/dxi2| (of either orientation); `area` has xi.size()
    /// entries. J = 0 where F is singular.
    virtual void places(const Points& xi, Points& x, std::span<double> area) const = 0;
    /// J and its derivatives dJ/dxi1, dJ/dxi2, in x and y of `gradient`; resizes `gradient`. The derivatives
    /// are 0 where J = 0.
    virtual void area_gradients(const Points& xi, std::span<double> area, Points& gradient) const = 0;
    /// True if F is the identity, so that evaluations can be skipped.
    virtual bool is_identity() const { return false; }
};

std::shared_ptr<const PatchMap> square_map();
/// The unit disk: u, v in [-1, 1], x = u sqrt(1 - v^2/2), y = v sqrt(1 - u^2/2). Singular at the corners.
std::shared_ptr<const PatchMap> disk_map();
/// Quarter annulus: radii from 1/2 to 1, angles from 0 to pi/2.
std::shared_ptr<const PatchMap> quarter_annulus_map();
/// Part of the torus of radii 3 and 1: angles from 0 to pi around its axis, from 0 to 3 pi/2 around the tube.
std::shared_ptr<const PatchMap> torus_part_map();
/// Möbius strip of width 1 around the unit circle, cut open: one turn with half a twist.
std::shared_ptr<const PatchMap> moebius_map();

} // namespace GASPARD_API
