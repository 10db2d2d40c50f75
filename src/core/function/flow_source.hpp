// Quasi-geostrophic flow (flow/quasi_geostrophic.hpp) as a function on the periodic plane: q at time t, the
// values at the nodes of its projection.
#pragma once

#include "core/data/field_data.hpp"
#include "core/function/source.hpp"

#include <vector>

namespace gaspard {

std::vector<ParameterRow> flow_rows(const Space& space);
/// Those of the start.
std::vector<ParameterRow> further_flow_rows(const Values& values, const Space& space);

/// q on the flow's own grid. The context's files keep states of the flow, so that other times of the same
/// flow begin where one is near. Throws InputError, and Interrupted if asked to stop.
FieldData flow_field(const Values& values, const DataContext& context);

} // namespace gaspard
