// Monitors on domains of any size and place. The figure of a built-in monitor is written for the unit square
// or the unit disk. On a domain with a box (Space::box) it is scaled and moved to that box:
//
//   m(x) = figure( (x - o) / s )
//
//   unit square: s = longest side of the box,        o + s (1/2, 1/2, 0) = middle of the box
//   unit disk:   s = half the longest side,          o = middle of the box
//
// Values, ranges and defaults of the rows are in the lengths of the domain: coordinates o + s v, lengths s v,
// and 1/length and 1/length^2 (by the unit of the row) v / s and v / s^2, with v the number for the figure.
#pragma once

#include "core/monitor/monitor.hpp"

namespace gaspard {

/// x = origin + scale v
struct Placement {
    Vec3 origin{};
    double scale = 1;
};
/// Where a figure lies in a space; the identity if the space has no box.
Placement placement_of(MonitorFigure figure, const Space& space);

/// MonitorType::rows for any space. Default centres lie at Space::middle where the figure has its middle.
std::vector<ParameterRow> rows_on(const MonitorType& type, const Space& space);
/// MonitorType::further_rows for values of such rows; empty if the type has none. Throws InputError.
std::vector<ParameterRow> further_rows_on(const MonitorType& type, const Values& values, const Space& space);
/// MonitorType::make for values of such rows. Throws InputError.
std::shared_ptr<const Monitor> make_on(const MonitorType& type, const Values& values,
                                       const MonitorContext& context);

/// The number that a value of `from` stands for, as a value of `to`, in whose range it is forced.
double transferred(const ParameterRow& from, const ParameterRow& to, double value);

} // namespace gaspard
