// Maps between convex domains that are known in closed form or by quadrature:
//
//   constant densities, ellipses      x = c' + A (xi - c), A from the second moments (curve_integral.hpp)
//   densities that depend on the      x = c' + phi(r) (xi - c) / r,
//   distance r from the centre, disks
//     integral of sigma s ds from 0 to phi(r)  =  theta integral of rho s ds from 0 to r
#pragma once

#include "core/monitor/monitor.hpp"
#include "core/transport/convex_curve.hpp"
#include "core/transport/transport_form.hpp"

#include <functional>
#include <optional>

namespace gaspard {

/// The map, or nullopt if it is not known. Densities are looked at in 10,000 places: they are constant or
/// radial if they are so there, to a relative 1e-9. Masses within circles are known to 1e-10 of the whole.
std::optional<std::function<Vec3(Vec3)>> exact_transport(const ConvexCurve& source, const ConvexCurve& target,
                                                         const TransportDensities& densities);

} // namespace gaspard
