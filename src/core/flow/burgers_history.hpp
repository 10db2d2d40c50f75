// A solution of Burgers' equation of which any time can be asked for.
#pragma once

#include "core/flow/burgers.hpp"
#include "core/flow/checkpoints.hpp"

#include <memory>

namespace gaspard {

/// `at` returns the nodes x_0, ..., x_N, followed by the values u_0, ..., u_N. Throws InputError if an option
/// is out of its range.
std::shared_ptr<const Checkpoints> burgers_history(const BurgersOptions& options, const BurgersData& data);

} // namespace gaspard
