// A monitor of the caller's own as problem data. It is asked for points of the domain (monitor.hpp), what it
// returns is checked, and where it has no gradients they are differences of its values:
//
//   periodic square   0 <= x, y < 1, z = 0
//   walls             0 <= x, y <= 1, z = 0
//   sphere            |x| = R
//   patch             x = F(Psi), z = 0 in the plane; Psi may leave the parameter square slightly
#pragma once

#include "core/mesh/mesh.hpp"
#include "core/monitor/problem_data.hpp"

#include <span>
#include <stop_token>

namespace gaspard {

/// Where the points of a domain lie.
struct DomainExtent {
    Space space{};
    int dimension = 3;  ///< further coordinates are zero
    bool box = false;   ///< the domain is the box from `low` to `high`
    Vec3 low{}, high{}; ///< of the nodes of the mesh
    Vec3 somewhere{};   ///< a point of the domain
    double radius = 0;  ///< of a sphere; 0: that of each point
    double size = 1;    ///< largest side of that box; the radius of a sphere
};
/// `box`: a domain with straight sides, which its mesh fills.
DomainExtent extent_of(const Mesh& mesh, const Space& space, bool box);
/// Whether into() returns the same point; false where only into() can tell.
inline bool is_inside(const DomainExtent& extent, Vec3 p) {
    if (extent.space.kind == SpaceKind::periodic_square)
        return p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1 && p.z == 0;
    if (extent.space.kind == SpaceKind::sphere) return false;
    return (extent.dimension == 3 || p.z == 0) && (extent.dimension > 1 || p.y == 0) &&
           (!extent.box || (p.x >= extent.low.x && p.x <= extent.high.x && p.y >= extent.low.y &&
                            p.y <= extent.high.y && p.z >= extent.low.z && p.z <= extent.high.z));
}
/// The point of the domain for a point at which a method asks for the monitor.
Vec3 into(const DomainExtent& extent, Vec3 p);

/// Throws InputError with the first point at which the value is not positive or not finite.
void check_positive(const Points& x, std::span<const double> values);
/// grad m by central differences with a step of 1e-5 times the size of the domain, one-sided ones of the same
/// order at the sides of a box; on a sphere the tangential gradient. On a patch, which is no box, the points
/// may lie outside it and off a surface in space, by one step.
void difference_gradients(const Monitor& monitor, const DomainExtent& extent, const Points& x,
                          Points& gradients);

/// Checks the monitor (Monitor::check), and chooses ProblemData::unit from its values at some of the nodes.
/// Throws InputError; so do the values of the result.
ProblemData own_problem(std::shared_ptr<const Monitor> own, const DomainExtent& extent, const Points& nodes);
/// The same data with this token, and a monitor that throws Interrupted when asked to stop.
ProblemData stoppable(ProblemData data, std::stop_token stop);

} // namespace gaspard
