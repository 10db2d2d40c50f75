// Monitors whose density is a function from a source (function/source.hpp):
//
//   m(x) = max( u(x), floor )
#pragma once

#include "core/function/source.hpp"
#include "core/monitor/monitor.hpp"

#include <memory>
#include <string>

namespace gaspard {

/// Words of such a monitor for its function.
struct DensityWords {
    std::string what;   ///< "the formula"
    std::string remedy; ///< what to change if u <= 0 somewhere: "set monitor.floor to a positive number"
};

/// m = max(u, floor); floor = 0: u itself. check() evaluates it at the nodes of the context's mesh, and
/// throws InputError with the point, as values() does, if m is not positive and finite. With
/// DataContext::within, m is asked for there alone, and a u >= 0 with zeros has the floor of 1 % of its mean,
/// which a note says.
std::shared_ptr<const Monitor> source_monitor(MadeFunction made, double floor, DensityWords words,
                                              const DataContext& context);

/// The row "floor".
ParameterRow floor_row();

} // namespace gaspard
