// Preparing the values of a field before they are interpolated: the transform, and values that are missing.
#pragma once

#include "core/data/field_data.hpp"
#include "core/function/field_function.hpp"

#include <string>
#include <vector>

namespace gaspard {

/// Transforms the values, and replaces or removes those that are missing. Appends notes. Throws InputError if
/// values are missing and must not be.
void prepare_values(GridData& grid, const FieldOptions& options, std::vector<std::string>& notes);
void prepare_values(ScatteredData& data, const FieldOptions& options, std::vector<std::string>& notes);

} // namespace gaspard
