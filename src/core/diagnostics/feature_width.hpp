// Whether a mesh can carry the features of a monitor: how much of the monitor's range lies within one cell,
//
//   log(max m / min m at the corners) / log(max m / min m at all nodes),
//
// of which the value is taken that one cell in a hundred exceeds.
// Near 1, m rises from its lowest to its highest value between neighbouring nodes: the feature is narrower
// than the cells, the discrete problem hardly knows it, and where the iteration ends may depend on where it
// began.
#pragma once

#include "core/mesh/mesh.hpp"

#include <span>

namespace gaspard {

/// `m` > 0 at the nodes of the mesh. 0 if m is the same everywhere, up to one per cent.
double share_within_cell(const Mesh& mesh, std::span<const double> m);

} // namespace gaspard
