// The density of a field (monitor/field_monitor.hpp has the formula), of a file or computed, and the rows of
// its options.
#pragma once

#include "core/monitor/field_monitor.hpp"

#include <memory>
#include <string>
#include <vector>

namespace gaspard {

/// Density, contrast, invert, gamma, floor and blur.
std::vector<ParameterRow> field_density_rows();
/// The options of such rows, for a field that is read with these.
FieldMonitorOptions field_density_options(const Values& values, FieldOptions field);
/// As field_monitor; messages name the keys of a section.
std::shared_ptr<const Monitor> field_density(const FieldData& field, FieldMonitorOptions options,
                                             const DataContext& context, const std::string& section);

} // namespace gaspard
