// The map F from the parameter square [0, 1]^2 to a surface, in the plane or in space, or from the parameter
// cube [0, 1]^3 to a solid. The formulas below reproduce the tables of Bahari et al. (2024), sections 5 and
// 7. Spline and NURBS patches are in spline_patch.hpp.
//
// Maps of the standard form leave the square slightly, so F must be defined in a neighbourhood of it.
#pragma once

#include "core/base/export.hpp"
#include "core/base/points.hpp"

#include <array>
#include <memory>
#include <span>

namespace gaspard GASPARD_API {

/// D: 2 for surfaces, 3 for solids.
template <std::size_t D>
class TensorMap {
  public:
    virtual ~TensorMap() = default;
    /// 2 if z = 0 everywhere, else 3.
    virtual int space_dimension() const = 0;
    /// x = F(xi), with xi in the x and y (and z) of each point; resizes x.
    virtual void points(const Points& xi, Points& x) const = 0;
    /// dF/dxi1, dF/dxi2 (and dF/dxi3) at every xi; resizes all.
    virtual void tangents(const Points& xi, std::array<Points, D>& tangents) const = 0;
    /// x = F(xi), and the elements of area or volume, of either orientation,
    ///
    ///   J = |dF/dxi1 x dF/dxi2|     or     J = |det dF/dxi|
    ///
    /// `element` has xi.size() entries. J = 0 where F is singular.
    virtual void places(const Points& xi, Points& x, std::span<double> element) const = 0;
    /// J and its derivatives dJ/dxi1, dJ/dxi2 (and dJ/dxi3), in x, y and z of `gradient`; resizes `gradient`.
    /// The derivatives are 0 where J = 0.
    virtual void element_gradients(const Points& xi, std::span<double> element, Points& gradient) const = 0;
    /// True if F is the identity, so that evaluations can be skipped.
    virtual bool is_identity() const { return false; }
};
using PatchMap = TensorMap<2>;
using SolidMap = TensorMap<3>;

std::shared_ptr<const PatchMap> square_map();
/// The unit disk: u, v in [-1, 1], x = u sqrt(1 - v^2/2), y = v sqrt(1 - u^2/2). Singular at the corners.
std::shared_ptr<const PatchMap> disk_map();
/// Quarter annulus: radii from 1/2 to 1, angles from 0 to pi/2.
std::shared_ptr<const PatchMap> quarter_annulus_map();
/// Part of the torus of radii 3 and 1: angles from 0 to pi around its axis, from 0 to 3 pi/2 around the tube.
std::shared_ptr<const PatchMap> torus_part_map();
/// Möbius strip of width 1 around the unit circle, cut open: one turn with half a twist.
std::shared_ptr<const PatchMap> moebius_map();

/// The middles of side^3 equal parts of the cube, the first direction fastest: where a solid is sampled.
Points cube_middles(std::size_t side);
std::shared_ptr<const SolidMap> cube_map();
/// The unit ball: u, v, w in [-1, 1], x = u sqrt(1 - v^2/2 - w^2/2 + v^2 w^2/3), y and z cyclically. Singular
/// at the edges of the cube.
std::shared_ptr<const SolidMap> ball_map();
/// The disk above, z in [-1, 1].
std::shared_ptr<const SolidMap> cylinder_map();
/// The disk above as section of a torus of radii 2 and 1: half a turn around the z-axis, from y = 0.
std::shared_ptr<const SolidMap> half_torus_map();

} // namespace GASPARD_API
