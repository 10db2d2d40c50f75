// A quasi-geostrophic flow of which any time can be asked for.
#pragma once

#include "core/flow/checkpoints.hpp"
#include "core/flow/flow_options.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace gaspard {

/// Memory for the states of a flow: 137 of them for 100 cells per side.
inline constexpr std::size_t flow_budget = std::size_t{64} << 20;

/// The flow from the continuous function with these values at n x n nodes; `at` returns the values of q's
/// projection there (QuasiGeostrophicFlow::project). With the Froude number 0 the mean of q is taken away
/// before. The interval is that of ten steps at the start, but at most 1. Throws InputError if an option is
/// out of its range.
std::shared_ptr<const Checkpoints> flow_history(const FlowOptions& options, std::vector<double> nodal,
                                                std::size_t budget = flow_budget);

} // namespace gaspard
