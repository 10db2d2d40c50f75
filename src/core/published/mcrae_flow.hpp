// The flow of McRae, Cotter, Budd, section 5.1.3 and figure 4: Fr = 1, on 100 x 100 squares, each cut into
// two triangles, from noise on the grid at time 0 to time 500. The state at its end, projected to continuous
// functions, is assets/fields/flow-vortices.nc, which bench/flow.cpp writes.
#pragma once

#include "core/flow/quasi_geostrophic.hpp"

#include <cstdint>

namespace gaspard {

struct VortexFlow {
    std::size_t cells = 100;
    std::uint64_t seed = 1; ///< of the noise; the paper states none
    double step = 0.1;      ///< the paper states none
    int steps = 5000;       ///< to time 500
};

/// The flow at time 0.
QuasiGeostrophicFlow vortex_flow(const VortexFlow& which = {});

} // namespace gaspard
