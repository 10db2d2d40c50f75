// Meshes on the sphere, moved by the exact map of an axisymmetric monitor; no solver is needed.
#pragma once

#include "core/session/snapshot.hpp"

#include <functional>

namespace gaspard {

/// Sides of k x k squares, or with `order` 1 the same without the nodes between the corners.
Mesh cubed_globe(int k, int order);
/// The icosahedron with every triangle cut into four `refinements` times.
Mesh icosahedral_globe(int refinements, int order);

/// The map that equidistributes m (a function of the angle to `pole`): each node is moved along its
/// meridian from s to t, where the integrals of m sin from 0 to t, and of sin from 0 to s, are equal parts of
/// those to pi (McRae, Cotter, Budd, Appendix A). Field "monitor" is m.
Snapshot adapted_globe(Mesh mesh, Vec3 pole, const std::function<double(double)>& m);

/// The Xn mesh of equation (5.10): centre 30 N, 0 E.
Snapshot xn_globe(Mesh mesh, double ratio);
/// An X2 mesh that is not quite the exact one, which the snapshot has too.
Snapshot beside_exact_globe(int k);
/// Two bands along great circles, one after the other.
Snapshot banded_globe(Mesh mesh);
/// Cells near the pole of an Xn mesh overlap, as after a step that was too long.
Snapshot tangled_globe(int k);

} // namespace gaspard
